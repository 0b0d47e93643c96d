// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/near_returns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "robot_with_sensors.hpp"

namespace safety_control_cloud {
namespace {

const Vicinity around{0.05, 0.6, 1.0, {}};

/// Of a laser in the middle of a robot that stands at `pose` as the scan begins.
struct Turn360 {
  std::vector<float> ranges = std::vector<float>(360, 5.0f);
  ScanPoints scans;

  std::vector<NearReturn> near(const Vicinity& vicinity, const Pose2& pose, const Pose2& meanwhile) {
    Scan scan;
    scan.angle_min = -pi, scan.angle_increment = 2.0 * pi / 360.0, scan.angle_max = pi - scan.angle_increment;
    scan.range_min = 0.1, scan.range_max = 10.0;
    scan.ranges = ranges.data(), scan.size = ranges.size();
    const Reading reading = scans.of(scan);
    Corridor corridor;
    corridor.range_min = std::numeric_limits<float>::lowest();  // a scan's points lie to all sides
    const Outlook outlook(corridor, std::get<Placement>(laser_at(0.2)));
    return near_returns({reading, std::get<ScanView>(reading).points, outlook, 0.0, 0.3, 0.1}, vicinity, pose,
                        meanwhile);
  }
};

TEST(NearReturns, AreThoseOfTheVicinityAndNotOfTheRobotItself) {
  Turn360 laser;
  laser.ranges[180] = 0.5f, laser.ranges[270] = 0.7f, laser.ranges[0] = 1.2f;
  const auto near = laser.near(around, {{3.0, 1.0}, 0.5 * pi}, {});
  ASSERT_EQ(near.size(), 2u);
  EXPECT_NEAR(near[0].place.x, 3.0, 1e-6) << "what is ahead of a robot that looks left";
  EXPECT_NEAR(near[0].place.y, 1.5, 1e-6);
  EXPECT_NEAR(near[0].height, 0.2, 1e-6);
  EXPECT_NEAR(near[1].range, 0.7, 1e-6);
  Vicinity low = around, own = around;
  low.top = 0.1;
  own.self = {{0.4, 0.6, -0.1, 0.1, 0.0, 1.0}};
  EXPECT_TRUE(laser.near(low, {}, {}).empty());
  EXPECT_EQ(laser.near(own, {}, {}).size(), 1u);
}

/// Such a look takes each sixth row, and some of those midway.
TEST(NearReturns, NoThreeRowsOfALargePictureAreLeftOutForLong) {
  for (const std::size_t begun : {0u, 5u}) {
    std::set<std::size_t> all;
    for (std::size_t look = begun; look < begun + 8; ++look) {
      const auto rows = rows_looked_at(480, look);
      EXPECT_EQ(rows.size(), 90u);
      EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
      all.insert(rows.begin(), rows.end());
    }
    for (std::size_t row = 0; row < 480; row += 3) EXPECT_EQ(all.count(row), 1u) << row;
  }
  EXPECT_EQ(rows_looked_at(240, 0), rows_looked_at(240, 1)) << "which is looked at each third row";
}

TEST(NearReturns, EachBeamHasItsOwnMoment) {
  Turn360 laser;
  laser.ranges[90] = laser.ranges[270] = 0.5f;
  const auto near = laser.near(around, {}, {{0.0, 0.0}, 0.4});
  ASSERT_EQ(near.size(), 2u);
  EXPECT_NEAR(std::atan2(near[0].place.y, near[0].place.x), -0.5 * pi + 0.1, 1e-6) << "after a quarter of the scan";
  EXPECT_NEAR(std::atan2(near[1].place.y, near[1].place.x), 0.5 * pi + 0.3, 1e-6);
}

}  // namespace
}  // namespace safety_control_cloud
