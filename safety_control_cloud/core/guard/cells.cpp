// SPDX-License-Identifier: BSD-3-Clause
#include "cells.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {

Cells::Cells(double extent, double cell)
    : extent_(static_cast<float>(extent)),
      per_metre_(static_cast<float>(1.0 / cell)),
      side_(static_cast<std::int32_t>(std::ceil(2.0 * extent / cell)) + 1),
      boxes_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {
  used_.reserve(boxes_.size());
}

void Cells::begin(Box& box, std::uint32_t index, float x, float y) {
  box = {x, x, y, y, 1};
  used_.push_back(index);
}

void Cells::clear() {
  for (const std::uint32_t index : used_) boxes_[index].count = 0;
  used_.clear();
}

void Cells::write(Obstacles& obstacles) const {
  obstacles.points.clear();
  obstacles.counts.clear();
  obstacles.widening = 0.0;
  for (const std::uint32_t index : used_) {
    const Box& box = boxes_[index];
    const Point2 least{box.x_min, box.y_min}, most{box.x_max, box.y_max};
    obstacles.points.push_back(0.5 * (least + most));
    obstacles.counts.push_back(box.count);
    obstacles.widening = std::max(obstacles.widening, 0.5 * length_of(most - least));
  }
}

}  // namespace safety_control_cloud
