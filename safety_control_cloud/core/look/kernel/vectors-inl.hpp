// SPDX-License-Identifier: BSD-3-Clause
// The vectors that all of the kernel speaks of; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_VECTORS_INL
#undef SAFETY_CONTROL_CLOUD_VECTORS_INL
#else
#define SAFETY_CONTROL_CLOUD_VECTORS_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "lane_orders.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Bytes = hn::Repartition<std::uint8_t, Floats>;
using Signed = hn::RebindToSigned<Floats>;
using Integers = hn::RebindToUnsigned<Floats>;

using Float = hn::Vec<Floats>;
using Integer = hn::Vec<Integers>;
using Mask = hn::Mask<Floats>;

constexpr std::size_t lanes = hn::MaxLanes(Floats());
constexpr float infinity = std::numeric_limits<float>::infinity();

HWY_INLINE Float all(float value) { return hn::Set(Floats(), value); }
HWY_INLINE Integer all_of(std::uint32_t value) { return hn::Set(Integers(), value); }

/// Of some lanes those where a < b, and where a <= b: AVX-512 asks for both in the instruction that compares.
#if HWY_TARGET <= HWY_AVX3
HWY_INLINE Mask those_less(Mask some, Float a, Float b) {
  return Mask{_mm512_mask_cmp_ps_mask(some.raw, a.raw, b.raw, _CMP_LT_OQ)};
}
HWY_INLINE Mask those_at_most(Mask some, Float a, Float b) {
  return Mask{_mm512_mask_cmp_ps_mask(some.raw, a.raw, b.raw, _CMP_LE_OQ)};
}
#else
HWY_INLINE Mask those_less(Mask some, Float a, Float b) { return hn::And(some, hn::Lt(a, b)); }
HWY_INLINE Mask those_at_most(Mask some, Float a, Float b) { return hn::And(some, hn::Le(a, b)); }
#endif
HWY_INLINE Mask is_within(Float value, Float least, Float most) {
  return those_at_most(hn::Ge(value, least), value, most);
}

/// The lesser of two numbers; of NaN in `value`, the other one. Min() says so on some machines only.
HWY_INLINE Float lesser(Float value, Float other) {
#if HWY_ARCH_X86
  return hn::Min(value, other);
#else
  return hn::IfThenElse(hn::Lt(value, other), value, other);
#endif
}

/// The lanes whose mask is set, of any vector. Highway's CompressStore writes them too, in one instruction of AVX-512
/// for which AMD's Zen 4 takes a hundred cycles, and two for the one that leaves the vector in a register. In AVX2 its
/// Compress keeps the orders of the lanes in an array of its own, of which GCC makes a copy for each vector.
class Chosen {
 public:
#if HWY_TARGET == HWY_AVX2
  explicit HWY_INLINE Chosen(Mask mask)
      : mask_(static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(bits_of(mask))))),
        order_(_mm256_srlv_epi32(_mm256_set1_epi32(static_cast<int>(lane_orders[mask_])),
                                 _mm256_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28))) {}

  template <class Vector, class Lane>
  HWY_INLINE void write(Vector vector, Lane* to) const {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(bits_of(vector), order_));
  }
  HWY_INLINE std::size_t size() const { return static_cast<std::size_t>(__builtin_popcount(mask_)); }

 private:
  template <class Vector>
  static HWY_INLINE __m256i bits_of(Vector vector) {
    __m256i bits;
    static_assert(sizeof(vector) == sizeof(bits));
    std::memcpy(&bits, &vector, sizeof(bits));
    return bits;
  }

  unsigned mask_;
  __m256i order_;
#else
  explicit HWY_INLINE Chosen(Mask mask) : mask_(mask) {}

  /// One behind the other, and behind them whatever.
  template <class Vector, class Lane>
  HWY_INLINE void write(Vector vector, Lane* to) const {
    const hn::ScalableTag<Lane> tag;
    hn::StoreU(hn::Compress(vector, hn::RebindMask(tag, mask_)), tag, to);
  }
  HWY_INLINE std::size_t size() const { return hn::CountTrue(Floats(), mask_); }

 private:
  Mask mask_;
#endif
};

/// As many successive points as a vector has lanes.
struct Points {
  Float x, y, z;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
