// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../path/obstacles.hpp"

namespace safety_control_cloud {

/// reduced() of returns that come one by one, within a square around base_frame's origin: what it holds it has held
/// since it was made, so that filling it allocates nothing.
class Cells {
 public:
  /// `extent` [m] from the origin to each side, `cell` [m] wide.
  Cells(double extent, double cell);

  double extent() const { return double{extent_}; }
  bool holds(float x, float y) const { return x > -extent_ && x < extent_ && y > -extent_ && y < extent_; }

  /// A return that it holds. Here because it is called for each of a cloud.
  void add(float x, float y) {
    const auto column = static_cast<std::int32_t>((x + extent_) * per_metre_);
    const auto row = static_cast<std::int32_t>((y + extent_) * per_metre_);
    const auto index = static_cast<std::uint32_t>(std::min(row, side_ - 1) * side_ + std::min(column, side_ - 1));
    Box& box = boxes_[index];
    if (box.count++ == 0) return begin(box, index, x, y);
    box.x_min = std::min(box.x_min, x), box.x_max = std::max(box.x_max, x);
    box.y_min = std::min(box.y_min, y), box.y_max = std::max(box.y_max, y);
  }
  void clear();

  /// One point for each cell: the middle of its returns, with how far the farthest of all lies from its own. Into what
  /// another look has left behind.
  void write(Obstacles& obstacles) const;

 private:
  struct Box {
    float x_min, x_max, y_min, y_max;
    std::uint32_t count = 0;
  };

  /// The first return of a box.
  void begin(Box& box, std::uint32_t index, float x, float y);

  float extent_, per_metre_;
  std::int32_t side_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> used_;  ///< of the boxes
};

}  // namespace safety_control_cloud
