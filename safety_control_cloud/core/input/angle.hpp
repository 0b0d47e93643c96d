// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace safety_control_cloud {

constexpr double pi = 3.14159265358979323846;  ///< [rad]
constexpr double full_turn = 2.0 * pi;         ///< [rad]

/// [rad] The same direction, in [-pi, pi].
inline double wrapped(double angle) { return std::remainder(angle, full_turn); }

}  // namespace safety_control_cloud
