// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/look/settings.hpp"

#include <gtest/gtest.h>

#include "../sentences.hpp"

namespace safety_control_cloud {
namespace {

TEST(LookSettings, DefaultsAreFit) { EXPECT_TRUE(problems_of_defaults<LookSettings>().empty()); }

TEST(LookSettings, EveryContradictionIsNamed) {
  EXPECT_EQ(
      untold<LookSettings>({
          {"x_min must be less", [](LookSettings& s) { s.corridor.x_min = s.corridor.x_max; }},
          {"y_min must be less", [](LookSettings& s) { std::swap(s.corridor.y_min, s.corridor.y_max); }},
          {"range_min must not", [](LookSettings& s) { s.corridor.range_min = -0.1f; }},
          {"min_points must", [](LookSettings& s) { s.corridor.min_points = 0; }},
          {"left and right must", [](LookSettings& s) { s.frame_corridor.left = -s.frame_corridor.right; }},
          {"bottom must be less", [](LookSettings& s) { std::swap(s.frame_corridor.bottom, s.frame_corridor.top); }},
          {"with target_frame the corridor is",
           [](LookSettings& s) { s.target_frame = "base_footprint", s.corridor.x_max = 0.4f; }},
          {"must not begin with a slash", [](LookSettings& s) { s.target_frame = "/base_footprint"; }},
          {"need a target_frame", [](LookSettings& s) { s.frame_corridor.top = 0.6; }},
      }),
      std::vector<std::string>{});
}

TEST(LookSettings, CorridorInTheTargetFrameIsGivenByDistancesAndHeights) {
  LookSettings settings;
  settings.target_frame = "base_footprint";
  settings.frame_corridor = {0.4, 0.3, 0.1, 0.6};
  const Corridor corridor = corridor_of(settings);
  EXPECT_EQ(corridor.x_min, -0.4f) << "left";
  EXPECT_EQ(corridor.x_max, 0.3f) << "right";
  EXPECT_EQ(corridor.y_min, -0.6f) << "top: y points down";
  EXPECT_EQ(corridor.y_max, -0.1f) << "bottom";
}

TEST(LookSettings, MethodsAreFoundByTheirNames) {
  EXPECT_EQ(method_named("one_pass"), Method::OnePass);
  EXPECT_EQ(method_named("pcl"), Method::Pcl);
  EXPECT_FALSE(method_named("PCL"));
}

}  // namespace
}  // namespace safety_control_cloud
