// SPDX-License-Identifier: BSD-3-Clause
// kept_places_test has what becomes of a robot by it.
#include "../../../safety_control_cloud/core/guard/recalled_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../../../safety_control_cloud/core/input/angle.hpp"

namespace safety_control_cloud {
namespace {

const SensorSettings front{"front", InputKind::Cloud, "points", true, {}},
    depth{"depth", InputKind::Depth, "d", true, {}}, laser{"front", InputKind::Scan, "scan", true, {}};

TEST(RecalledPlaces, AreThoseOfTheSensorThatHasTheNameOrElseOfACamera) {
  KeptPlaces kept;
  kept.sensors = written_names({front, depth, laser});
  EXPECT_EQ(kept.sensors, (std::vector<std::string>{"front", "depth", "scan/front"}));
  for (std::size_t i = 0; i < 3; ++i) kept.all.push_back({{}, 0.3, 0.0, i});
  const auto of = [&](const Sensors& sensors) {
    std::vector<std::size_t> by_now;
    for (const KeptPlace& place : shown_by(sensors, kept)) by_now.push_back(place.sensor);
    return by_now;
  };
  EXPECT_EQ(of({laser, depth, front}), (std::vector<std::size_t>{2, 1, 0})) << "by name, and a scan is no camera";
  EXPECT_EQ(of({laser, front}), (std::vector<std::size_t>{1, 1, 0})) << "a camera takes over whose camera has gone";
  EXPECT_EQ(of({laser}), (std::vector<std::size_t>{0, 0, 0})) << "or whatever there is";
}

TEST(RecalledPlaces, AreSeenFromWhereTheRobotWasIfItCanHaveComeFromThere) {
  const Twist2 fastest{0.5, 0.0, 1.0};
  KeptPlaces kept;
  kept.stamp = 100.0;
  kept.robot = Pose2{{1.0, 2.0}, 3.0};
  const auto from = [&](double x, double heading, double stamp) {
    return seen_from(kept, {{x, 2.0}, heading}, stamp, fastest);
  };
  ASSERT_TRUE(from(1.0, 3.0 + 3.0 * full_turn, 100.0)) << "each process counts its own full turns";
  EXPECT_NEAR(from(1.0, 3.0 + 3.0 * full_turn, 100.0)->heading, 3.0 + 3.0 * full_turn, 1e-9);
  EXPECT_TRUE(from(1.9, 3.0, 102.0));
  EXPECT_FALSE(from(2.3, 3.0, 102.0));
  EXPECT_FALSE(from(1.9, 3.0, 90.0)) << "no time before then is any way";
  EXPECT_TRUE(from(1.0, 4.0, 101.0));
  EXPECT_FALSE(from(1.0, 4.5, 101.0));
  EXPECT_FALSE(from(NAN, 3.0, 102.0));
  EXPECT_FALSE(from(1.0, NAN, 102.0));
  kept.robot.reset();
  EXPECT_FALSE(from(1.0, 3.0, 100.0)) << "nobody knows in which frame it was";
}

}  // namespace
}  // namespace safety_control_cloud
