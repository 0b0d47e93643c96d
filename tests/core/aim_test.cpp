// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/core/aim.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "../../safety_control_cloud/core/safety_control.hpp"
#include "scene.hpp"

namespace safety_control_cloud {
namespace {

/// A camera 0.3 m above the origin of its frame, turned from looking along x: yaw to the left, pitch down, roll.
Placing turned(double yaw, double pitch, double roll = 0.0, double height = 0.3) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  Eigen::Matrix3d optical;
  optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Eigen::Matrix3d turn =
      (AngleAxisd(yaw, Vector3d::UnitZ()) * AngleAxisd(pitch, Vector3d::UnitY()) * AngleAxisd(roll, Vector3d::UnitX()))
          .toRotationMatrix();
  Eigen::Matrix<double, 3, 4> place;
  place << turn * optical, Vector3d(-0.087, 0.0, height);
  return placing_of(place);
}

Decision decision_placed(const View& view, const Placing& placing) {
  Settings settings;
  settings.target_frame = "base_footprint";
  settings.near_loss.distance = 0.0;
  SafetyControl control{settings};
  const Reading reading = std::get<CloudView>(view);
  return control.decide(reading, Origin{1.0, placing}, Instant{1.0, 1.0});
}

constexpr double degree = 3.14159265358979 / 180.0;

TEST(Aim, CameraThatDoesNotLookDownTheCorridorDoesNotMoveTheRobot) {
  const Eigen::Matrix<double, 3, 4> identity = Eigen::Matrix<double, 3, 4>::Identity();
  const Scene scene;
  const std::vector<Xyz> anywhere(1000, Xyz{0.0f, 0.0f, 3.0f});
  for (const View& view : {View(scene.view()), View(view_of(anywhere))}) {
    for (const Placing& placing :
         {placing_of(identity), turned(90 * degree, 0), turned(180 * degree, 0), turned(-90 * degree, 0),
          turned(0, 90 * degree), turned(0, -90 * degree), turned(120 * degree, 0), turned(180 * degree, 0, 3.14)}) {
      const Decision decision = decision_placed(view, placing);
      EXPECT_EQ(decision.cause, Cause::WrongView) << decision.reason;
      EXPECT_EQ(decision.speed, 0.0);
    }
  }
  EXPECT_EQ(decision_placed(scene.view(), turned(60 * degree, 0)).cause, Cause::WrongView) << "by its own 60 degrees";
  EXPECT_EQ(decision_placed(scene.view(), turned(0, 50 * degree)).cause, Cause::WrongView) << "at its own feet";
}

TEST(Aim, CameraThatLooksDownTheCorridorIsBelievedHoweverItIsMounted) {
  const Scene scene;
  for (const Placing& placing :
       {turned(0, 0), turned(0, 0, 180 * degree), turned(0, 0, 90 * degree), turned(10 * degree, 0),
        turned(-20 * degree, 5 * degree), turned(0, 45 * degree, 0, 1.0), turned(0, 20 * degree, 0, 0.6)}) {
    const Decision decision = decision_placed(scene.view(), placing);
    EXPECT_EQ(decision.cause, Cause::Seen) << decision.reason;
  }
}

TEST(Aim, HowMuchOfTheCorridorIsSeenIsTold) {
  const Scene scene;
  const Outlook aside(Corridor{}, std::get<Placement>(turned(60 * degree, 0)));
  const auto doubt = doubt_about_aim(scene.view(), aside, ZoneLimits{});
  ASSERT_TRUE(doubt);
  EXPECT_NE(doubt->reason.find("sees 0 %"), std::string::npos) << doubt->reason;
}

TEST(Aim, CameraOfTheCorridorsOwnFrameLooksAheadByItself) {
  EXPECT_FALSE(doubt_about_aim(Scene{}.view(), Outlook{}, {}));
  EXPECT_FALSE(doubt_about_aim(Scene{}.view(), Outlook{}, {0.2, 0.1})) << "of which the picture holds nothing";
}

}  // namespace
}  // namespace safety_control_cloud
