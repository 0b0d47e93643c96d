// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "../look/outlook.hpp"

namespace safety_control_cloud {

/// Where a camera is and which way it looks, in the corridor's axes.
using CameraPose = Placement;

inline CameraPose camera_pose_of(const Outlook& outlook) { return outlook.placement.value_or(CameraPose{}); }

/// In the corridor's axes: a direction of the camera's own, and where it is [m].
inline std::array<float, 3> right_of(const CameraPose& camera) {
  const auto& [x, y, z] = camera.rows;
  return {x[0], y[0], z[0]};
}
inline std::array<float, 3> ahead_of(const CameraPose& camera) {
  const auto& [x, y, z] = camera.rows;
  return {x[2], y[2], z[2]};
}
inline std::array<float, 3> place_of(const CameraPose& camera) {
  const auto& [x, y, z] = camera.rows;
  return {x[3], y[3], z[3]};
}

/// The same in axes in which a camera that was `before` in these ones, and has not moved, is `now`.
inline CameraPose in_axes_of(const CameraPose& now, const CameraPose& before, const CameraPose& pose) {
  const auto moved = [&](const Point& place) {
    const Point seen = before.seen(place);
    return now(seen.x, seen.y, seen.z);
  };
  const Point at = moved(pose(0.0f, 0.0f, 0.0f));
  CameraPose there;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto along = [=](std::size_t axis) { return axis == i ? 1.0f : 0.0f; };
    const Point end = moved(pose(along(0), along(1), along(2)));
    there.rows[0][i] = end.x - at.x, there.rows[1][i] = end.y - at.y, there.rows[2][i] = end.z - at.z;
  }
  there.rows[0][3] = at.x, there.rows[1][3] = at.y, there.rows[2][3] = at.z;
  return there;
}

/// Cosine of the angle between them, the greater of that ahead and that to the right.
inline float cosine_between(const CameraPose& a, const CameraPose& b) {
  const auto cosine = [](const std::array<float, 3>& one, const std::array<float, 3>& other) {
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
  };
  return std::min(cosine(ahead_of(a), ahead_of(b)), cosine(right_of(a), right_of(b)));
}

/// [m]
inline float distance_between(const CameraPose& a, const CameraPose& b) {
  const auto [x, y, z] = place_of(a);
  const auto [there_x, there_y, there_z] = place_of(b);
  return std::hypot(x - there_x, y - there_y, z - there_z);
}

constexpr float same_place = 0.01f;  ///< [m]

/// Whether a camera in either shows the same places in the same pixels of its picture: up to 1 degree (its cosine) and
/// 1 cm.
inline bool show_the_same(const CameraPose& a, const CameraPose& b) {
  return cosine_between(a, b) > 0.99985f && distance_between(a, b) < same_place;
}

/// [rad] By so much what is as near as a camera sees turns in its picture from one pose to the other. By less than a
/// place counts as the same, TF may be off.
inline float turning_between(const CameraPose& a, const CameraPose& b) {
  constexpr float near = 0.35f;  // [m]
  const float away = distance_between(a, b);
  return std::max(std::acos(std::clamp(cosine_between(a, b), -1.0f, 1.0f)), away < same_place ? 0.0f : away / near);
}

/// [rad] By so much, 0.3 degrees, it may turn for a camera that rests.
constexpr float still = 0.0053f;

}  // namespace safety_control_cloud
