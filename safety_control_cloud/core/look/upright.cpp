// SPDX-License-Identifier: BSD-3-Clause
#include "upright.hpp"

#include <cstddef>

#include "../input/point_reader.hpp"
#include "ray_lines.hpp"

namespace safety_control_cloud {
namespace {

constexpr double least = 0.1;    ///< cosine: of a camera that looks straight up or down no axis points down
constexpr double clearly = 1.2;  ///< times as much: who is rolled by half a quarter does not turn to and fro

View view_of(const std::vector<std::array<float, 3>>& points, std::size_t width, std::size_t height) {
  constexpr std::size_t step = sizeof(points[0]);
  CloudView cloud;
  cloud.bytes = reinterpret_cast<const std::uint8_t*>(points.data());
  cloud.width = width, cloud.height = height;
  cloud.point_step = step, cloud.row_step = step * width;
  cloud.offset = {0, sizeof(float), 2 * sizeof(float)};
  return cloud;
}

}  // namespace

double Upright::cosine(Down down, const Placement& placement) {
  const auto& [x, y, z, w] = placement.rows[1];
  switch (down) {
    case Down::Y:
      return y;
    case Down::MinusY:
      return -y;
    case Down::X:
      return x;
    case Down::MinusX:
      break;
  }
  return -x;
}

void Upright::note_down(const Placement& placement) {
  Down best = down_;
  for (const Down down : {Down::Y, Down::MinusY, Down::X, Down::MinusX})
    if (cosine(down, placement) > cosine(best, placement)) best = down;
  const double best_cosine = cosine(best, placement);
  if (best_cosine > least && best_cosine > clearly * cosine(down_, placement)) down_ = best;
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
  note_down(*outlook.placement);
  note_order(view);
  if (down_ == Down::Y && !columns_fall_ && !rows_fall_) return {view, outlook};
  is_turned_ = true;
  return {copied(view), turned(outlook)};
}

/// Upright, a point (x, y, z) is (x, y, z), (-x, -y, z), (-y, x, z) or (y, -x, z): turned about the axis along which
/// the camera looks.
Outlook Upright::turned(const Outlook& outlook) const {
  if (!is_turned_ || !outlook.placement) return outlook;
  Placement placement = *outlook.placement;
  for (auto& [x, y, z, w] : placement.rows) {
    const float along_x = x, along_y = y;
    switch (down_) {
      case Down::Y:
        break;
      case Down::MinusY:
        x = -along_x, y = -along_y;
        break;
      case Down::X:
        x = -along_y, y = along_x;
        break;
      case Down::MinusX:
        x = along_y, y = -along_x;
        break;
    }
  }
  return Outlook(outlook.corridor, placement);
}

View Upright::copied(const View& view) {
  const bool lies = down_ == Down::X || down_ == Down::MinusX;
  const std::size_t columns = width_of(view), rows = height_of(view);
  const std::size_t width = lies ? rows : columns, height = lies ? columns : rows;
  const bool from_right = columns_fall_ != (down_ == Down::MinusY || down_ == Down::MinusX);
  const bool from_below = rows_fall_ != (down_ == Down::MinusY || down_ == Down::X);
  points_.resize(columns * rows);
  with_reader(view, [&](const auto& reader) {
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const std::size_t row = from_below ? rows - 1 - i : i, column = from_right ? columns - 1 - j : j;
        std::array<float, 3>& point = points_[lies ? column * width + row : row * width + column];
        const auto take = [&](float x, float y, float z) {
          switch (down_) {
            case Down::Y:
              point = {x, y, z};
              break;
            case Down::MinusY:
              point = {-x, -y, z};
              break;
            case Down::X:
              point = {-y, x, z};
              break;
            case Down::MinusX:
              point = {y, -x, z};
              break;
          }
        };
        reader(i, j, take);
      }
    }
  });
  return view_of(points_, width, height);
}

}  // namespace safety_control_cloud
