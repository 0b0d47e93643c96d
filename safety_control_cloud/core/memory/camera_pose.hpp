// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "../look/outlook.hpp"

namespace safety_control_cloud {

/// Where a camera is and which way it looks, in the corridor's axes.
struct CameraPose {
  using Vector = std::array<float, 3>;

  Vector ahead = {0.0f, 0.0f, 1.0f}, right = {1.0f, 0.0f, 0.0f}, at = {0.0f, 0.0f, 0.0f};

  Vector down() const {
    const auto along = [this](std::size_t i, std::size_t j) { return ahead[i] * right[j] - ahead[j] * right[i]; };
    return {along(1, 2), along(2, 0), along(0, 1)};
  }

  /// A direction in its frame, in the corridor's axes; and the other way round.
  Vector out_of(const Vector& seen) const {
    const Vector below = down();
    Vector out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = right[i] * seen[0] + below[i] * seen[1] + ahead[i] * seen[2];
    return out;
  }
  Vector into(const Vector& direction) const {
    const auto along = [&](const Vector& a) { return a[0] * direction[0] + a[1] * direction[1] + a[2] * direction[2]; };
    return {along(right), along(down()), along(ahead)};
  }

  /// What it sees there, in the corridor's axes [m].
  Point placed(const Point& seen) const {
    const auto [x, y, z] = out_of({seen.x, seen.y, seen.z});
    return {at[0] + x, at[1] + y, at[2] + z};
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

/// The same in axes in which a camera that was `before` in these ones, and has not moved, is `now`.
inline CameraPose in_axes_of(const CameraPose& now, const CameraPose& before, const CameraPose& pose) {
  const auto direction = [&](const CameraPose::Vector& old) { return now.out_of(before.into(old)); };
  const auto [x, y, z] = direction({pose.at[0] - before.at[0], pose.at[1] - before.at[1], pose.at[2] - before.at[2]});
  return {direction(pose.ahead), direction(pose.right), {now.at[0] + x, now.at[1] + y, now.at[2] + z}};
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
