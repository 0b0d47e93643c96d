// SPDX-License-Identifier: BSD-3-Clause
/// A picture whose rays change, and one whose middle does not look straight ahead.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "../../../safety_control_cloud/core/safety_control.hpp"
#include "lens.hpp"

namespace safety_control_cloud {
namespace {

const Board wall = {2.5f, -9.0f, 9.0f, -9.0f, floor_y};

enum class Form { Picture, Depths, Points };

/// A robot that looks through any lens, a cloud every 50 ms, of which one pixel in so many is missing.
class Looking {
 public:
  explicit Looking(unsigned missing = 10, const Settings& settings = {}) : control_(settings), missing_(missing) {}

  Decision sees(const std::vector<Board>& boards, const Lens& lens, Form form) {
    now_ += 0.05;
    auto points = lens.points(boards);
    for (Xyz& point : points) point = random_() % missing_ == 0 ? Xyz{nan, nan, nan} : point;
    const auto depths = Lens::depths(points);
    if (form == Form::Points) {
      points.erase(std::remove_if(points.begin(), points.end(), [](const Xyz& p) { return std::isnan(p.z); }),
                   points.end());
      return decide(view_of(points));
    }
    if (form == Form::Depths) return decide(lens.view_of_depths(depths));
    return decide(lens.view_of_rows(points));
  }

  /// A thing comes as near as `to` [m], which is nearer than the camera sees.
  template <class At>
  Decision comes(At at, float to, const Lens& lens, Form form) {
    for (int i = 0; i < 6; ++i) sees({wall}, lens, form);
    for (float z = 0.6f; z > to; z -= 0.02f) sees({at(z), wall}, lens, form);
    return sees({at(to), wall}, lens, form);
  }

  Decision decide(const Reading& reading) { return control_.decide(reading, Origin{now_}, Instant{now_, now_}); }
  SafetyControl& control() { return control_; }

