// SPDX-License-Identifier: BSD-3-Clause
#include "switches.hpp"

#include <array>
#include <cmath>
#include <set>

#include "../input/angle.hpp"
#include "../text/choice.hpp"
#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double eighth = full_turn / 8.0;  ///< [rad] of a turn
constexpr std::array<const char*, 8> edges = {"front", "front_left", "left",  "rear_left",
                                              "rear",  "rear_right", "right", "front_right"};

}  // namespace

const char* name_of(SwitchKind kind) { return kind == SwitchKind::Cliff ? "cliff" : "bumper"; }

std::optional<SwitchKind> switch_named(const std::string& name) {
  return choice_named(name, {SwitchKind::Bumper, SwitchKind::Cliff});
}

const char* name_of(Edge edge) { return edges[static_cast<std::size_t>(edge)]; }

std::optional<Edge> edge_named(const std::string& name) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (name == edges[i]) return static_cast<Edge>(i);
  return std::nullopt;
}

Point2 direction_of(Edge edge) {
  const double heading = eighth * static_cast<double>(edge);
  return {std::cos(heading), std::sin(heading)};
}

bool operator==(const SwitchSettings& a, const SwitchSettings& b) {
  return a.name == b.name && a.type == b.type && a.topic == b.topic && a.side == b.side && a.timeout == b.timeout;
}

void check(const Switches& switches, Problems& problems) {
  std::set<std::string> names;
  for (const SwitchSettings& one : switches) {
    problems.require(is_name(one.name), words("switches: \"", one.name, "\" is no name: letters, digits and _"));
    problems.require(names.insert(one.name).second, "switches: two are named " + one.name);
    problems.require(!one.topic.empty(), words("switches, ", one.name, ": topic must not be empty"));
    problems.require(std::isfinite(one.timeout) && one.timeout >= 0.0,
                     words("switches, ", one.name, ": timeout must be finite and not negative"));
  }
}

}  // namespace safety_control_cloud
