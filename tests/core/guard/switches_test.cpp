// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/switches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "guarded_robot.hpp"

namespace safety_control_cloud {
namespace {

const SwitchSettings front{"front", SwitchKind::Bumper, "bumper", Edge::Front, 0.0};

std::vector<std::string> problems_with(const Switches& switches) {
  Settings settings = guard_settings();
  settings.switches = switches;
  return problems_in(settings);
}

TEST(Switches, NameTheirEdgesCounterclockwise) {
  for (int i = 0; i < 8; ++i) {
    const auto edge = static_cast<Edge>(i);
    EXPECT_EQ(edge_named(name_of(edge)), edge);
    const Point2 direction = direction_of(edge);
    EXPECT_NEAR(std::remainder(std::atan2(direction.y, direction.x) - i * std::atan(1.0), 8.0 * std::atan(1.0)), 0.0,
                1e-12);
  }
  EXPECT_EQ(direction_of(Edge::Left).y, 1.0);
  EXPECT_EQ(edge_named("Front"), std::nullopt);
  EXPECT_EQ(edge_named(""), std::nullopt);
  EXPECT_EQ(switch_named("cliff"), SwitchKind::Cliff);
  EXPECT_EQ(switch_named("button"), std::nullopt);
}

TEST(Switches, HaveNamesOfOneWord) {
  for (const char* name : {"", "front bumper", "front\nbumper", "front/bumper"}) {
    SwitchSettings odd = front;
    odd.name = name;
    EXPECT_EQ(problems_with({odd}).size(), 1u) << name;
  }
}

TEST(Switches, SeveralAreFit) {
  SwitchSettings other = front;
  other.name = "other";  // one topic may serve two
  EXPECT_EQ(problems_with({front, other}), std::vector<std::string>{});
}

TEST(Switches, EveryContradictionIsNamed) {
  EXPECT_EQ(problems_with({front, front}).size(), 1u);
  for (const double timeout : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    SwitchSettings one = front;
    one.timeout = timeout;
    EXPECT_EQ(problems_with({one}).size(), 1u);
  }
  EXPECT_EQ(problems_with({{"", SwitchKind::Cliff, "", std::nullopt, 0.0}}).size(), 2u);
}

TEST(Switches, AreOfModeGuard) {
  Settings settings;
  settings.switches = {front};
  EXPECT_EQ(problems_in(settings), std::vector<std::string>{"switches are of mode guard"});
}

}  // namespace
}  // namespace safety_control_cloud
