// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "../../safety_control_cloud/core/input/view.hpp"

namespace safety_control_cloud {

/// What a depth camera of 60 degrees sends: a cloud with x, y, z at the start of every point, or where a point has no
/// room for them a depth image, in millimetres (2 bytes) or in metres (4 bytes).
struct CameraPicture {
  std::size_t width = 640, height = 480, point_step = 16;
  double nan_share = 0.0;         ///< points that do not return
  std::string scene = "wall_2m";  ///< or wall_0.6m, mixed: a floor, a wall and boxes

  std::size_t size() const { return width * height * point_step; }                            ///< [byte]
  double focal() const { return static_cast<double>(width) / (2.0 * std::tan(M_PI / 6.0)); }  ///< [px]
  bool operator==(const CameraPicture& other) const {
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

/// Stores a point with this depth [m], or NaN, the way that the picture stores one.
inline void put(double z, double right, double down, const CameraPicture& picture, std::uint8_t* to) {
  const auto millimetres = static_cast<std::uint16_t>(std::isnan(z) ? 0 : std::lround(1000.0 * z));
  const auto metres = static_cast<float>(z);
  const float xyz[] = {static_cast<float>(right * z), static_cast<float>(down * z), metres};
  if (picture.point_step == sizeof(millimetres)) {
    std::memcpy(to, &millimetres, sizeof(millimetres));
  } else if (picture.point_step == sizeof(metres)) {
    std::memcpy(to, &metres, sizeof(metres));
  } else {
    std::memcpy(to, xyz, sizeof(xyz));
  }
}

inline std::vector<std::uint8_t> bytes_of(const CameraPicture& picture) {
  std::vector<std::uint8_t> bytes(picture.size());
  std::minstd_rand random(7);
  const auto share = [&] { return static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max()); };
  std::uint8_t* point = bytes.data();
  for (std::size_t row = 0; row < picture.height; ++row) {
    for (std::size_t column = 0; column < picture.width; ++column, point += picture.point_step) {
      const double u = static_cast<double>(column) - static_cast<double>(picture.width) / 2.0;
      const double v = static_cast<double>(row) - static_cast<double>(picture.height) / 2.0;
      const double a = 2.0 * u / static_cast<double>(picture.width), b = 2.0 * v / static_cast<double>(picture.height);
      const double z = depth_in(picture.scene, a, b) + 0.004 * share();
      const bool returns = share() >= picture.nan_share;
      put(returns ? z : std::nan(""), u / picture.focal(), v / picture.focal(), picture, point);
    }
  }
  return bytes;
}

inline DepthView depth_view_of(const CameraPicture& picture, const std::uint8_t* bytes) {
  DepthView view;
  view.bytes = bytes;
  view.width = picture.width;
  view.height = picture.height;
  view.row_step = picture.width * picture.point_step;
  view.depth = picture.point_step == sizeof(float) ? Depth::Metres : Depth::Millimetres;
  view.camera = {picture.focal(), picture.focal(), static_cast<double>(picture.width) / 2.0,
                 static_cast<double>(picture.height) / 2.0};
  return view;
}

inline View view_of(const CameraPicture& picture, const std::uint8_t* bytes) {
  if (picture.point_step < 3 * sizeof(float)) return depth_view_of(picture, bytes);
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
