// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/input/scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "../../../safety_control_cloud/core/input/point_reader.hpp"

namespace safety_control_cloud {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
constexpr double quarter = 1.5707963267948966;

/// From the right over ahead to the left.
struct Turn {
  std::vector<float> ranges;
  Scan scan;

  explicit Turn(std::vector<float> values) : ranges(std::move(values)) {
    scan.angle_min = -quarter, scan.angle_max = quarter;
    scan.angle_increment = 2.0 * quarter / static_cast<double>(ranges.size() - 1);
    scan.time_increment = 1e-3, scan.scan_time = 0.1;
    scan.range_min = 0.1, scan.range_max = 10.0;
    scan.ranges = ranges.data(), scan.size = ranges.size();
  }
};

std::vector<Point> points_in(const CloudView& view) {
  std::vector<Point> points;
  for_each_point(View(view), [&](float x, float y, float z) { points.emplace_back(x, y, z); });
  return points;
}

TEST(Scan, ABeamIsAPointAtItsBearing) {
  Turn turn({1.0f, 2.0f, 3.0f});
  ScanPoints scans;
  const ScanView view = scans.of(turn.scan);
  const auto points = points_in(view.points);
  ASSERT_EQ(points.size(), std::size_t{3});
  EXPECT_NEAR(points[0].y, -1.0, 1e-6);
  EXPECT_NEAR(points[1].x, 2.0, 1e-6);
  EXPECT_NEAR(points[2].y, 3.0, 1e-6);
  for (const Point& point : points) EXPECT_EQ(point.z, 0.0f);
  EXPECT_DOUBLE_EQ(view.first, -quarter);
  EXPECT_DOUBLE_EQ(view.last, quarter);
  EXPECT_DOUBLE_EQ(view.lasts, 2e-3);
}

TEST(Scan, AScannerUpsideDownTurnsTheOtherWay) {
  Turn turn({1.0f, 2.0f, 3.0f});
  std::swap(turn.scan.angle_min, turn.scan.angle_max);
  turn.scan.angle_increment *= -1.0;
  ScanPoints scans;
  const ScanView view = scans.of(turn.scan);
  EXPECT_NEAR(points_in(view.points)[0].y, 1.0, 1e-6);
  EXPECT_LT(view.first, view.last);
}

TEST(Scan, RangesMeanWhatREP117Says) {
  Turn turn({nan, -inf, inf, 0.0f, 0.09f, 10.1f, -1.0f, 0.1f, 10.0f});
  ScanPoints scans;
  const ScanView view = scans.of(turn.scan);
  const auto points = points_in(view.points);
  for (const std::size_t i : {0u, 3u, 4u, 5u, 6u}) EXPECT_TRUE(std::isnan(points[i].z)) << i;
  EXPECT_EQ(points[1].z, -inf) << "too close";
  EXPECT_TRUE(std::isnan(points[2].z)) << "nothing measured";
  EXPECT_EQ(points[7].z, 0.0f);
  EXPECT_EQ(points[8].z, 0.0f);
  CloudView free = view.points;
  free.offset[2] = view.z_if_inf_is_free;
  const auto seen = points_in(free);
  EXPECT_EQ(seen[2].z, 0.0f);
  EXPECT_GT(std::hypot(seen[2].x, seen[2].y), 1e3f) << "nothing there, far away";
  EXPECT_TRUE(std::isnan(seen[0].z));
  EXPECT_EQ(seen[1].z, -inf);
}

TEST(Scan, ZeroMaySayWhatInfinitySays) {
  for (const double range_min : {0.1, 0.0}) {
    Turn turn({0.0f, 1.0f, inf, nan, -inf});
    turn.scan.range_min = range_min;
    ScanPoints scans;
    const ScanView view = scans.of(turn.scan);
    const auto z_at = [&](std::size_t offset, std::size_t i) {
      CloudView as = view.points;
      as.offset[2] = offset;
      return points_in(as)[i].z;
    };
    const std::size_t as_it_is = view.points.offset[2];
    for (const std::size_t offset : {as_it_is, view.z_if_inf_is_free}) {
      const float z = z_at(offset, 0);
      EXPECT_TRUE(range_min > 0.0 ? std::isnan(z) : z == -inf) << z;
    }
    EXPECT_EQ(z_at(view.z_if_both, 0), 0.0f);
    EXPECT_TRUE(std::isnan(z_at(view.z_if_zero_is_inf, 0))) << "nothing measured";
    const Point there = points_in(view.points)[0];
    EXPECT_GT(std::hypot(there.x, there.y), 1e3f) << "far away";
    EXPECT_EQ(z_at(view.z_if_both, 2), 0.0f);
    EXPECT_TRUE(std::isnan(z_at(view.z_if_zero_is_inf, 2)));
    for (const std::size_t offset : {view.z_if_both, view.z_if_zero_is_inf}) {
      EXPECT_EQ(z_at(offset, 1), 0.0f);
      EXPECT_TRUE(std::isnan(z_at(offset, 3)));
      EXPECT_EQ(z_at(offset, 4), -inf);
    }
  }
}

TEST(Scan, TheLastBeamMayBeAngleMaxOrTheOneBefore) {
  for (const double steps : {0.0, 1.0, -1.0}) {
    Turn turn(std::vector<float>(100, 1.0f));
    turn.scan.angle_max += steps * turn.scan.angle_increment;
    EXPECT_NO_THROW(ScanPoints().of(turn.scan)) << steps;
  }
}

/// As a float32 a whole turn is more than itself, and in files it is 6.28319.
TEST(Scan, AWholeTurnMayBeginAndEndAnywhere) {
  const double turn_as_float = 6.2831854820251465;
  for (const auto& [first, last] : {std::pair(0.0, turn_as_float), std::pair(0.0, 6.28319), std::pair(-6.28319, 0.0),
                                    std::pair(-turn_as_float, 0.0), std::pair(turn_as_float, 0.0)}) {
    Turn turn(std::vector<float>(360, 1.0f));
    turn.scan.angle_min = first, turn.scan.angle_max = last;
    for (const double beams : {359.0, 360.0}) {
      turn.scan.angle_increment = (last - first) / beams;
      EXPECT_NO_THROW(ScanPoints().of(turn.scan)) << first << " to " << last << ", " << beams;
    }
  }
}

TEST(Scan, EveryContradictionIsRefused) {
  const double bad_numbers[] = {std::nan(""), static_cast<double>(inf), -static_cast<double>(inf)};
  std::vector<std::function<void(Scan&)>> harms = {
      [](Scan& s) { s.size = 0; },
      [](Scan& s) { s.angle_increment = 0.0; },
      [](Scan& s) { s.angle_increment = 1e-45, s.angle_max = s.angle_min; },
      [](Scan& s) { s.angle_increment *= 0.5; },
      [](Scan& s) { s.angle_increment *= -1.0; },
      [](Scan& s) { s.angle_min -= 0.7; },
      [](Scan& s) { s.size -= 3; },
      [](Scan& s) { s.angle_min = -50.0, s.angle_max = 50.0, s.angle_increment = 100.0 / 8.0; },
      [](Scan& s) { s.range_min = -0.1; },
      [](Scan& s) { s.range_max = s.range_min; },
      [](Scan& s) { s.time_increment = -1e-3; },
      [](Scan& s) { s.time_increment = 5.0; },
      [](Scan& s) { s.scan_time = -1.0; },
      [](Scan& s) { s.scan_time = 60.0; },
  };
  for (const double bad : bad_numbers) {
    harms.push_back([bad](Scan& s) { s.angle_min = bad; });
    harms.push_back([bad](Scan& s) { s.angle_max = bad; });
    harms.push_back([bad](Scan& s) { s.angle_increment = bad; });
    harms.push_back([bad](Scan& s) { s.time_increment = bad; });
    harms.push_back([bad](Scan& s) { s.scan_time = bad; });
    harms.push_back([bad](Scan& s) { s.range_min = bad; });
  }
  harms.push_back([](Scan& s) { s.range_max = std::nan(""); });
  for (std::size_t i = 0; i < harms.size(); ++i) {
    Turn turn(std::vector<float>(9, 1.0f));
    harms[i](turn.scan);
    EXPECT_THROW(ScanPoints().of(turn.scan), std::invalid_argument) << i;
  }
}

}  // namespace
}  // namespace safety_control_cloud
