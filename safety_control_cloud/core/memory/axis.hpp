// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "../look/outlook.hpp"

namespace safety_control_cloud {

/// Which way a camera looks, in the corridor's axes.
struct Axis {
  std::array<float, 3> ahead = {0.0f, 0.0f, 1.0f}, right = {1.0f, 0.0f, 0.0f};
};

inline Axis axis_of(const Outlook& outlook) {
  if (!outlook.placement) return {};
  const auto& [x, y, z] = outlook.placement->rows;
  return {{x[2], y[2], z[2]}, {x[0], y[0], z[0]}};
}

/// The same in axes that are turned by so much to the left [rad].
inline Axis axis_turned(const Axis& axis, double angle) {
  return {in_turned_axes(axis.ahead, angle), in_turned_axes(axis.right, angle)};
}

/// Cosine of the angle between them, the greater of that ahead and that to the right.
inline float cosine_of(const Axis& a, const Axis& b) {
  const auto cosine = [](const std::array<float, 3>& one, const std::array<float, 3>& other) {
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
  };
  return std::min(cosine(a.ahead, b.ahead), cosine(a.right, b.right));
}

/// Whether the angle between them is less than that of which `least` is the cosine.
inline bool are_same(const Axis& a, const Axis& b, float least) { return cosine_of(a, b) > least; }

/// Cosine: by so much, 1 degree, a camera may have turned for its picture to show the same places.
constexpr float same_axis = 0.99985f;
/// [rad] By so much, 0.3 degrees, a camera that rests may turn from one picture to the next.
constexpr float still = 0.0053f;

}  // namespace safety_control_cloud
