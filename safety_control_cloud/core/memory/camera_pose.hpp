// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "../look/outlook.hpp"

namespace safety_control_cloud {

/// Where a camera is and which way it looks, in the corridor's axes.
struct CameraPose {
  std::array<float, 3> ahead = {0.0f, 0.0f, 1.0f}, right = {1.0f, 0.0f, 0.0f}, at = {0.0f, 0.0f, 0.0f};

  /// What it sees there, in the corridor's axes [m].
  Point placed(const Point& seen) const {
    const auto along = [&](std::size_t i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const float down = ahead[j] * right[k] - ahead[k] * right[j];
      return at[i] + right[i] * seen.x + down * seen.y + ahead[i] * seen.z;
    };
    return {along(0), along(1), along(2)};
  }

  bool operator==(const CameraPose& other) const {
    return ahead == other.ahead && right == other.right && at == other.at;
  }
};

inline CameraPose camera_pose_of(const Outlook& outlook) {
  if (!outlook.placement) return {};
  const auto& [x, y, z] = outlook.placement->rows;
  return {{x[2], y[2], z[2]}, {x[0], y[0], z[0]}, {x[3], y[3], z[3]}};
}

/// The same in axes that are turned by so much to the left [rad].
inline CameraPose in_turned_axes(const CameraPose& pose, double angle) {
  return {in_turned_axes(pose.ahead, angle), in_turned_axes(pose.right, angle), in_turned_axes(pose.at, angle)};
}

/// Cosine of the angle between them, the greater of that ahead and that to the right.
inline float cosine_between(const CameraPose& a, const CameraPose& b) {
  const auto cosine = [](const std::array<float, 3>& one, const std::array<float, 3>& other) {
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
  };
  return std::min(cosine(a.ahead, b.ahead), cosine(a.right, b.right));
}

/// [m]
inline float distance_between(const CameraPose& a, const CameraPose& b) {
  return std::hypot(a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]);
}

/// Whether a camera in either shows the same places in the same pixels of its picture: up to 1 degree (its cosine) and
/// 1 cm.
inline bool show_the_same(const CameraPose& a, const CameraPose& b) {
  return cosine_between(a, b) > 0.99985f && distance_between(a, b) < 0.01f;
}

/// [rad] By so much what is as near as a camera sees turns in its picture from one pose to the other.
inline float turning_between(const CameraPose& a, const CameraPose& b) {
  constexpr float near = 0.35f;  // [m]
  return std::max(std::acos(std::clamp(cosine_between(a, b), -1.0f, 1.0f)), distance_between(a, b) / near);
}

/// [rad] By so much, 0.3 degrees, it may turn for a camera that rests.
constexpr float still = 0.0053f;

}  // namespace safety_control_cloud
