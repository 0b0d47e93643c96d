// SPDX-License-Identifier: BSD-3-Clause
// Counting in vectors; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_TALLY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_TALLY_INL
#undef SAFETY_CONTROL_CLOUD_TALLY_INL
#else
#define SAFETY_CONTROL_CLOUD_TALLY_INL
#endif

#include <cstddef>

#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

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
