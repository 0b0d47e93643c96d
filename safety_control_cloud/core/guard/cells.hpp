// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

  /// A return that it holds.
  void add(float x, float y);
  void clear();

  /// One point for each cell: the middle of its returns, with how far the farthest of all lies from its own. Into what
  /// another look has left behind.
  void write(Obstacles& obstacles) const;

 private:
  struct Box {
    float x_min, x_max, y_min, y_max;
    std::uint32_t count = 0;
  };

  float extent_, per_metre_;
  std::size_t side_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> used_;  ///< of the boxes
};

}  // namespace safety_control_cloud
