// SPDX-License-Identifier: BSD-3-Clause
// Clouds of lines far apart, which bend upward beside the middle: in a raster of them some cells never return.
#include <gtest/gtest.h>

#include <random>

#include "looking_robot.hpp"

namespace safety_control_cloud {
namespace {

struct Lidar {
  int lines;
  double high, step;  ///< [degrees] of all lines, between the points of a line
};

constexpr Lidar lidars[] = {{32, 40.0, 0.35}, {64, 40.0, 0.35}, {64, 40.0, 0.62}, {128, 40.0, 0.31}};
constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr int enough = 200;  ///< clouds in which nothing is near

const Board wall{3.0f, -9.0f, 9.0f, -9.0f, floor_y};

/// In the optical frame. No two clouds have the same directions, and one point in twenty is missing.
std::vector<Xyz> seen_by(const Lidar& lidar, std::vector<Board> boards, std::mt19937& random) {
  boards.push_back(wall);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 0.005);
  std::vector<Xyz> points;
  const double phase = any(random);
  for (int line = 0; line < lidar.lines; ++line) {
    const double up = lidar.high * (static_cast<double>(line) / (lidar.lines - 1) - 0.5) * degree;
    for (double aside = -45.0 + phase * lidar.step; aside < 45.0; aside += lidar.step) {
      const double x = std::tan(aside * degree), y = std::tan(up) / std::cos(aside * degree);  // slopes
      double z = y > 0.0 ? floor_y / y : 60.0;
      for (const Board& board : boards) {
        const double at_x = x * board.z, at_y = y * board.z;
        if (at_x >= board.x_min && at_x <= board.x_max && at_y >= board.y_min && at_y <= board.y_max)
          z = std::min(z, double{board.z});
      }
      if (z <= 0.4 || z >= 60.0 || any(random) < 0.05) continue;
      z += noise(random);
      points.push_back({static_cast<float>(x * z), static_cast<float>(y * z), static_cast<float>(z)});
    }
  }
  return points;
}

std::vector<Board> legs(float z, float x) { return {post(z, x - 0.08f, 0.1f), post(z + 0.05f, x + 0.12f, 0.1f)}; }

TEST(Lidar, WhoPassesInFullViewIsNotLost) {
  for (const Lidar& lidar : lidars) {
    for (const float distance : {0.6f, 0.7f}) {
      std::mt19937 random(3);
      Robot robot;
      const auto sees = [&](const std::vector<Board>& boards) {
        return robot.sees(view_of(seen_by(lidar, boards, random)));
      };
      for (int i = 0; i < enough; ++i) sees({});
      for (float x = -1.0f; x < 1.0f; x += 0.04f) sees(legs(distance, x));
      for (int i = 0; i < 60; ++i) sees({});
      const Decision decision = sees({});
      EXPECT_EQ(decision.speed, 0.2) << lidar.lines << " by " << lidar.step << " at " << distance << ": "
                                     << decision.reason;
    }
  }
}

/// A board, a post beside the middle, one that hangs.
TEST(Lidar, WhatCameTooNearStaysLost) {
  for (const Lidar& lidar : lidars) {
    for (const int before : {3, enough}) {
      for (const Board& thing : {Board{0, -0.3f, 0.3f, -0.2f, floor_y}, Board{0, 0.12f, 0.17f, -1.0f, floor_y},
                                 Board{0, -0.2f, 0.1f, -0.2f, 0.05f}}) {
        std::mt19937 random(5);
        Robot robot;
        const auto sees = [&](float z) {
          Board board = thing;
          board.z = z;
          return robot.sees(view_of(seen_by(lidar, {board}, random)));
        };
        for (int i = 0; i < before; ++i) robot.sees(view_of(seen_by(lidar, {}, random)));
        for (float z = 1.2f; z > 0.36f; z -= 0.02f) sees(z);
        for (int i = 0; i < 80; ++i) {
          const Decision decision = sees(0.36f);
          ASSERT_EQ(decision.speed, 0.0) << lidar.lines << " by " << lidar.step << " after " << i << ": "
                                         << decision.reason;
        }
      }
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
