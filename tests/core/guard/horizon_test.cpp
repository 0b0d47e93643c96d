// SPDX-License-Identifier: BSD-3-Clause
// How far a sensor sees along the ground, and when a robot comes to the end of that.
#include "../../../safety_control_cloud/core/guard/horizon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <variant>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr Heights heights{0.05, 0.55};
const Point2 ahead{1.0, 0.0}, behind{-1.0, 0.0}, left{0.0, 1.0};

Outlook outlook_at(const Placing& placing) { return {{}, std::get<Placement>(placing)}; }

ScanView scan_of(double range_max, double first = -pi, double last = pi) {
  ScanView scan{};
  scan.first = first, scan.last = last, scan.range_max = range_max;
  return scan;
}

/// Pitched down [rad], 0.3 m above the floor.
Outlook camera_pitched(double down) {
  const double c = std::cos(down), s = std::sin(down);
  Eigen::Matrix<double, 3, 4> place;
  place << 0, -s, c, 0, -1, 0, 0, 0, 0, -c, -s, 0.3;
  return outlook_at(placing_of(place));
}

FieldOfView degrees_high(double height) {
  const double half = std::tan(0.5 * height * pi / 180.0);
  return {-0.55, 0.55, -half, half};
}

TEST(Horizon, ALevelLaserSeesAsFarAsItMeasures) {
  const Horizon horizon(outlook_at(laser_at(0.2)), scan_of(1.5), heights);
  for (const Point2& direction : {ahead, behind, left}) EXPECT_NEAR(horizon.towards(direction), 1.5, 1e-6);
  EXPECT_NEAR(horizon.least(), 1.5, 1e-6);
}

TEST(Horizon, OneThatIsTiltedSeesAsFarAsItsPlaneLiesBetweenTheHeights) {
  const double tilt = 12.0 * pi / 180.0;
  const Horizon down(outlook_at(laser_at(0.2, tilt)), scan_of(10.0), heights);
  EXPECT_NEAR(down.towards(ahead), 0.15 / std::tan(tilt), 1e-4) << "there it meets what is too low";
  EXPECT_NEAR(down.towards(behind), 0.35 / std::tan(tilt), 1e-4) << "there what is too high";
  EXPECT_NEAR(down.towards(left), 10.0, 1e-4);
  EXPECT_NEAR(down.least(), 0.15 / std::tan(tilt), 1e-4);
  const Horizon near(outlook_at(laser_at(0.2, tilt)), scan_of(0.5), heights);
  EXPECT_NEAR(near.towards(ahead), 0.5 * std::cos(tilt), 1e-4) << "along the ground";
}

TEST(Horizon, UpsideDownItSeesAsFar) {
  const double tilt = 0.2, c = std::cos(tilt), s = std::sin(tilt);
  Eigen::Matrix<double, 3, 4> place;
  place << c, 0, -s, 0, 0, -1, 0, 0, -s, 0, -c, 0.2;
  const Horizon horizon(outlook_at(placing_of(place)), scan_of(10.0), heights);
  EXPECT_NEAR(horizon.towards(ahead), 0.15 / std::tan(tilt), 1e-4);
  EXPECT_NEAR(horizon.towards(behind), 0.35 / std::tan(tilt), 1e-4);
}

TEST(Horizon, ACameraSeesWithoutEndUnlessAllOfItLooksDownOrUp) {
  for (const double pitch : {-0.3, 0.0, 0.3}) {
    const Horizon horizon(camera_pitched(pitch), degrees_high(45.0), heights);
    EXPECT_EQ(horizon.towards(ahead), inf) << pitch;
  }
  const Horizon down(camera_pitched(0.7), degrees_high(45.0), heights);
  EXPECT_NEAR(down.towards(ahead), 0.25 / std::tan(0.7 - 22.5 * pi / 180.0), 1e-4) << "by its highest row";
  const Horizon up(camera_pitched(-0.7), degrees_high(45.0), heights);
  EXPECT_NEAR(up.towards(ahead), 0.25 / std::tan(0.7 - 22.5 * pi / 180.0), 1e-4) << "by its lowest";
  const Horizon at_the_floor(camera_pitched(pi / 2.0), degrees_high(45.0), heights);
  EXPECT_NEAR(at_the_floor.towards({}), 0.25 * 0.55, 1e-3) << "by its widest";
}

struct TimeToHorizon : testing::Test {
  const Outline outline{Footprint{{}, 0.2, 0.05}};
  Sighted with_range(double range, double first = -pi, double last = pi) const {
    const Outlook outlook = outlook_at(laser_at(0.2));
    const ScanView scan = scan_of(range, first, last);
    return {eye_of(outlook, scan, {}), Horizon(outlook, scan, heights)};
  }
};

