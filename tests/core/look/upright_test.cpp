// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/look/upright.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "../guard/guarded_robot.hpp"
#include "../memory/looking_robot.hpp"
#include "../rolled.hpp"

namespace safety_control_cloud {
namespace {

const Placement upright_xtion = std::get<Placement>(xtion());

Scene floor_with_a_hole() {
  Scene scene;
  for (std::size_t row = 70; row < Scene::height; ++row)
    for (std::size_t column = 60; column < 100; ++column) scene.set(row, column, nan);
  return scene;
}

class Rolled : public testing::TestWithParam<Roll> {
 protected:
  Placement placement() const { return rolled(upright_xtion, GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(By, Rolled, testing::ValuesIn(all_rolls()), [](const auto& info) {
  return std::to_string(90 * info.param.quarters) + (info.param.columns_from_right ? "Mirrored" : "") +
         (info.param.rows_from_below ? "FromBelow" : "");
});

TEST_P(Rolled, ThePictureIsThatOfAnUprightCamera) {
  const Scene scene({post(0.9f, 0.2f), {1.5f, -0.4f, -0.1f, -0.3f, 0.0f}});
  const RolledPicture picture(scene.view(), GetParam());
  Upright upright;
  const auto [view, outlook] = upright.of(picture.view(), Outlook({}, placement()));
  const auto& cloud = std::get<CloudView>(view);
  ASSERT_EQ(cloud.width, Scene::width);
  ASSERT_EQ(cloud.height, Scene::height);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    Xyz seen, there;
    std::memcpy(&seen, cloud.bytes + i * cloud.point_step, sizeof seen);
    std::memcpy(&there, scene.view().bytes + i * sizeof there, sizeof there);
    ASSERT_TRUE(std::isnan(there.z) ? std::isnan(seen.z) : seen.x == there.x && seen.y == there.y && seen.z == there.z)
        << i;
  }
  EXPECT_EQ(outlook.placement->rows, upright_xtion.rows);
}

/// It has shown nothing, or nothing yet.
TEST_P(Rolled, WhatShowsNothingIsTurnedAsThatBefore) {
  const RolledPicture hall(Scene().view(), GetParam());
  Scene blind;
  blind.blank_farther_than(0.0f);
  const RolledPicture dark(blind.view(), GetParam());
  Upright upright;
  upright.of(hall.view(), Outlook({}, placement()));
  const auto [view, outlook] = upright.of(dark.view(), Outlook({}, placement()));
  EXPECT_EQ(width_of(view), Scene::width);
  EXPECT_EQ(outlook.placement->rows, upright_xtion.rows);
}

TEST_P(Rolled, WhatHidesTheFloorAndIsTooNearToBeSeenStopsTheRobotWhereItDrives) {
  Settings settings;
  settings.target_frame = "base_footprint";
  Robot robot(settings, placement());
  const auto sees = [&](const Scene& scene) { return robot.sees(RolledPicture(scene.view(), GetParam()).view()); };
  for (int i = 0; i < 20; ++i) sees(Scene());
  EXPECT_EQ(sees(Scene()).speed, 0.2);
  for (int i = 0; i < 5; ++i) sees(floor_with_a_hole());
  const Decision decision = sees(floor_with_a_hole());
  EXPECT_EQ(decision.cause, Cause::NearLoss);
  EXPECT_EQ(decision.speed, 0.0);
}

TEST_P(Rolled, AKerbStopsTheRobot) {
  Settings settings;
  settings.target_frame = "base_footprint";
  Robot robot(settings, placement());
  Decision decision;
  for (const float z : {1.2f, 1.0f, 0.8f, 0.74f, 0.7f, 0.65f, 0.6f}) {
    const Scene scene({{z, -0.2f, 0.2f, floor_y - 0.04f, floor_y}});
    decision = robot.sees(RolledPicture(scene.view(), GetParam()).view());
  }
  EXPECT_EQ(decision.cause, Cause::LowObstacle);
  EXPECT_EQ(decision.speed, 0.0);
}

/// Guarded, and with what it remembers.
struct RolledRobot : GuardedRobot {
  Roll roll;
  void passes(double seconds, const Scene& scene) {
    for (double t = 0.0; t < seconds; t += 0.05) {
      pass(0.05);
      control.note_odometry(now.ros, {}, {});
      see(RolledPicture(scene.view(), roll).view(), rolled(upright_xtion, roll));
      wants({});
    }
  }
};

TEST_P(Rolled, AGuardSeesAsAnUprightOneDoes) {
  RolledRobot robot, upright;
  robot.roll = GetParam();
  for (const Scene& scene : {Scene(), Scene({post(0.7f, -0.15f)}), floor_with_a_hole(), Scene({wall_before(0.6)})}) {
    for (RolledRobot* one : {&robot, &upright}) one->passes(1.0, scene);
    for (const Twist2& twist : {Twist2{0.4, 0.0, 0.0}, Twist2{0.4, 0.0, 0.8}, Twist2{0.3, 0.0, -0.8},
                                Twist2{-0.3, 0.0, 0.0}, Twist2{0.0, 0.0, 1.0}}) {
      const Guarded should = upright.wants(twist), is = robot.wants(twist);
      EXPECT_NEAR(is.factor, should.factor, 1e-5) << is.reason << " and not: " << should.reason;
      EXPECT_EQ(is.cause, should.cause) << is.reason << " and not: " << should.reason;
    }
  }
}

/// Of what is gone, nothing is remembered.
TEST_P(Rolled, WhatIsSeenToHaveGoneIsForgotten) {
  RolledRobot robot;
  robot.roll = GetParam();
  robot.passes(1.0, Scene({{0.9f, -0.3f, 0.1f, -0.2f, 0.1f}}));
  ASSERT_NE(robot.control.remembered().back(), "");
  robot.passes(1.0, Scene({wall_before(2.0)}));
  EXPECT_EQ(robot.control.remembered().back(), "");
}

TEST(Upright, WhoIsRolledByHalfAQuarterIsNotTurnedToAndFro) {
  Upright upright;
  const Scene scene;
  for (int i = 0; i < 10; ++i) {
    const auto angle = static_cast<float>(0.7854 + (i % 2 == 0 ? 0.02 : -0.02));
    Placement placement;
    placement.rows = {
        {{std::cos(angle), -std::sin(angle), 0, 0}, {std::sin(angle), std::cos(angle), 0, 0}, {0, 0, 1, 0}}};
    upright.of(scene.view(), Outlook({}, placement));
    EXPECT_FALSE(upright.is_turned()) << i;
  }
}

TEST(Upright, WhatIsNotPlacedOrNoPictureIsLeftAsItIs) {
  Upright upright;
  const Scene scene;
  upright.of(scene.view(), Outlook());
  EXPECT_FALSE(upright.is_turned());
  const auto points = scene.returns();
  upright.of(view_of(points), Outlook({}, rolled(upright_xtion, {2, false, false})));
  EXPECT_FALSE(upright.is_turned());
}

}  // namespace
}  // namespace safety_control_cloud
