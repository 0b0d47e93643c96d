// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../path/plane.hpp"
#include "../text/problems.hpp"

namespace safety_control_cloud {

/// What a switch on the robot tells of.
enum class SwitchKind : std::uint8_t {
  Bumper,  ///< the robot touches something
  Cliff,   ///< the floor ends under its edge
};

const char* name_of(SwitchKind kind);  ///< "bumper" or "cliff"
std::optional<SwitchKind> switch_named(const std::string& name);

/// Of the robot, from above: eighths of a turn from where it drives forward, counterclockwise.
enum class Edge : std::uint8_t { Front, FrontLeft, Left, RearLeft, Rear, RearRight, Right, FrontRight };

const char* name_of(Edge edge);  ///< "front", "front_left", ...
std::optional<Edge> edge_named(const std::string& name);
Point2 direction_of(Edge edge);  ///< in base_frame, of length 1

/// One of the robot's switches.
struct SwitchSettings {
  std::string name;
  SwitchKind type = SwitchKind::Bumper;
  std::string topic;
  std::optional<Edge> side;  ///< none: its messages say which
  double timeout = 0.0;      ///< [s] without a word of it that are a doubt; 0: it speaks only of changes
};

using Switches = std::vector<SwitchSettings>;

bool operator==(const SwitchSettings& a, const SwitchSettings& b);

void check(const Switches& switches, Problems& problems);

}  // namespace safety_control_cloud
