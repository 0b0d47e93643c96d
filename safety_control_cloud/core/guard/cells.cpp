// SPDX-License-Identifier: BSD-3-Clause
#include "cells.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {

Cells::Cells(double extent, double cell)
    : extent_(static_cast<float>(extent)),
      per_metre_(static_cast<float>(1.0 / cell)),
      side_(static_cast<std::size_t>(std::ceil(2.0 * extent / cell)) + 1),
      boxes_(side_ * side_) {
  used_.reserve(boxes_.size());
}

void Cells::add(float x, float y) {
  const auto column = static_cast<std::size_t>((x + extent_) * per_metre_);
  const auto row = static_cast<std::size_t>((y + extent_) * per_metre_);
  const std::size_t index = std::min(row, side_ - 1) * side_ + std::min(column, side_ - 1);
  Box& box = boxes_[index];
  if (box.count++ == 0) {
    box = {x, x, y, y, 1};
    used_.push_back(static_cast<std::uint32_t>(index));
    return;
  }
  box.x_min = std::min(box.x_min, x), box.x_max = std::max(box.x_max, x);
  box.y_min = std::min(box.y_min, y), box.y_max = std::max(box.y_max, y);
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
