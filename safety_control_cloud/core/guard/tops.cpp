// SPDX-License-Identifier: BSD-3-Clause
#include "tops.hpp"

#include <algorithm>
#include <limits>

#include "cell_key.hpp"

namespace safety_control_cloud {
namespace {

constexpr double column = 0.02;  ///< [m] across: in the next one, too, the same thing stands, seen higher up

std::uint64_t column_of(const Point2& place) { return key_of_cell(place, column, 0.0, column); }

}  // namespace

Tops::Tops(const std::vector<NearReturn>& all) {
  for (const NearReturn& one : all) {
    float& top = of_column_.try_emplace(column_of(one.place), one.height).first->second;
    top = std::max(top, one.height);
  }
}

float Tops::around(const NearReturn& one) {
  const auto [found, is_new] = around_.try_emplace(column_of(one.place), one.height);
  if (is_new) found->second = highest_around(one.place);
  return found->second;
}

float Tops::highest_around(const Point2& place) const {
  float top = -std::numeric_limits<float>::infinity();
  for (const double ahead : {-column, 0.0, column}) {
    for (const double left : {-column, 0.0, column}) {
      const auto found = of_column_.find(column_of(place + Point2{ahead, left}));
      if (found != of_column_.end()) top = std::max(top, found->second);
    }
  }
  return top;
}

}  // namespace safety_control_cloud
