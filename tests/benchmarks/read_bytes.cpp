// SPDX-License-Identifier: BSD-3-Clause
#include "read_bytes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "read_bytes.cpp"
#include <hwy/foreach_target.h>
// After it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

std::uint64_t read_bytes(const std::uint8_t* bytes, std::size_t size) {
  const hn::ScalableTag<std::uint64_t> words;
  const std::size_t step = hn::Lanes(words) * sizeof(std::uint64_t);
  auto a = hn::Zero(words), b = a, c = a, d = a;
  const auto load = [&](std::size_t at)
                        HWY_ATTR { return hn::LoadU(words, reinterpret_cast<const std::uint64_t*>(bytes + at)); };
  std::size_t at = 0;
  for (; at + 4 * step <= size; at += 4 * step) {
    a = hn::Or(a, load(at));
    b = hn::Or(b, load(at + step));
    c = hn::Or(c, load(at + 2 * step));
    d = hn::Or(d, load(at + 3 * step));
  }
  for (; at + step <= size; at += step) a = hn::Or(a, load(at));
  return hn::GetLane(hn::MaxOfLanes(words, hn::Or(hn::Or(a, b), hn::Or(c, d))));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace safety_control_cloud {

HWY_EXPORT(read_bytes);

std::uint64_t read_bytes(const std::uint8_t* bytes, std::size_t size) {
  return HWY_DYNAMIC_DISPATCH(read_bytes)(bytes, size);
}

}  // namespace safety_control_cloud
#endif
