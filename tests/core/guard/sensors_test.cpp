// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/sensors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../safety_control_cloud/core/settings.hpp"

namespace safety_control_cloud {
namespace {

Settings with(const Sensors& sensors) {
  Settings settings;
  settings.mode = Mode::Guard;
  settings.sensors = sensors;
  return settings;
}

bool mentions(const Settings& settings, const std::string& words) {
  const auto problems = problems_in(settings);
  return std::any_of(problems.begin(), problems.end(),
                     [&](const std::string& problem) { return problem.find(words) != std::string::npos; });
}

const SensorSettings front{"front", InputKind::Cloud, "front/points", true, {{"near_loss_distance", 0.6}}};
const SensorSettings laser{"laser", InputKind::Scan, "scan", false, {{"min_points", 2.0}, {"inf_is_free", 1.0}}};

TEST(Sensors, SeveralAreFit) {
  EXPECT_TRUE(problems_in(with({front, laser})).empty());
  EXPECT_EQ(sensors_of(with({front, laser})), (Sensors{front, laser}));
}

TEST(Sensors, WithoutAListThereIsTheOneOfInput) {
  Settings settings = with({});
  settings.input = InputKind::Depth;
  const Sensors sensors = sensors_of(settings);
  ASSERT_EQ(sensors.size(), std::size_t{1});
  EXPECT_EQ(sensors[0].name, "depth");
  EXPECT_EQ(sensors[0].type, InputKind::Depth);
  EXPECT_TRUE(sensors[0].required);
}

TEST(Sensors, EachHasItsOwnInPlaceOfThoseOfAll) {
  const Settings settings = with({front, laser});
  EXPECT_EQ(own_settings(settings, front).near_loss.distance, 0.6);
  EXPECT_EQ(own_settings(settings, laser).corridor.min_points, std::size_t{2});
  EXPECT_TRUE(own_settings(settings, laser).inf_is_free);
  EXPECT_FALSE(own_settings(settings, front).inf_is_free);
  EXPECT_EQ(own_settings(settings, front).corridor.min_points, std::size_t{1});
}

TEST(Sensors, EveryContradictionIsNamed) {
  const auto changed = [](SensorSettings sensor, auto harm) {
    harm(sensor);
    return sensor;
  };
  EXPECT_TRUE(mentions(with({front, front}), "two are named front"));
  EXPECT_TRUE(mentions(with({front, changed(front, [](auto& s) { s.name = "b"; })}), "two have the topic"));
  EXPECT_TRUE(mentions(with({changed(front, [](auto& s) { s.name = ""; })}), "is no name"));
  EXPECT_TRUE(mentions(with({changed(front, [](auto& s) { s.name = "a/b"; })}), "is no name"));
  EXPECT_TRUE(mentions(with({changed(front, [](auto& s) { s.topic = ""; })}), "front: topic must not be empty"));
  EXPECT_TRUE(mentions(with({changed(front, [](auto& s) { s.own["max_speed"] = 1.0; })}), "a cloud has no max_speed"));
  EXPECT_TRUE(
      mentions(with({changed(laser, [](auto& s) { s.own["blind_range"] = 1.0; })}), "a scan has no blind_range"));
  EXPECT_TRUE(mentions(with({changed(front, [](auto& s) { s.own["source_timeout"] = 3600.0; })}),
                       "front: source_timeout must be at most 10"));
  EXPECT_TRUE(
      mentions(with({changed(front, [](auto& s) { s.own["noise"] = std::nan(""); })}), "front: noise must be finite"));
  EXPECT_TRUE(
      mentions(with({changed(laser, [](auto& s) { s.own["min_points"] = 0.0; })}), "laser: min_points must be"));
  EXPECT_TRUE(mentions(with({changed(laser, [](auto& s) { s.own["min_points"] = -1.0; })}), "laser: min_points must"));
  EXPECT_TRUE(mentions(with({changed(laser, [](auto& s) { s.own["min_points"] = 1.5; })}), "laser: min_points must"));
}

TEST(Sensors, AreOfModeGuard) {
  Settings settings = with({front});
  settings.mode = Mode::Drive;
  EXPECT_TRUE(mentions(settings, "sensors are of mode guard"));
  Settings scan;
  scan.input = InputKind::Scan;
  EXPECT_TRUE(mentions(scan, "input scan is of mode guard"));
  scan.mode = Mode::Guard;
  EXPECT_TRUE(problems_in(scan).empty());
}

}  // namespace
}  // namespace safety_control_cloud
