// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/look/field_of_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "../../../safety_control_cloud/core/safety_control.hpp"
#include "../scene.hpp"

namespace safety_control_cloud {
namespace {

/// What a camera 0.3 m above a floor sees of a wall, and in which frame it says so.
struct Camera {
  std::size_t width = 160, height = 120;
  double focal = 138.56;  ///< [px]
  double wall = 0.45;     ///< [m]
  double returning = 1.0;
  double noise = 0.0;  ///< [m]
  std::function<Xyz(Xyz)> frame = [](Xyz optical) { return optical; };
  std::function<double(double)> bend = [](double pixel) { return pixel; };

  std::vector<Xyz> points() const {
    std::vector<Xyz> points;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> error(0.0, 1.0);
    for (std::size_t i = 0; i < width * height; ++i) {
      const double x = bend((static_cast<double>(i % width) + 0.5 - static_cast<double>(width) / 2) / focal);
      const double y = bend((static_cast<double>(i / width) + 0.5 - static_cast<double>(height) / 2) / focal);
      const double z = std::min(wall, y > 0.0 ? 0.3 / y : wall) + noise * error(random);
      const auto point = frame({static_cast<float>(x * z), static_cast<float>(y * z), static_cast<float>(z)});
      points.push_back(share(random) < returning ? point : Xyz{nan, nan, nan});
    }
    return points;
  }
};

CloudView picture_of(const std::vector<Xyz>& points, const Camera& camera) {
  CloudView view = view_of(points);
  view.width = camera.width, view.height = camera.height, view.row_step = camera.width * sizeof(Xyz);
  return view;
}

bool is_optical(const Camera& camera, Sense sense = Sense::Optical) {
  const auto points = camera.points();
  return std::holds_alternative<FieldOfView>(field_of(picture_of(points, camera), sense));
}

Decision decision_on(const Camera& camera) {
  SafetyControl control{Settings{}};
  const auto points = camera.points();
  return control.decide(picture_of(points, camera), Origin{1.0}, Instant{1.0, 1.0});
}

struct Frame {
  const char* name;
  std::function<Xyz(Xyz)> from_optical;
};

void PrintTo(const Frame& frame, std::ostream* out) { *out << frame.name; }

class OtherFrame : public testing::TestWithParam<Frame> {};

INSTANTIATE_TEST_SUITE_P(Every, OtherFrame,
                         testing::Values(Frame{"Body",
                                               [](Xyz p) {
                                                 return Xyz{p.z, -p.x, -p.y};
                                               }},
                                         Frame{"BodyDown",
                                               [](Xyz p) {
                                                 return Xyz{p.z, p.x, p.y};
                                               }},
                                         Frame{"BodyOnTheFloor",
                                               [](Xyz p) {
                                                 return Xyz{p.z, -p.x, 0.3f - p.y};
                                               }},
                                         Frame{"EastNorthUp",
                                               [](Xyz p) {
                                                 return Xyz{p.x, p.z, -p.y};
                                               }},
                                         Frame{"EastNorthUpOnTheFloor",
                                               [](Xyz p) {
                                                 return Xyz{p.x, p.z, 0.3f - p.y};
                                               }},
                                         Frame{"Backward",
                                               [](Xyz p) {
                                                 return Xyz{p.x, -p.y, -p.z};
                                               }},
                                         Frame{"Aside",
                                               [](Xyz p) {
                                                 return Xyz{p.z, p.y, p.x};
                                               }},
                                         Frame{"YUp",
                                               [](Xyz p) {
                                                 return Xyz{-p.x, -p.y, p.z};
                                               }},
                                         Frame{"Turned",
                                               [](Xyz p) {
                                                 return Xyz{-p.y, p.x, p.z};
                                               }}),
                         [](const auto& info) { return info.param.name; });

/// A wall at 0.45 m read "free", and the robot drove into it.
TEST_P(OtherFrame, DoesNotMoveTheRobot) {
  for (const double wall : {0.3, 0.45, 0.8, 3.0}) {
    for (const auto& [width, height] : {std::pair{160, 120}, {640, 480}, {80, 60}, {64, 16}}) {
      for (const double returning : {1.0, 0.6, 0.3}) {
        Camera camera;
        camera.width = static_cast<std::size_t>(width), camera.height = static_cast<std::size_t>(height);
        camera.focal = 0.866 * width;
        camera.wall = wall, camera.returning = returning, camera.noise = 0.002;
        camera.frame = GetParam().from_optical;
        const Decision decision = decision_on(camera);
        EXPECT_EQ(decision.speed, 0.0) << wall << " m, " << width << " x " << height << ", " << returning;
        EXPECT_NE(decision.cause, Cause::Seen) << wall << " m, " << width << " x " << height << ", " << returning;
      }
    }
  }
}

TEST(FieldOfView, CloudOfABodyFrameIsSaidToBeNone) {
  Camera camera;
  camera.frame = [](Xyz p) { return Xyz{p.z, -p.x, -p.y}; };
  const Decision decision = decision_on(camera);
  EXPECT_EQ(decision.cause, Cause::WrongView);
  EXPECT_NE(decision.reason.find("x/z must grow with the column"), std::string::npos) << decision.reason;
}

TEST(FieldOfView, OpticalCloudIsBelievedWhateverTheCamera) {
  for (const auto& [width, height] : {std::pair{160, 120}, {640, 480}, {62, 45}, {640, 8}, {640, 2}}) {
    for (const double fields : {0.3, 0.577, 1.0, 1.7}) {
      for (const double returning : {1.0, 0.5, 0.15}) {
        Camera camera;
        camera.width = static_cast<std::size_t>(width), camera.height = static_cast<std::size_t>(height);
        camera.focal = width / 2.0 / fields;
        camera.wall = 1.5, camera.returning = returning, camera.noise = 0.02;
        EXPECT_TRUE(is_optical(camera)) << width << " x " << height << ", " << fields << ", " << returning;
      }
    }
  }
}

TEST(FieldOfView, LensThatBendsRaysIsACamera) {
  Camera fisheye;
  fisheye.bend = [](double pixel) { return std::tan(1.6 * pixel); };
  EXPECT_TRUE(is_optical(fisheye));
  Camera barrel;
  barrel.bend = [](double pixel) { return pixel * (1.0 + 0.3 * pixel * pixel); };
  EXPECT_TRUE(is_optical(barrel));
}

TEST(FieldOfView, AFifthOfOddPointsIsForgiven) {
  Camera camera;
  auto points = camera.points();
  std::mt19937 random(5);
  for (Xyz& point : points) {
    if (random() % 5 == 0) point = {0.0f, 0.0f, 1.0f};
  }
  EXPECT_TRUE(std::holds_alternative<FieldOfView>(field_of(picture_of(points, camera), Sense::Optical)));
}

TEST(FieldOfView, PieceOfAPictureFromWhichStraightAheadWasCutOffIsNoneToDriveBy) {
  const Camera camera;
  const auto points = camera.points();
  CloudView piece = picture_of(points, camera);
  piece.bytes += 100 * piece.row_step, piece.height = 20;
  EXPECT_TRUE(std::holds_alternative<NotOptical>(field_of(piece, Sense::Optical)));
  EXPECT_TRUE(std::holds_alternative<FieldOfView>(field_of(piece, Sense::Either))) << "whoever placed it knows";
  piece = picture_of(points, camera), piece.height = 60;
  EXPECT_TRUE(std::holds_alternative<FieldOfView>(field_of(piece, Sense::Optical))) << "the upper half";
}

TEST(FieldOfView, OnePointInEveryPixelTellsNothing) {
  const Camera camera;
  const std::vector<Xyz> points(camera.width * camera.height, Xyz{1.0f, 0.5f, 2.0f});
  EXPECT_TRUE(std::holds_alternative<FieldOfView>(field_of(picture_of(points, camera), Sense::Optical)));
}

TEST(FieldOfView, CameraThatIsPlacedMayBeMirroredOrUpsideDown) {
  Camera mirrored, turned;
  mirrored.frame = [](Xyz p) { return Xyz{-p.x, p.y, p.z}; };
  turned.frame = [](Xyz p) { return Xyz{-p.x, -p.y, p.z}; };
  for (const Camera& camera : {mirrored, turned}) {
    EXPECT_FALSE(is_optical(camera, Sense::Optical));
    EXPECT_TRUE(is_optical(camera, Sense::Either));
  }
}

TEST(FieldOfView, IsThatOfTheRays) {
  const Camera camera;
  const auto points = camera.points();
  const auto field = std::get<FieldOfView>(field_of(picture_of(points, camera), Sense::Optical));
  EXPECT_NEAR(field.left, -0.577, 0.01);
  EXPECT_NEAR(field.right, 0.577, 0.01);
  EXPECT_NEAR(field.top, -0.433, 0.01);
  EXPECT_NEAR(field.bottom, 0.433, 0.01);
}

}  // namespace
}  // namespace safety_control_cloud
