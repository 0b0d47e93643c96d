// SPDX-License-Identifier: BSD-3-Clause
#include "cut_off.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "near_ground.hpp"

namespace safety_control_cloud {
namespace {

/// Of a picture's rows, so large a share apart they are compared.
constexpr std::size_t rows_to_compare = 60;

/// The lowest row in which anything returns, one to compare it with above, and by how much more must lie there, as a
/// share, what recedes.
struct Border {
  std::size_t row, step;
  double down;  ///< [px] below the row that looks level

  explicit Border(const Pixels& picture)
      : row(picture.height() - 1 - picture.framing().bottom),
        step(std::max<std::size_t>(1, picture.height() / rows_to_compare)),
        down(static_cast<double>(row) - picture.framing().middle_row) {}

  bool tells() const { return row >= 2 * step && down > 2.0 * static_cast<double>(step); }
  bool recedes(double nearer, double farther) const {
    return farther > nearer * (1.0 + 0.5 * static_cast<double>(step) / down);
  }
};

}  // namespace

bool recedes_at_the_bottom(const Pixels& picture, const std::vector<float>& nearest_in_row) {
  const Border border(picture);
  if (!border.tells() || nearest_in_row.empty()) return false;
  const auto recedes = [&](std::size_t from) {
    return border.recedes(nearest_in_row[from], nearest_in_row[from - border.step]);
  };
  return recedes(border.row) && recedes(border.row - border.step) &&
         !std::isinf(nearest_in_row[border.row - 2 * border.step]);
}

std::vector<Point> ends_at_the_bottom(const Pixels& picture, const Outlook& outlook) {
  std::vector<Point> ends;
  const Border border(picture);
  if (!border.tells()) return ends;
  const std::size_t apart = NearGround::column_step_of(picture.width());
  for (std::size_t column = 0; column < picture.width(); column += apart) {
    const Point end = picture.at(border.row, column), above = picture.at(border.row - border.step, column);
    if (!returned(end) || !returned(above)) continue;
    const Point here = placed(end, outlook);
    if (outlook.corridor.holds(here) && border.recedes(here.z, placed(above, outlook).z)) ends.push_back(end);
  }
  return ends;
}

}  // namespace safety_control_cloud
