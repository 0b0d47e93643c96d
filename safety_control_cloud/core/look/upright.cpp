// SPDX-License-Identifier: BSD-3-Clause
#include "upright.hpp"

#include <cstddef>

#include "../input/point_reader.hpp"
#include "ray_lines.hpp"

namespace safety_control_cloud {
namespace {

constexpr double least = 0.1;    ///< cosine: of a camera that looks straight up or down no axis points down
constexpr double clearly = 1.2;  ///< times as much: who is rolled by half a quarter does not turn to and fro

}  // namespace

void Upright::note_roll(const Placement& placement) {
  const auto& [x, y, z, place] = placement.rows[1];
  const auto downward = [x = x, y = y](const Roll& roll) { return double{roll.down(x, y)}; };
  Roll best = roll_;
  for (const Roll& roll : {Roll{1, 0}, Roll{-1, 0}, Roll{0, -1}, Roll{0, 1}})
    if (downward(roll) > downward(best)) best = roll;
  if (downward(best) > least && downward(best) > clearly * downward(roll_)) roll_ = best;
}

/// What shows too little to tell is in the order of the one before.
void Upright::note_order(const View& view) {
  const RayLines lines = ray_lines_of(view);
  if (lines.across) columns_fall_ = lines.across->slope < 0.0;
  if (lines.down) rows_fall_ = lines.down->slope < 0.0;
}

Upright::Picture Upright::of(const View& view, const Outlook& outlook) {
  is_turned_ = false;
  if (!outlook.placement || width_of(view) < 2 || height_of(view) < 2) return {view, outlook};
  note_roll(*outlook.placement);
  note_order(view);
  if (roll_.cosine == 1.0f && !columns_fall_ && !rows_fall_) return {view, outlook};
  is_turned_ = true;
  return {copied(view), turned(outlook)};
}

Outlook Upright::turned(const Outlook& outlook) const {
  if (!is_turned_ || !outlook.placement) return outlook;
  Placement placement = *outlook.placement;
  for (auto& [x, y, z, place] : placement.rows) {
    const float right = roll_.right(x, y), down = roll_.down(x, y);
    x = right, y = down;
  }
  return Outlook(outlook.corridor, placement);
}

View Upright::copied(const View& view) {
  const std::size_t columns = width_of(view), rows = height_of(view), width = roll_.lies() ? rows : columns;
  const auto falls = [this](float x, float y) {
    return roll_.right(x, y) + roll_.down(x, y) < 0.0f;
  };  // one of them is 0
  const bool from_right = columns_fall_ != falls(1.0f, 0.0f), from_below = rows_fall_ != falls(0.0f, 1.0f);
  points_.resize(columns * rows);
  with_reader(view, [&](const auto& reader) {
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const std::size_t row = from_below ? rows - 1 - i : i, column = from_right ? columns - 1 - j : j;
        std::array<float, 3>& point = points_[roll_.lies() ? column * width + row : row * width + column];
        const auto take = [&](float x, float y, float z) { point = {roll_.right(x, y), roll_.down(x, y), z}; };
        reader(i, j, take);
      }
    }
  });
  return in_rows(points_, width);
}

}  // namespace safety_control_cloud
