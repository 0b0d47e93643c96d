// SPDX-License-Identifier: BSD-3-Clause
#include "frozen.hpp"

#include <functional>
#include <string_view>

namespace safety_control_cloud {
namespace {

/// Of the points alone: what pads a row may hold anything.
template <class Points>
std::size_t hash_of(const Points& points) {
  std::size_t hash = points.size();
  for (std::size_t row = 0; row < points.height; ++row) {
    const auto* bytes = reinterpret_cast<const char*>(points.bytes + row * points.row_step);
    hash = hash * 31 + std::hash<std::string_view>{}(std::string_view(bytes, points.width * step_of(points)));
  }
  return hash;
}

}  // namespace

std::size_t FrozenWatch::count(const View& view, double stamp) {
  const std::size_t content = std::visit([](const auto& points) { return hash_of(points); }, view);
  if (content != content_) same_ = 0;
  if (same_ == 0 || stamp != stamp_) ++same_;
  content_ = content;
  stamp_ = stamp;
  return same_;
}

}  // namespace safety_control_cloud
