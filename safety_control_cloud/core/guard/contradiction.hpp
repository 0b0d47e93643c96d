// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pose.hpp"

namespace safety_control_cloud {

/// [s] that is long enough for it, and short enough for a turn not to lead back.
constexpr double contradicts_for = 1.0;

/// In words, how odometry contradicts what the base was told: it went or turned the other way, or went on without the
/// turn; none: it does not. `way` is odometry's, `as_told` are those between which the base went if it did as it was
/// told. A robot at rest is none: somebody may have pressed its stop button, or it may be blocked.
std::optional<std::string> contradiction(const Pose2& way, const std::vector<Pose2>& as_told);

}  // namespace safety_control_cloud
