// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

#include "input/cloud_builder.hpp"

namespace safety_control_cloud {

/// An upright board that faces the camera, in the optical frame [m].
struct Board {
  float z, x_min, x_max, y_min, y_max;
};

constexpr float floor_y = 0.2972f;  ///< [m] of the floor below the Xtion on a TurtleBot

inline Board post(float z, float x, float width = 0.05f) { return {z, x - width / 2, x + width / 2, -1.0f, floor_y}; }

/// What an Xtion on a TurtleBot sees of a hall deeper than its range: 160x120, 60 degrees wide, nothing at or below
/// 0.4 m and at or beyond 5.0 m, and a floor.
class Scene {
 public:
  static constexpr std::size_t width = 160, height = 120;

  /// `nose_up` [rad]: of the camera over the floor; the boards stay before it.
  explicit Scene(std::vector<Board> boards = {}, float nose_up = 0.0f) : points_(width * height) {
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        points_[row * width + column] = seen_along(right(column), down(row), boards, nose_up);
      }
    }
  }

  void set(std::size_t row, std::size_t column, float z) { points_[row * width + column] = {0.0f, 0.0f, z}; }

  void blank_lowest_rows(std::size_t rows) {
    std::fill(points_.end() - static_cast<std::ptrdiff_t>(rows * width), points_.end(), Xyz{nan, nan, nan});
  }

  void blank_nearer_than(float z) {
    for (Xyz& point : points_) {
      if (point.z < z) point = {nan, nan, nan};
    }
  }

  void blank_farther_than(float z) {
    for (Xyz& point : points_) {
      if (point.z > z) point = {nan, nan, nan};
    }
  }

  /// Pixels that return nothing return anything from `nearest` [m] to 5 m instead, so large a share of them.
  template <class Random>
  Scene& stray(double share, Random& random, float nearest = 0.4f) {
    std::uniform_real_distribution<float> any(0.0f, 1.0f);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!std::isnan(points_[i].z) || any(random) >= static_cast<float>(share)) continue;
      const float z = nearest + (5.0f - nearest) * any(random);
      points_[i] = {right(i % width) * z, down(i / width) * z, z};
    }
    return *this;
  }

  /// So large a share of the pixels returns nothing.
  template <class Random>
  Scene& drop(double share, Random& random) {
    std::bernoulli_distribution dropped(share);
    for (Xyz& point : points_) {
      if (dropped(random)) point = {nan, nan, nan};
    }
    return *this;
  }

  /// Those that return something, in a row of their own.
  std::vector<Xyz> returns() const {
    std::vector<Xyz> some;
    std::copy_if(points_.begin(), points_.end(), std::back_inserter(some), [](Xyz p) { return !std::isnan(p.z); });
    return some;
  }

  CloudView view() const {
    CloudView view = view_of(points_);
    view.width = width;
    view.height = height;
    view.row_step = width * sizeof(Xyz);
    return view;
  }

 private:
  static constexpr float focal = 138.56f;  // [pixel]

  static float right(std::size_t column) { return (static_cast<float>(column) - 79.5f) / focal; }
  static float down(std::size_t row) { return (static_cast<float>(row) - 59.5f) / focal; }

  static Xyz seen_along(float x, float y, const std::vector<Board>& boards, float nose_up) {
    const float down = y * std::cos(nose_up) - std::sin(nose_up);
    float z = down > 0.0f ? floor_y / down : inf;
    for (const Board& board : boards) {
      const bool hit = x * board.z >= board.x_min && x * board.z <= board.x_max && y * board.z >= board.y_min &&
                       y * board.z <= board.y_max;
      if (hit) z = std::min(z, board.z);
    }
    if (z <= 0.4f || z >= 5.0f) return {nan, nan, nan};
    return {x * z, y * z, z};
  }

  std::vector<Xyz> points_;
};

}  // namespace safety_control_cloud
