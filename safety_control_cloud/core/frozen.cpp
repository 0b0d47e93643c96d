// SPDX-License-Identifier: BSD-3-Clause
#include "frozen.hpp"

#include <functional>
#include <string_view>

namespace safety_control_cloud {
namespace {

/// Of the points alone: what pads a row may hold anything.
std::size_t hash_of(const CloudView& cloud) {
  std::size_t hash = cloud.size();
  for (std::size_t row = 0; row < cloud.height; ++row) {
    const auto* bytes = reinterpret_cast<const char*>(cloud.bytes + row * cloud.row_step);
    hash = hash * 31 + std::hash<std::string_view>{}(std::string_view(bytes, cloud.width * cloud.point_step));
  }
  return hash;
}

}  // namespace

std::size_t FrozenWatch::count(const CloudView& cloud, double stamp) {
  const std::size_t content = hash_of(cloud);
  if (content != content_) same_ = 0;
  if (same_ == 0 || stamp != stamp_) ++same_;
  content_ = content;
  stamp_ = stamp;
  return same_;
}

}  // namespace safety_control_cloud
