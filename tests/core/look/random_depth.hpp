// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "../input/cloud_builder.hpp"
#include "random_case.hpp"

namespace safety_control_cloud {

/// A depth image whose memory ends with its last pixel, so that AddressSanitizer sees whoever reads on, and the points
/// that depth_image_proc 1.17 makes of it, calculated here a pixel at a time.
struct RandomDepth : RandomCase {
  std::vector<std::uint8_t> bytes;
  DepthView view;
  std::vector<Xyz> points;

  explicit RandomDepth(std::uint64_t seed) : RandomCase(seed) {
    choose_corridor();
    choose_layout();
    choose_placement();
    choose_rows();
    odd_share_ = pick({0.0, 0.05, 0.3, 1.0});
    for (std::size_t v = 0; v < view.height; ++v) {
      for (std::size_t u = 0; u < view.width; ++u) {
        std::uint8_t* pixel = bytes.data() + v * view.row_step + u * view.pixel_step();
        points.push_back(view.depth == Depth::Metres ? write(pixel, metres(u, v), u, v)
                                                     : write(pixel, millimetres(u, v), u, v));
      }
    }
  }

  /// Whether the i-th pixel holds it.
  bool is_minus_inf(std::size_t i) const {
    if (view.depth != Depth::Metres) return false;
    std::uint8_t raw[sizeof(float)];
    std::memcpy(raw, bytes.data() + i / view.width * view.row_step + i % view.width * sizeof(float), sizeof raw);
    if (view.swapped) std::reverse(std::begin(raw), std::end(raw));
    float depth = 0.0f;
    std::memcpy(&depth, raw, sizeof depth);
    return depth == -inf;
  }

  /// The same points as a cloud.
  CloudView cloud() const {
    CloudView cloud = view_of(points);
    cloud.width = view.width;
    cloud.height = view.height;
    cloud.row_step = view.width * cloud.point_step;
    return cloud;
  }

 private:
  void choose_corridor() {
    corridor.x_min = pick({-0.3f, -0.3f, 0.1f, -0.6f});
    corridor.y_min = pick({-0.25f, -0.25f, 0.05f});
    corridor.y_max = pick({0.2f, 0.2f, 0.3f});
    if (random_() % 8 == 0) corridor.x_max = -0.05f, corridor.x_min = -0.5f;
    corridor.range_min = pick({0.0f, 0.0f, 0.4f, 1e-40f, -1.0f});
    corridor.min_points = pick({1u, 1u, 1u, 2u, 5u, 40u});
  }

  void choose_layout() {
    view.depth = pick({Depth::Metres, Depth::Millimetres});
    view.swapped = random_() % 8 == 0;
    view.width = pick({0u, 1u, 3u, 15u, 16u, 17u, 64u, 100u, 640u, 1025u});
    view.height = pick({0u, 1u, 1u, 2u, 5u});
    view.row_step = view.width * view.pixel_step() + pick({0u, 0u, 1u, 64u});
    if (view.size() > 0) bytes.resize((view.height - 1) * view.row_step + view.width * view.pixel_step());
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random_()); });
    view.bytes = bytes.data();
    const auto centre = [&](std::size_t size) {
      return static_cast<double>(size) * (share() - 0.2) + pick({0.0, 0.5});
    };
    view.camera = {pick({554.25469, 50.0, 1e-30, 7e5}), pick({554.25469, 60.0, 5.0}), centre(view.width),
                   centre(view.height)};
    if (random_() % 4 == 0) view.camera.cx = std::floor(view.camera.cx), view.camera.cy = std::floor(view.camera.cy);
  }

  /// Where the pixel's ray meets a limit of the corridor, or one of the numbers next to it [m].
  float on_a_limit(std::size_t u, std::size_t v) {
    const auto along = [](double limit, double pixel, double centre, double focal) {
      return static_cast<float>(limit * focal / (pixel - centre));
    };
    const float x_limit = pick({corridor.x_min, corridor.x_max}), y_limit = pick({corridor.y_min, corridor.y_max});
    float depth =
        pick({along(x_limit, static_cast<double>(u), view.camera.cx, view.camera.fx),
              along(y_limit, static_cast<double>(v), view.camera.cy, view.camera.fy), corridor.range_min, 0.75f});
    for (auto steps = random_() % 4; steps > 0; --steps) depth = std::nextafter(depth, pick({inf, -inf}));
    return depth;
  }

  float metres(std::size_t u, std::size_t v) {
    if (share() >= odd_share_) return static_cast<float>(0.2 + 2.8 * share());
    return pick({nan, -nan, inf, -inf, 0.0f, -0.0f, 1e-45f, 1e-39f, -1.0f, -0.3f, 3.4e38f, -3.4e38f, on_a_limit(u, v),
                 on_a_limit(u, v), on_a_limit(u, v), on_a_limit(u, v)});
  }

  std::uint16_t millimetres(std::size_t u, std::size_t v) {
    if (share() >= odd_share_) return static_cast<std::uint16_t>(200.0 + 2800.0 * share());
    const double near_limit = std::clamp(1000.0 * double{on_a_limit(u, v)} + pick({-1.0, 0.0, 1.0}), 0.0, 65535.0);
    return static_cast<std::uint16_t>(pick({0, 1, 65535, 400, 750, static_cast<int>(std::lround(near_limit))}));
  }

  /// Puts a pixel there; its point. float32 in every step, as in depth_image_proc/depth_conversions.h.
  template <class Pixel>
  Xyz write(std::uint8_t* to, Pixel depth, std::size_t u, std::size_t v) const {
    std::uint8_t raw[sizeof(Pixel)];
    std::memcpy(raw, &depth, sizeof(Pixel));
    if (view.swapped) std::reverse(std::begin(raw), std::end(raw));
    std::memcpy(to, raw, sizeof(Pixel));

    constexpr bool is_metres = sizeof(Pixel) == sizeof(float);
    if (is_metres ? !std::isfinite(static_cast<float>(depth)) : depth == 0) return {nan, nan, nan};
    const double unit = is_metres ? 1.0 : double{0.001f};
    const auto x_scale = static_cast<float>(unit / view.camera.fx), y_scale = static_cast<float>(unit / view.camera.fy);
    const float right = static_cast<float>(static_cast<int>(u)) - static_cast<float>(view.camera.cx);
    const float down = static_cast<float>(static_cast<int>(v)) - static_cast<float>(view.camera.cy);
    const float d = depth;
    return {right * d * x_scale, down * d * y_scale, is_metres ? d : d * 0.001f};
  }

  double odd_share_ = 0.0;
};

}  // namespace safety_control_cloud
