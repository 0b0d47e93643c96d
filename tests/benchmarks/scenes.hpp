// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "../../safety_control_cloud/core/cloud.hpp"

namespace safety_control_cloud {

/// What an organised depth camera of 60 degrees sends, with x, y, z at the start of every point.
struct Picture {
  std::size_t width = 640, height = 480, point_step = 16;
  double nan_share = 0.0;         ///< points that do not return
  std::string scene = "wall_2m";  ///< or wall_0.6m, mixed: a floor, a wall and boxes

  std::size_t size() const { return width * height * point_step; }  ///< [byte]
  bool operator==(const Picture& other) const {
    return width == other.width && height == other.height && point_step == other.point_step &&
           nan_share == other.nan_share && scene == other.scene;
  }
};

/// [m] along z at a pixel; a and b run from -1 to 1 across and down.
inline double depth_in(const std::string& scene, double a, double b) {
  if (scene == "wall_0.6m") return 0.6;
  if (scene == "wall_2m") return 2.0;
  const double floor = b > 0.0 ? 0.3 / (0.43 * b) : 3.5;
  const bool on_box = std::fmod(std::abs(a) * 7.0, 2.0) < 0.8 && b > -0.5;
  return std::min(floor, on_box ? 0.7 + 2.0 * std::abs(a) : 3.5);
}

inline std::vector<std::uint8_t> bytes_of(const Picture& picture) {
  std::vector<std::uint8_t> bytes(picture.size());
  std::minstd_rand random(7);
  const auto share = [&] { return static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max()); };
  const double focal = static_cast<double>(picture.width) / (2.0 * std::tan(M_PI / 6.0));
  std::uint8_t* point = bytes.data();
  for (std::size_t row = 0; row < picture.height; ++row) {
    for (std::size_t column = 0; column < picture.width; ++column, point += picture.point_step) {
      const double u = static_cast<double>(column) - static_cast<double>(picture.width) / 2.0;
      const double v = static_cast<double>(row) - static_cast<double>(picture.height) / 2.0;
      const double a = 2.0 * u / static_cast<double>(picture.width), b = 2.0 * v / static_cast<double>(picture.height);
      const double z = depth_in(picture.scene, a, b) + 0.004 * share();
      float xyz[] = {static_cast<float>(u * z / focal), static_cast<float>(v * z / focal), static_cast<float>(z)};
      if (share() < picture.nan_share) xyz[0] = xyz[1] = xyz[2] = std::numeric_limits<float>::quiet_NaN();
      std::memcpy(point, xyz, sizeof(xyz));
    }
  }
  return bytes;
}

inline CloudView view_of(const Picture& picture, const std::uint8_t* bytes) {
  CloudView view;
  view.bytes = bytes;
  view.width = picture.width;
  view.height = picture.height;
  view.point_step = picture.point_step;
  view.row_step = picture.width * picture.point_step;
  view.offset = {0, sizeof(float), 2 * sizeof(float)};
  return view;
}

}  // namespace safety_control_cloud
