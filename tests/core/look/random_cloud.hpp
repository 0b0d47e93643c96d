// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "../input/cloud_builder.hpp"
#include "random_case.hpp"

namespace safety_control_cloud {

struct LayoutInMemory {
  std::array<std::size_t, 3> offset;
  std::size_t point_step;
  Scalar scalar = Scalar::Float32;
  bool swapped = false;
};

inline const std::vector<LayoutInMemory>& layouts_in_memory() {
  static const std::vector<LayoutInMemory> layouts = {
      {{0, 4, 8}, 12},
      {{0, 4, 8}, 16},
      {{0, 4, 8}, 20},
      {{0, 4, 8}, 32},
      {{0, 4, 8}, 24},
      {{4, 8, 12}, 16},
      {{20, 24, 28}, 32},
      {{8, 12, 16}, 20},
      {{8, 4, 0}, 12},
      {{4, 0, 8}, 16},
      {{3, 7, 11}, 15},
      {{12, 6, 1}, 17},
      {{0, 4, 40}, 44},
      {{20, 1, 9}, 26},
      {{0, 4, 8}, 16, Scalar::Float32, true},
      {{0, 8, 16}, 24, Scalar::Float64},
      {{17, 1, 9}, 25, Scalar::Float64, true},
  };
  return layouts;
}

/// A cloud whose memory ends with its last coordinate, so that AddressSanitizer sees whoever reads on.
struct RandomCloud : RandomCase {
  std::vector<std::uint8_t> bytes;
  CloudView view;

  explicit RandomCloud(std::uint64_t seed) : RandomCase(seed) {
    choose_corridor();
    choose_layout();
    choose_placement();
    if (placement && random_() % 8 == 0) std::swap(placement->rows[0], placement->rows[2]);
    choose_rows();
    odd_share_ = pick({0.0, 0.02, 0.3, 1.0});
    depth_steps_ = pick({3.0, 100.0, 1e6});
    for (std::size_t row = 0; row < view.height; ++row) {
      for (std::size_t column = 0; column < view.width; ++column) {
        std::uint8_t* point = bytes.data() + row * view.row_step + column * view.point_step;
        const std::array<float, 3> values = {across(), across(), depth()};
        for (std::size_t axis = 0; axis < 3; ++axis) write(point + view.offset[axis], odd_or(values[axis]));
      }
    }
  }

 private:
  float across() { return static_cast<float>(1.2 * share() - 0.6); }
  float depth() { return static_cast<float>(0.2 + std::floor(share() * depth_steps_) * 2.8 / depth_steps_); }

  void choose_corridor() {
    corridor.x_min = pick({-0.3f, -0.25f, 0.0f, -0.6f});
    corridor.y_max = pick({0.2f, 0.3f, 0.0f});
    corridor.range_min = pick({0.0f, 0.0f, 0.4f, 1e-40f});
    corridor.min_points = pick({1u, 1u, 1u, 2u, 5u, 40u, 2000u});
  }

  void choose_layout() {
    const auto& layout = layouts_in_memory()[random_() % layouts_in_memory().size()];
    view.offset = layout.offset;
    view.point_step = layout.point_step;
    view.scalar = layout.scalar;
    view.swapped = layout.swapped;
    view.height = pick({0u, 1u, 1u, 1u, 2u, 5u});
    view.width = pick({0u, 1u, 3u, 15u, 16u, 17u, 64u, 100u, 640u, 1024u, 1025u, 2500u});
    view.row_step = view.width * view.point_step + pick({0u, 0u, 1u, 64u});
    const std::size_t value = view.scalar == Scalar::Float64 ? sizeof(double) : sizeof(float);
    const std::size_t end = *std::max_element(view.offset.begin(), view.offset.end()) + value;
    if (view.size() > 0) bytes.resize((view.height - 1) * view.row_step + (view.width - 1) * view.point_step + end);
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random_()); });
    view.bytes = bytes.data();
  }

  float odd_or(float value) {
    if (share() >= odd_share_) return value;
    return pick({nan,
                 -nan,
                 inf,
                 -inf,
                 -inf,
                 0.0f,
                 -0.0f,
                 1e-45f,
                 -1e-45f,
                 1e-39f,
                 3.4e38f,
                 -3.4e38f,
                 -1.0f,
                 0.4f,
                 corridor.x_min,
                 corridor.x_max,
                 corridor.y_min,
                 corridor.y_max,
                 corridor.range_min,
                 std::nextafter(corridor.x_min, -inf),
                 std::nextafter(corridor.x_max, inf),
                 std::nextafter(corridor.y_min, -inf),
                 std::nextafter(corridor.y_max, inf),
                 std::nextafter(corridor.range_min, inf)});
  }

  void write(std::uint8_t* to, float value) const {
    std::array<std::uint8_t, sizeof(double)> raw;
    const double wide = value;
    const std::size_t size = view.scalar == Scalar::Float64 ? sizeof(double) : sizeof(float);
    std::memcpy(raw.data(), size == sizeof(double) ? static_cast<const void*>(&wide) : &value, size);
    if (view.swapped) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    std::memcpy(to, raw.data(), size);
  }

  double odd_share_ = 0.0, depth_steps_ = 1.0;
};

}  // namespace safety_control_cloud
