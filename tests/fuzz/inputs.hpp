// SPDX-License-Identifier: BSD-3-Clause
// What a tape's bytes say of settings, places and pictures.
#pragma once

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

#include "../../safety_control_cloud/core/safety_control.hpp"
#include "scenario.hpp"
#include "shown.hpp"

namespace safety_control_cloud {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

template <class Value, std::size_t n>
Value one_of(const Value (&values)[n], std::uint8_t choice) {
  return values[choice % n];
}

inline Settings settings_of(const Choice& choice, Method method) {
  Settings settings;
  settings.method = method;
  settings.corridor.min_points = one_of<std::size_t>({1, 2, 5}, choice.min_points);
  settings.corridor.range_min = one_of<float>({0.0f, 0.2f}, choice.range_min);
  settings.release.clouds = one_of<std::size_t>({1, 2, 3}, choice.release_clouds);
  settings.release.time = one_of<double>({0.0, 0.2}, choice.release_time);
  settings.stamp_tolerance = one_of<double>({1.0, 0.0}, choice.stamp_tolerance);
  settings.min_valid_ratio = one_of<double>({0.1, 0.0, 1.0}, choice.min_valid_ratio);
  settings.near_loss.distance = one_of<double>({0.75, 0.0, NearLossLimits::farthest}, choice.near_loss_distance);
  settings.near_loss.timeout = one_of<double>({0.0, 0.3}, choice.near_loss_timeout);
  settings.frozen_clouds = one_of<std::size_t>({0, 2, 4}, choice.frozen_clouds);
  settings.target_frame = one_of<const char*>({"", "base"}, choice.target_frame);
  return settings;
}

/// Mostly one that belongs to these settings.
inline Placing placing_of(std::uint8_t choice, const Settings& settings) {
  Placement tilted, overflowing;
  tilted.rows = {{{1, 0, 0, 0.05f}, {0, 0.8f, -0.6f, 0}, {0, 0.6f, 0.8f, -0.09f}}};
  overflowing.rows = {{{0.7f, 0.7f, 0, 0}, {-0.7f, 0.7f, 0, 0}, {0, 0, 1, largest}}};
  if (choice % 8 == 7) return tilted;
  if (settings.target_frame.empty()) return one_of<Placing>({OpticalFrame{}, NoTransform{"nobody knows"}}, choice);
  return one_of<Placing>({tilted, OpticalFrame{}, NoTransform{"nobody knows"}, overflowing}, choice);
}

inline float depth_of(std::uint8_t pixel) {
  constexpr float special[] = {nan, 0.0f, inf, -inf, -1.0f, largest, std::numeric_limits<float>::denorm_min(), 1e-3f};
  return pixel < std::size(special) ? special[pixel] : static_cast<float>(pixel) * 0.02f;
}

inline Depths depths_of(const Step& step) {
  Depths picture{step.width % 64u, step.height % 64u, {}};
  for (std::size_t i = 0; i < picture.width * picture.height; ++i) {
    picture.z.push_back(depth_of(i < step.bytes.size() ? step.bytes[i] : 0));
  }
  return picture;
}

/// By a camera 60 degrees wide.
inline DepthView image_of(const Depths& picture) {
  DepthView image;
  image.bytes = reinterpret_cast<const std::uint8_t*>(picture.z.data());
  image.width = picture.width, image.height = picture.height;
  image.row_step = picture.width * sizeof(float);
  const double across = static_cast<double>(picture.width) / 2.0, down = static_cast<double>(picture.height) / 2.0;
  image.camera = {std::max(across, 1.0) / 0.577, std::max(down, 1.0) / 0.433, across, down};
  return image;
}

/// The points of such an image. In a cloud, -Inf is a point too close; an image here does not say so. What is of other
/// bytes in the image is so in the cloud too, or only one of them would be frozen: +Inf becomes another NaN.
inline std::vector<float> points_of(const Depths& picture) {
  const Rays rays(image_of(picture));
  std::vector<float> points;
  for (std::size_t i = 0; i < picture.z.size(); ++i) {
    const float z = picture.z[i];
    const auto u = static_cast<float>(i % picture.width), v = static_cast<float>(i / picture.width);
    const float x = (u - rays.cx) * z * rays.x_scale, y = (v - rays.cy) * z * rays.y_scale;
    if (z == inf)
      points.insert(points.end(), {nan, nan, -nan});
    else
      points.insert(points.end(), {x, y, z * rays.z_scale});
  }
  return points;
}

inline CloudView cloud_of(const std::vector<float>& points, const Depths& picture) {
  Layout layout;
  layout.width = static_cast<std::uint32_t>(picture.width), layout.height = static_cast<std::uint32_t>(picture.height);
  layout.fields = {{"x", 0, Field::FLOAT32, 1}, {"y", 4, Field::FLOAT32, 1}, {"z", 8, Field::FLOAT32, 1}};
  layout.point_step = 12;
  layout.row_step = layout.width * 12;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(points.data());
  return std::get<CloudView>(view_of(layout, bytes, points.size() * sizeof(float)));
}

inline bool is_minus_inf(float z) { return z == -inf; }

}  // namespace safety_control_cloud