TEST_F(TimeToHorizon, IsThatToTheEndOfWhatIsSeenWithTheMargin) {
  EXPECT_NEAR(time_to_horizon(outline, {with_range(1.0)}, {0.5, 0.0, 0.0}, 5.0), 1.5, 1e-2);
  EXPECT_NEAR(time_to_horizon(outline, {with_range(1.0)}, {-0.5, 0.0, 0.0}, 5.0), 1.5, 1e-2);
  Sighted late = with_range(1.0);
  late.nearer = 0.25;
  EXPECT_NEAR(time_to_horizon(outline, {late}, {0.5, 0.0, 0.0}, 5.0), 1.0, 1e-2);
}

TEST_F(TimeToHorizon, IsInfiniteWhereTheRobotStandsBefore) {
  EXPECT_EQ(time_to_horizon(outline, {with_range(1.0)}, {0.5, 0.0, 0.0}, 1.4), inf);
  EXPECT_EQ(time_to_horizon(outline, {with_range(0.3)}, {0.0, 0.0, 2.0}, 5.0), inf) << "a circle turns on its ground";
}

TEST_F(TimeToHorizon, IsThatOfTheSensorThatSeesFarthestThere) {
  EXPECT_EQ(time_to_horizon(outline, {with_range(1.0), with_range(9.0)}, {0.5, 0.0, 0.0}, 5.0), inf);
  const std::vector<Sighted> other_side = {with_range(1.0), with_range(9.0, pi - 0.5, pi + 0.5)};
  EXPECT_NEAR(time_to_horizon(outline, other_side, {0.5, 0.0, 0.0}, 5.0), 1.5, 1e-2);
}

TEST_F(TimeToHorizon, IsNoneWhereNobodyLooks) {
  EXPECT_EQ(time_to_horizon(outline, {with_range(1.0, -0.5, 0.5)}, {-0.5, 0.0, 0.0}, 5.0), inf);
  EXPECT_EQ(time_to_horizon(outline, {}, {0.5, 0.0, 0.0}, 5.0), inf);
}

/// A base that brakes as the guard takes it to; the laser in its middle shows what is within its range, or its plane.
double comes_so_near(double range_max, double tilt, double speed) {
  Settings settings = guard_settings();
  settings.sensors = {{"laser", InputKind::Scan, "scan", true, {{"noise", 0.02}}}};
  settings.max_speed = 1.5;
  RobotWithSensors robot(settings);
  robot.laser_place = laser_at(0.2, tilt);
  robot.range_max = range_max;
  double front = 1.6, driven = 0.0;
  for (int i = 0; i < 1000; ++i) {
    if (i % 3 == 0) {
      for (std::size_t degree = 0; degree < 360; ++degree) {
        const double bearing = -pi + static_cast<double>(degree) * pi / 180.0;
        const double ahead_of_it = std::cos(bearing);
        if (ahead_of_it < 0.3) {
          robot.ranges[degree] = 0.38f;  // the sides of a corridor, and whoever walks behind: it is never blind
          continue;
        }
        const double to_wall = (front + 0.18) / ahead_of_it / std::cos(tilt);
        const double to_floor = tilt > 0.0 ? 0.2 / std::sin(tilt) / ahead_of_it : inf;
        robot.ranges[degree] = static_cast<float>(std::min(to_wall, to_floor));
      }
      robot.see_scan(0);
    }
    robot.control.note_odometry(robot.now.ros, {{1.6 - front, 0.0}, 0.0}, {driven, 0.0, 0.0});
    const double given = robot.wants({speed, 0.0, 0.0}).given.linear[0];
    driven += std::clamp(given - driven, -0.0072, 0.02);
    front -= 0.02 * driven;
    robot.pass(0.02);
  }
  return front;
}

TEST(Horizon, WhoseLaserSeesNotFarComesToNoWallFasterThanItStops) {
  for (const double speed : {0.7, 1.5}) {
    for (const double range : {0.4, 0.8, 10.0}) {
      const double front = comes_so_near(range, 0.0, speed);
      EXPECT_GT(front, 0.0) << speed << " m/s, " << range << " m";
      EXPECT_LT(front, 0.3) << speed << " m/s, " << range << " m: it comes there at all";
    }
    EXPECT_GT(comes_so_near(10.0, 12.0 * pi / 180.0, speed), 0.0) << speed << " m/s, tilted";
  }
}

}  // namespace
}  // namespace safety_control_cloud
