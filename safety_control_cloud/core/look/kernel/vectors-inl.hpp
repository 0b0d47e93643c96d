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
#include <limits>

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

/// Writes the lanes whose mask is set one behind the other, and behind them whatever; returns how many they are.
/// Highway's CompressStore does too, in one instruction of AVX-512 that writes to memory: AMD's Zen 4 takes a hundred
/// cycles for it, and two for the one that leaves the vector in a register.
template <class V, class M, class Tag, class Lane>
HWY_INLINE std::size_t list_lanes(V vector, M mask, Tag tag, Lane* to) {
  hn::StoreU(hn::Compress(vector, mask), tag, to);
  return hn::CountTrue(tag, mask);
}

/// As many successive points as a vector has lanes.
struct Points {
  Float x, y, z;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
