// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "../../safety_control_cloud/core/look/placement.hpp"
#include "scene.hpp"

namespace safety_control_cloud {

/// How a camera is mounted, and sends its pixels.
struct Roll {
  int quarters = 0;  ///< to the right, as who stands behind it has it
  bool columns_from_right = false, rows_from_below = false;
};

inline std::vector<Roll> all_rolls() {
  std::vector<Roll> rolls;
  for (const int quarters : {0, 1, 2, 3}) {
    for (const bool columns : {false, true})
      for (const bool rows : {false, true}) rolls.push_back({quarters, columns, rows});
  }
  return rolls;
}

/// The picture of an upright camera, as one sends it that is rolled so.
class RolledPicture {
 public:
  RolledPicture(const CloudView& upright, const Roll& roll) : roll_(roll), width_(upright.width) {
    const auto* points = reinterpret_cast<const Xyz*>(upright.bytes);
    height_ = upright.height;
    for (std::size_t i = 0; i < upright.size(); ++i) at(i / upright.width, i % upright.width) = rolled(points[i]);
  }

  CloudView view() const {
    CloudView view = view_of(points_);
    view.width = lies() ? height_ : width_, view.height = lies() ? width_ : height_;
    view.row_step = view.width * sizeof(Xyz);
    return view;
  }

 private:
  bool lies() const { return roll_.quarters % 2 == 1; }

  Xyz rolled(const Xyz& p) const {
    switch (roll_.quarters) {
      case 1:
        return {p.y, -p.x, p.z};
      case 2:
        return {-p.x, -p.y, p.z};
      case 3:
        return {-p.y, p.x, p.z};
      default:
        return p;
    }
  }

  /// Where it sends what an upright camera sees in this row and column.
  Xyz& at(std::size_t row, std::size_t column) {
    points_.resize(width_ * height_);
    const std::size_t up = height_ - 1 - row, left = width_ - 1 - column;
    std::size_t r = row, c = column, width = width_, height = height_;
    if (lies()) std::swap(width, height);
    if (roll_.quarters == 1) r = left, c = row;
    if (roll_.quarters == 2) r = up, c = left;
    if (roll_.quarters == 3) r = column, c = up;
    if (roll_.rows_from_below) r = height - 1 - r;
    if (roll_.columns_from_right) c = width - 1 - c;
    return points_[r * width + c];
  }

  Roll roll_;
  std::size_t width_, height_ = 0;
  std::vector<Xyz> points_;
};

/// The place of a camera that is rolled so, where an upright one has this.
inline Placement rolled(Placement placement, const Roll& roll) {
  for (auto& [x, y, z, w] : placement.rows) {
    for (int i = 0; i < roll.quarters; ++i) x = std::exchange(y, -x);
  }
  return placement;
}

}  // namespace safety_control_cloud
