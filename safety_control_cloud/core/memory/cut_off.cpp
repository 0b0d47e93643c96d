// SPDX-License-Identifier: BSD-3-Clause
#include "cut_off.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace safety_control_cloud {
namespace {

/// Of a picture's rows, so large a share apart they are compared.
constexpr std::size_t rows_to_compare = 60;

}  // namespace

bool recedes_at_the_bottom(const Pixels& picture, const std::vector<float>& nearest_in_row) {
  const std::size_t border = picture.height() - 1 - picture.framing().bottom;
  const std::size_t step = std::max<std::size_t>(1, picture.height() / rows_to_compare);
  const double down = static_cast<double>(border) - picture.framing().middle_row;
  if (border < 2 * step || down <= 2.0 * static_cast<double>(step) || nearest_in_row.empty()) return false;
  const auto recedes = [&](std::size_t from) {
    const double nearer = double{nearest_in_row[from]}, farther = double{nearest_in_row[from - step]};
    return farther > nearer * (1.0 + 0.5 * static_cast<double>(step) / down);
  };
  return recedes(border) && recedes(border - step) && !std::isinf(nearest_in_row[border - 2 * step]);
}

}  // namespace safety_control_cloud
