// SPDX-License-Identifier: BSD-3-Clause
// Vectors of pixels' codes, and counting in vectors; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_SCAN_TALLY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_SCAN_TALLY_INL
#undef SAFETY_CONTROL_CLOUD_SCAN_TALLY_INL
#else
#define SAFETY_CONTROL_CLOUD_SCAN_TALLY_INL
#endif

#include <cstddef>
#include <cstdint>

#include "found-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
using Codes = hn::Rebind<std::uint16_t, Floats>;
#else
using Codes = hn::Repartition<std::uint16_t, Floats>;
#endif
using Code = hn::Vec<Codes>;
using SignedCodes = hn::RebindToSigned<Codes>;

constexpr std::size_t codes = hn::MaxLanes(Codes());

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Code codes_of(hn::Vec<Signed> seen, hn::Vec<Signed>) {
  return hn::TruncateTo(Codes(), hn::BitCast(Integers(), seen));
}
HWY_INLINE std::size_t sum_of(Code all) { return hn::GetLane(all); }
HWY_INLINE std::uint16_t least_of(Code all) { return hn::GetLane(all); }
#else
#if HWY_TARGET <= HWY_AVX2
/// From blocks with the first half from one vector and the second from another to the one behind the other.
HWY_INLINE Code in_order(Code blocks) {
  HWY_ALIGN std::uint32_t order[lanes];
  for (std::uint32_t i = 0; i < lanes; ++i) order[i] = i % (lanes / 2) / 2 * 4 + i / (lanes / 2) * 2 + i % 2;
  const auto indices = hn::SetTableIndices(Integers(), order);
  return hn::BitCast(Codes(), hn::TableLookupLanes(hn::BitCast(Integers(), blocks), indices));
}
#endif

/// Two vectors as one.
HWY_INLINE Code codes_of(hn::Vec<Signed> first, hn::Vec<Signed> second) {
  const Code code = hn::BitCast(Codes(), hn::ReorderDemote2To(SignedCodes(), first, second));
#if HWY_TARGET <= HWY_AVX2
  return in_order(code);
#else
  return code;
#endif
}

/// Highway 1.0 cannot reduce all vectors of 16 bits.
HWY_INLINE Integer even(Code all) { return hn::And(hn::BitCast(Integers(), all), all_of(0xFFFF)); }
HWY_INLINE Integer odd(Code all) { return hn::ShiftRight<16>(hn::BitCast(Integers(), all)); }
HWY_INLINE std::size_t sum_of(Code all) {
  return hn::GetLane(hn::SumOfLanes(Integers(), hn::Add(even(all), odd(all))));
}
HWY_INLINE std::uint16_t least_of(Code all) {
  return static_cast<std::uint16_t>(hn::GetLane(hn::MinOfLanes(Integers(), hn::Min(even(all), odd(all)))));
}
#endif

HWY_INLINE std::size_t sum_of(Integer all) { return hn::GetLane(hn::SumOfLanes(Integers(), all)); }

/// How many lanes were set in all masks.
template <class Tag>
class Tally {
 public:
  HWY_INLINE Tally() : count_(hn::Zero(Tag())) {}

  HWY_INLINE void add(hn::Mask<Tag> mask) {
#if HWY_TARGET <= HWY_AVX3  // masks have registers of their own
    count_ = hn::IfThenElse(mask, hn::Add(count_, hn::Set(Tag(), 1)), count_);
#else  // a set lane is all ones, which is -1
    count_ = hn::Sub(count_, hn::VecFromMask(Tag(), mask));
#endif
  }
  HWY_INLINE std::size_t total() const { return sum_of(count_); }

 private:
  hn::Vec<Tag> count_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
