// SPDX-License-Identifier: BSD-3-Clause
#include "extents.hpp"

#include <algorithm>

#include "cell_key.hpp"

namespace safety_control_cloud {
namespace {

constexpr double column = 0.02;  ///< [m] across: in the next one, too, the same thing stands, seen higher up

std::uint64_t column_of(const Point2& place) { return key_of_cell(place, column, 0.0, column); }

Heights at(float height) { return {height, height}; }

Heights both(const Heights& a, const Heights& b) { return {std::min(a.bottom, b.bottom), std::max(a.top, b.top)}; }

}  // namespace

Extents::Extents(const std::vector<NearReturn>& all) {
  for (const NearReturn& one : all) {
    Heights& heights = of_column_.try_emplace(column_of(one.place), at(one.height)).first->second;
    heights = both(heights, at(one.height));
  }
}

Heights Extents::around(const NearReturn& one) {
  const auto [found, is_new] = around_.try_emplace(column_of(one.place), at(one.height));
  if (is_new) found->second = all_around(one);
  return found->second;
}

Heights Extents::all_around(const NearReturn& one) const {
  Heights heights = at(one.height);
  for (const double ahead : {-column, 0.0, column}) {
    for (const double left : {-column, 0.0, column}) {
      const auto found = of_column_.find(column_of(one.place + Point2{ahead, left}));
      if (found != of_column_.end()) heights = both(heights, found->second);
    }
  }
  return heights;
}

}  // namespace safety_control_cloud