 private:
  SafetyControl control_;
  double now_ = 100.0;
  std::mt19937 random_{3};
  unsigned missing_;
};

/// A rail across the corridor, from y on.
auto rail(float y, float height = 0.03f) {
  return [=](float z) { return Board{z, -0.28f, 0.28f, y, y + height}; };
}
/// What hangs, around x.
auto hanging(float x, float width, float bottom) {
  return [=](float z) { return Board{z, x - width / 2, x + width / 2, -0.3f, bottom}; };
}

class OtherRays : public testing::TestWithParam<Form> {
 protected:
  template <class At>
  void stays(At at, const Lens& before, const Lens& after, Form then, const std::string& what) {
    Looking robot;
    ASSERT_EQ(robot.comes(at, 0.36f, before, GetParam()).speed, 0.0) << what;
    for (int i = 0; i < 25; ++i) ASSERT_EQ(robot.sees({at(0.36f), wall}, after, then).speed, 0.0) << what << ", " << i;
  }
  template <class At>
  void stays(At at, const Lens& before, const Lens& after, const std::string& what) {
    stays(at, before, after, GetParam(), what);
  }
};
INSTANTIATE_TEST_SUITE_P(As, OtherRays, testing::Values(Form::Picture, Form::Depths),
                         [](const auto& info) { return info.param == Form::Picture ? "Picture" : "Depths"; });

TEST_P(OtherRays, WhatIsLostStaysWhenTheSameSizeShowsAnotherPartOfThePicture) {
  const Lens whole, fine = whole.scaled(2.0);
  for (const float x : {-0.14f, -0.12f, -0.1f, 0.1f, 0.13f}) {
    const auto hung = hanging(x, 0.04f, 0.12f);
    const auto all_stay = [&](const Lens& lens, std::size_t left, std::size_t shift) {
      const std::size_t columns = 3 * lens.width / 4, top = lens.height / 12, rows = 10 * top;
      const Lens one = lens.part(left, top, columns, rows), other = lens.part(left + shift, top, columns, rows);
      const std::string what = std::to_string(x) + " from " + std::to_string(left) + " by " + std::to_string(shift);
      if (one.shows_column(x / 0.36)) stays(hung, one, other, what);
      if (other.shows_column(x / 0.36)) stays(hung, other, one, what + " back");
    };
    for (const std::size_t shift : {3, 6, 12, 20}) {
      all_stay(whole, 20, shift);
      all_stay(whole, 0, 2 * shift);
      all_stay(fine, 40, shift);
    }
  }
  for (const float y : {-0.1f, -0.05f, 0.03f, 0.06f}) {
    stays(rail(y), whole.part(20, 0, 120, 100), whole.part(20, 20, 120, 100), std::to_string(y) + " lower");
    stays(rail(y), whole.part(20, 20, 120, 100), whole.part(20, 0, 120, 100), std::to_string(y) + " higher");
  }
}

TEST_P(OtherRays, WhatIsLostStaysWhenTheLensChanges) {
  const auto hung = [](float x) { return [x](float z) { return Board{z, x, x + 0.03f, -0.1f, 0.1f}; }; };
  for (const auto& [one, other] : {std::pair{86.0, 42.0}, {60.0, 50.0}, {56.0, 75.0}}) {
    for (const float x : {-0.09f, -0.06f, 0.03f, 0.06f, 0.09f}) {
      const std::string what = std::to_string(x) + ", " + std::to_string(one) + " and " + std::to_string(other);
      stays(hung(x), Lens::of(one), Lens::of(other), what);
      stays(hung(x), Lens::of(other), Lens::of(one), what + " back");
      stays(hung(x), Lens::of(one), Lens::of(other).scaled(0.5), what + ", coarser");
      stays(hung(x), Lens::of(one), Lens::of(other).scaled(2.0), what + ", finer");
    }
  }
}

TEST_P(OtherRays, WhatLiesBesideTheNewPictureHasNotGone) {
  const Lens whole;
  for (const unsigned missing : {10, 4, 3}) {
    const auto stay = [&](auto at, const Lens& after, float where) {
      Looking robot(missing);
      robot.comes(at, 0.36f, whole, GetParam());
      for (int i = 0; i < 40; ++i)
        ASSERT_EQ(robot.sees({at(0.36f), wall}, after, GetParam()).cause, Cause::NearLoss)
            << where << " in " << after.width << " x " << after.height << ", one missing of " << missing;
    };
    for (const float y : {0.05f, 0.06f, 0.07f, 0.08f}) stay(rail(y), whole.part(0, 0, 160, 80), y);
    for (const float y : {-0.14f, -0.11f, -0.08f}) stay(rail(y), whole.part(0, 40, 160, 80), y);
    for (const float x : {0.1f, 0.14f, 0.18f}) {
      stay(hanging(x, 0.03f, 0.1f), whole.part(0, 0, 110, 120), x);
      stay(hanging(-x, 0.03f, 0.1f), whole.part(50, 0, 110, 120), -x);
    }
  }
}

TEST_P(OtherRays, WhatLayBesideThePictureIsSeenToHaveGoneWhenItShowsItsPlaceAgain) {
  const Lens whole, upper = whole.part(0, 0, 160, 80);
  Looking robot;
  const auto at = rail(0.08f);
  robot.comes(at, 0.36f, whole, GetParam());
  for (int i = 0; i < 10; ++i) EXPECT_EQ(robot.sees({wall}, upper, GetParam()).speed, 0.0);
  for (int i = 0; i < 5; ++i) robot.sees({wall}, whole, GetParam());
  EXPECT_EQ(robot.sees({wall}, whole, GetParam()).speed, 0.2);
}

TEST_P(OtherRays, WhatIsLostIsSeenToHaveGoneInAnotherPictureThatShowsItsPlace) {
  const Lens whole;
  for (const Lens& after : {whole.part(10, 8, 140, 106), whole.scaled(0.5), whole.scaled(2.0), Lens::of(75.0)}) {
    Looking robot;
    const auto box = [](float z) { return Board{z, 0.0f, 0.1f, -0.08f, 0.05f}; };
    ASSERT_EQ(robot.comes(box, 0.36f, whole, GetParam()).speed, 0.0);
    for (int i = 0; i < 5; ++i) robot.sees({wall}, after, GetParam());
    EXPECT_EQ(robot.sees({wall}, after, GetParam()).speed, 0.2) << after.width << ", " << after.focal;
  }
}

TEST_P(OtherRays, APostHasGoneWhenTheFloorIsSeenAgainThoughThePictureEndsLower) {
  const Lens whole;
  Looking robot;
  const auto at = [](float z) { return post(z, 0.0f); };
  robot.sees({}, whole, GetParam());
  for (const float z : {0.6f, 0.5f, 0.42f, 0.36f}) robot.sees({at(z)}, whole, GetParam());
  for (int i = 0; i < 5; ++i) robot.sees({}, whole.part(0, 50, 160, 70), GetParam());
  EXPECT_EQ(robot.sees({}, whole.part(0, 50, 160, 70), GetParam()).speed, 0.2);
}

TEST_P(OtherRays, WhatWasWatchedFarAwayHasNotVanishedWhenThePictureNoLongerShowsIt) {
  const Lens whole;
  Looking robot;
  const Board far = {1.0f, -0.2f, 0.2f, 0.05f, 0.15f};
  for (int i = 0; i < 10; ++i) robot.sees({far, wall}, whole, GetParam());
  for (int i = 0; i < 10; ++i) EXPECT_EQ(robot.sees({wall}, whole.part(0, 0, 160, 65), GetParam()).speed, 0.2);
}

TEST_P(OtherRays, MostOfAThingThatStopsReturningAfterAZoomIsAllOfIt) {
  const Board box = {0.6f, -0.12f, 0.12f, -0.15f, 0.1f}, too_near = {0.3f, -0.03f, 0.07f, -0.08f, 0.06f};
  Looking robot;
  for (int i = 0; i < 5; ++i) robot.sees({box, wall}, Lens::of(42.0), GetParam());
  for (int i = 0; i < 5; ++i) EXPECT_EQ(robot.sees({box, wall}, Lens::of(86.0), GetParam()).speed, 0.1) << "in sight";
  EXPECT_EQ(robot.sees({box, too_near, wall}, Lens::of(86.0), GetParam()).speed, 0.0);
}

TEST_P(OtherRays, ABorderThatNeverReturnedIsNoneOfAnotherPicture) {
  const Lens whole, wider = Lens::of(62.0);
  const Board border = {0.3f, -9.0f, 0.3f * -0.47f, -9.0f, 9.0f};
  const auto cable = [](float z) { return Board{z, -0.185f, -0.155f, -0.3f, 0.1f}; };
  Looking robot;
  for (int i = 0; i < 70; ++i) robot.sees({border, wall}, whole, GetParam());
  for (const float z : {0.5f, 0.46f, 0.42f}) robot.sees({cable(z), wall}, wider, GetParam());
  for (int i = 0; i < 12; ++i) EXPECT_EQ(robot.sees({cable(0.34f), wall}, wider, GetParam()).speed, 0.0) << i;
}

TEST_P(OtherRays, PointsInNoOrderThatBecomeAPictureOfAnotherLensKeepWhatIsLost) {
  for (const float x : {-0.09f, 0.03f, 0.06f}) {
    const auto hung = [x](float z) { return Board{z, x, x + 0.03f, -0.1f, 0.1f}; };
    for (const Lens& lens : {Lens{}, Lens::of(42.0), Lens::of(80.0), Lens{}.part(20, 20, 120, 90)}) {
      for (const auto& [one, other] : {std::pair{Form::Points, GetParam()}, {GetParam(), Form::Points}}) {
        Looking robot;
        ASSERT_EQ(robot.comes(hung, 0.36f, lens, one).speed, 0.0);
        for (int i = 0; i < 25; ++i)
          ASSERT_EQ(robot.sees({hung(0.36f), wall}, lens, other).speed, 0.0) << x << " at " << lens.focal << ", " << i;
      }
    }
  }
}

TEST_P(OtherRays, WhatIsLostOutlivesTheProcessIntoAnotherPicture) {
  const Lens whole;
  for (const Lens& after :
       {Lens::of(42.0), Lens::of(80.0), whole.part(30, 10, 120, 100), whole.part(0, 10, 120, 100)}) {
    for (const float x : {-0.06f, 0.04f}) {
      const auto hung = [x](float z) { return Board{z, x - 0.015f, x + 0.015f, -0.1f, 0.1f}; };
      Looking robot, reborn;
      robot.comes(hung, 0.36f, whole, GetParam());
      const auto kept = robot.control().remembered();
      ASSERT_TRUE(reborn.control().recall(kept));
      for (int i = 0; i < 25; ++i)
        ASSERT_EQ(reborn.sees({hung(0.36f), wall}, after, GetParam()).speed, 0.0) << x << ", " << after.focal;
    }
  }
}

TEST_P(OtherRays, AKerbThatHasLeftThePictureOutlivesTheProcess) {
  const Lens whole, after = whole.part(0, 0, 160, 80);
  const Board far = {0.74f, -0.1f, 0.1f, floor_y - 0.05f, floor_y},
              near = {0.62f, -0.1f, 0.1f, floor_y - 0.05f, floor_y};
  Looking robot, reborn;
  for (int i = 0; i < 3; ++i) robot.sees({}, whole, GetParam());
  for (int i = 0; i < 3; ++i) robot.sees({far}, whole, GetParam());
  for (int i = 0; i < 10; ++i) robot.sees({near}, whole, GetParam());
  for (int i = 0; i < 10; ++i) ASSERT_EQ(robot.sees({near}, after, GetParam()).speed, 0.0);
  reborn.control().recall(robot.control().remembered());
  for (int i = 0; i < 40; ++i) ASSERT_EQ(reborn.sees({near}, after, GetParam()).speed, 0.0) << i;
}

TEST_P(OtherRays, AKerbThatIsTooNearStaysWhenThePictureChanges) {
  const Lens whole;
  const auto kerb = [](float z, float x) { return Board{z, x - 0.1f, x + 0.1f, floor_y - 0.05f, floor_y}; };
  for (const float x : {-0.12f, 0.0f, 0.12f}) {
    for (const Lens& after : {whole.part(40, 0, 120, 120), whole.part(0, 0, 120, 120), whole.part(0, 0, 160, 116),
                              whole.part(0, 0, 160, 80), whole.scaled(0.5), whole.scaled(2.0), Lens::of(50.0)}) {
      Looking robot;
      for (int i = 0; i < 3; ++i) robot.sees({}, whole, GetParam());
      for (const float z : {0.74f, 0.7f, 0.65f, 0.62f}) robot.sees({kerb(z, x)}, whole, GetParam());
      for (int i = 0; i < 10; ++i)
        ASSERT_EQ(robot.sees({kerb(0.62f, x)}, after, GetParam()).speed, 0.0)
            << x << " in " << after.width << " x " << after.height << ", " << after.focal;
      for (int i = 0; i < 5; ++i) robot.sees({}, whole, GetParam());
      EXPECT_EQ(robot.sees({}, whole, GetParam()).speed, 0.2) << "the floor before it is seen again";
    }
  }
}

TEST_P(OtherRays, AKerbThatHasLeftThePictureIsForgottenAfterTheTimeout) {
  Settings impatient;
  impatient.near_loss.timeout = 2.0;
  const Lens whole, upper = whole.part(0, 0, 160, 80);
  Looking robot(10, impatient);
  for (int i = 0; i < 3; ++i) robot.sees({}, whole, GetParam());
  for (const float z : {0.74f, 0.7f, 0.65f, 0.62f})
    robot.sees({{z, -0.1f, 0.1f, floor_y - 0.05f, floor_y}}, whole, GetParam());
  for (int i = 0; i < 30; ++i) ASSERT_EQ(robot.sees({}, upper, GetParam()).speed, 0.0) << i;
  for (int i = 0; i < 20; ++i) robot.sees({}, upper, GetParam());
  const Decision decision = robot.sees({}, upper, GetParam());
  EXPECT_EQ(decision.speed, 0.2) << decision.reason;
}

class AxisBesideTheMiddle : public testing::TestWithParam<Form> {};
INSTANTIATE_TEST_SUITE_P(As, AxisBesideTheMiddle, testing::Values(Form::Picture, Form::Depths),
                         [](const auto& info) { return info.param == Form::Picture ? "Picture" : "Depths"; });

TEST_P(AxisBesideTheMiddle, WhatHangsStaysWhereverThePictureIsCut) {
  const Lens whole;
  for (const Lens& lens : {whole, whole.part(80, 0, 80, 120), whole.part(60, 0, 100, 120), whole.scaled(2.0),
                           whole.scaled(2.0).part(160, 0, 160, 240)}) {
    for (const float x : {0.12f, 0.16f, 0.2f}) {
      Looking robot;
      const auto cable = hanging(x, 0.016f, 0.1f);
      ASSERT_EQ(robot.comes(cable, 0.34f, lens, GetParam()).speed, 0.0) << x << " of " << lens.width;
      for (int i = 0; i < 25; ++i)
        ASSERT_EQ(robot.sees({cable(0.34f), wall}, lens, GetParam()).speed, 0.0) << x << " of " << lens.width;
    }
  }
}

TEST_P(AxisBesideTheMiddle, ARailStaysWhereverThePictureIsCut) {
  const Lens whole;
  for (const Lens& lens :
       {whole, whole.part(0, 60, 160, 60), whole.part(0, 45, 160, 75), whole.scaled(2.0).part(0, 120, 320, 120)}) {
    for (const float y : {0.06f, 0.075f, 0.09f}) {
      Looking robot;
      const auto thin = rail(y, 0.012f);
      ASSERT_EQ(robot.comes(thin, 0.34f, lens, GetParam()).speed, 0.0) << y << " of " << lens.height;
      for (int i = 0; i < 25; ++i)
        ASSERT_EQ(robot.sees({thin(0.34f), wall}, lens, GetParam()).speed, 0.0) << y << " of " << lens.height;
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud
