// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "looking_robot.hpp"

namespace safety_control_cloud {

struct Block {
  std::size_t from, to;    ///< columns
  std::size_t top, below;  ///< rows
  float z;                 ///< [m]; NaN: too near to return
};

constexpr std::size_t width = 320, height = 240;  ///< of its picture

/// What a camera sees of a hall, or of a wall at this distance, and of the floor, and of what is before that.
class Hall {
 public:
  explicit Hall(const std::vector<Block>& blocks = {}, float wall = inf) : points_(width * height) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const std::size_t row = i / width, column = i % width;
      const float down = (static_cast<float>(row) - 119.5f) / focal;
      float z = std::min(wall, down > 0.0f ? floor_y / down : inf);
      for (const Block& block : blocks) {
        if (column >= block.from && column < block.to && row >= block.top && row < block.below) z = block.z;
      }
      set(i, z < 5.0f ? z : nan);
    }
  }

  /// Of the pixels that return nothing, so large a share returns anything beyond the zones.
  Hall& stray(double share, std::mt19937& random) {
    std::bernoulli_distribution strays(share);
    std::uniform_real_distribution<float> anywhere(1.1f, 5.0f);
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (std::isnan(points_[i].z) && strays(random)) set(i, anywhere(random));
    return *this;
  }

  /// Of what is nearer than the floor in these columns, ever less returns from one row down to the other.
  Hall& fray(std::size_t from, std::size_t to, std::size_t top, std::size_t below, std::mt19937& random) {
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    for (std::size_t row = top; row < height; ++row) {
      const double gone = static_cast<double>(row - top) / static_cast<double>(below - top);
      for (std::size_t column = from; column < to; ++column)
        if (chance(random) < gone) set(row * width + column, nan);
    }
    return *this;
  }

  CloudView view() const {
    CloudView view = view_of(points_);
    view.width = width, view.height = height, view.row_step = width * sizeof(Xyz);
    return view;
  }

 private:
  static constexpr float focal = 277.0f;  // [pixel]

  void set(std::size_t i, float z) {
    const float right = (static_cast<float>(i % width) - 159.5f) / focal,
                down = (static_cast<float>(i / width) - 119.5f) / focal;
    points_[i] = {right * z, down * z, z};
  }

  std::vector<Xyz> points_;
};

/// A robot in such a hall, of whose holes this share returns strays.
class StandingBeside : public testing::TestWithParam<double> {
 protected:
  Decision sees(const std::vector<Block>& blocks, int clouds = 1) {
    Decision decision;
    for (int i = 0; i < clouds; ++i) decision = robot_.sees(Hall(blocks, wall_).stray(GetParam(), random_).view());
    return decision;
  }
  void begins(float wall = inf) {
    robot_ = Robot();
    wall_ = wall;
    sees({}, 10);
  }
  void stands_for_good(const std::vector<Block>& blocks = {}) {
    for (int i = 0; i < 60; ++i) ASSERT_EQ(sees(blocks).speed, 0.0) << i;
  }

  std::mt19937 random_{11};
  Robot robot_;

 private:
  float wall_ = inf;
};

inline Block column(std::size_t at, std::size_t below, float z = 0.408f, std::size_t columns = 1) {
  return {at, at + columns, 0, below, z};
}
inline Block too_near(std::size_t from, std::size_t to) { return {from, to, 0, height, nan}; }
inline Block leg(std::size_t from, std::size_t to, float z) { return {from, to, 0, height, z}; }

}  // namespace safety_control_cloud
