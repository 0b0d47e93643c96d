// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/input/depth_layout.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace safety_control_cloud {
namespace {

struct ClaimedImage {
  DepthLayout layout;
  std::size_t size = 0;  ///< [byte] of its data
};

/// 3 x 2 pixels of 32 bits, and 4 bytes after each row.
ClaimedImage well_formed_image() {
  DepthLayout layout;
  layout.height = 2;
  layout.width = 3;
  layout.encoding = "32FC1";
  layout.is_bigendian = is_foreign(false);
  layout.step = 16;
  layout.camera.height = 2;
  layout.camera.width = 3;
  layout.camera.D = {0, 0, 0, 0, 0};
  layout.camera.K = {4, 0, 1, 0, 5, 0.5, 0, 0, 1};
  layout.camera.P = {4, 0, 1, 0, 0, 5, 0.5, 0, 0, 0, 1, 0};
  return {layout, 32};
}

struct MalformedImage {
  const char* name;
  const char* reason;  ///< a part of the sentence the robot's owner must read
  std::function<void(DepthLayout&, std::size_t&)> harm;
};

void PrintTo(const MalformedImage& image, std::ostream* out) { *out << image.name; }

std::vector<MalformedImage> malformed_images() {
  constexpr std::uint32_t huge = std::numeric_limits<std::uint32_t>::max();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  using L = DepthLayout;
  using S = std::size_t;
  return {
      {"NoEncoding", "encoding ", [](L& l, S&) { l.encoding = ""; }},
      {"Colours", "encoding rgb8", [](L& l, S&) { l.encoding = "rgb8"; }},
      {"Mono16", "encoding mono16", [](L& l, S&) { l.encoding = "mono16"; }},
      {"StepZero", "step 0", [](L& l, S&) { l.step = 0; }},
      {"StepTooSmall", "step 8", [](L& l, S&) { l.step = 8; }},
      {"StepHuge", "data has 32 bytes", [](L& l, S&) { l.step = huge - 3; }},
      {"StepOfHalfAPixel", "not a multiple", [](L& l, S& size) { l.step = 14, size = 28; }},
      {"DataShortByOne", "data has 31 bytes", [](L&, S& size) { size = 31; }},
      {"DataLongByOne", "data has 33 bytes", [](L&, S& size) { size = 33; }},
      {"NoData", "data has 0 bytes", [](L&, S& size) { size = 0; }},
      {"WidthHuge", "step 16", [](L& l, S&) { l.width = huge; }},
      {"HeightHuge", "data has 32 bytes", [](L& l, S&) { l.height = huge; }},
      {"WidthTimesPixelWraps", "step 0", [](L& l, S& size) { l.width = 1u << 30, l.step = 0, size = 0; }},
      {"HeightTimesStepWraps", "data has 0 bytes", [](L& l, S& size) { l.step = l.height = 65536, size = 0; }},
      {"OtherWidth", "3 x 2 pixels, its CameraInfo speaks of 4 x 2", [](L& l, S&) { l.camera.width = 4; }},
      {"OtherHeight", "speaks of 3 x 1", [](L& l, S&) { l.camera.height = 1; }},
      {"NoCamera", "speaks of 0 x 0", [](L& l, S&) { l.camera = {}; }},
      {"OtherRegion", "speaks of 2 x 2", [](L& l, S&) { l.camera.roi.width = 2; }},
      {"OtherBinning", "speaks of 1 x 2", [](L& l, S&) { l.camera.binning_x = 2; }},
      {"NotCalibrated", "K of", [](L& l, S&) { l.camera.K = {}; }},
      {"KWithoutFy", "K of", [](L& l, S&) { l.camera.K[4] = 0.0; }},
      {"NoProjection", "P of", [](L& l, S&) { l.camera.P = {}; }},
      {"FocalLengthNan", "P of", [](L& l, S&) { l.camera.P[0] = nan; }},
      {"FocalLengthNegative", "P of", [](L& l, S&) { l.camera.P[5] = -5.0; }},
      {"Identity", "never calibrated", [](L& l, S&) { l.camera.K = {1, 0, 0, 0, 1, 0, 0, 0, 1}; }},
      {"WiderThanAnyCamera", "so wide or so narrow", [](L& l, S&) { l.camera.P[0] = 0.4; }},
      {"HigherThanAnyCamera", "so wide or so narrow", [](L& l, S&) { l.camera.P[5] = 0.25; }},
      {"NarrowerThanAnyCamera", "so wide or so narrow", [](L& l, S&) { l.camera.P[0] = 1e7; }},
      {"FocalLengthBelowFloat32", "beyond all cameras", [](L& l, S&) { l.camera.P[0] = 1e-300; }},
      {"CentreNan", "optical centre", [](L& l, S&) { l.camera.P[2] = nan; }},
      {"CentreBeyondFloat32", "beyond all cameras", [](L& l, S&) { l.camera.P[6] = 1e300; }},
      {"Distorted", "rectify it with image_proc", [](L& l, S&) { l.camera.D[0] = -0.1; }},
      {"DistortedByTheLast", "image_rect", [](L& l, S&) { l.camera.D = {0, 0, 0, 0, 0, 0, 0, 1e-9}; }},
      {"DistortionNan", "image_rect", [](L& l, S&) { l.camera.D[2] = nan; }},
  };
}

class Malformed : public testing::TestWithParam<MalformedImage> {};

TEST_P(Malformed, ImageIsUnreadableForAReason) {
  auto [layout, size] = well_formed_image();
  GetParam().harm(layout, size);
  const std::vector<std::uint8_t> bytes(size);  // exactly as long as declared here, so that ASan sees a read beyond

  const Reading reading = view_of(layout, bytes.data(), bytes.size());

  ASSERT_TRUE(std::holds_alternative<Unreadable>(reading));
  EXPECT_NE(std::get<Unreadable>(reading).reason.find(GetParam().reason), std::string::npos)
      << std::get<Unreadable>(reading).reason;
}

INSTANTIATE_TEST_SUITE_P(Every, Malformed, testing::ValuesIn(malformed_images()),
                         [](const auto& info) { return std::string(info.param.name); });

DepthView readable(const ClaimedImage& image) {
  static std::vector<std::uint8_t> bytes;
  bytes.assign(image.size, 0);
  const Reading reading = view_of(image.layout, bytes.data(), bytes.size());
  EXPECT_TRUE(std::holds_alternative<DepthView>(reading)) << std::get<Unreadable>(reading).reason;
  return std::get<DepthView>(reading);
}

TEST(DepthLayout, WellFormedImageIsReadByTheProjection) {
  const DepthView view = readable(well_formed_image());
  EXPECT_EQ(view.width, 3u);
  EXPECT_EQ(view.height, 2u);
  EXPECT_EQ(view.row_step, 16u);
  EXPECT_EQ(view.depth, Depth::Metres);
  EXPECT_FALSE(view.swapped);
  EXPECT_EQ(view.camera.fx, 4.0);
  EXPECT_EQ(view.camera.fy, 5.0);
  EXPECT_EQ(view.camera.cx, 1.0);
  EXPECT_EQ(view.camera.cy, 0.5);
}

TEST(DepthLayout, MillimetresAreSixteenBits) {
  auto [layout, size] = well_formed_image();
  layout.encoding = "16UC1", layout.step = 6, layout.is_bigendian = is_foreign(true);
  const DepthView view = readable({layout, 12});
  EXPECT_EQ(view.depth, Depth::Millimetres);
  EXPECT_TRUE(view.swapped);
}

/// The CameraInfo beside a rectified image is that of the raw one: its D is not zero.
TEST(DepthLayout, RectifiedImageOfADistortedCameraIsRead) {
  auto [layout, size] = well_formed_image();
  layout.camera.D[0] = -0.1;
  layout.rectified = true;
  readable({layout, size});
}

TEST(DepthLayout, RegionAndBinningMoveTheCameraAsImageGeometryDoes) {
  auto [layout, size] = well_formed_image();
  layout.camera.width = 640, layout.camera.height = 480;
  layout.camera.roi.x_offset = 100, layout.camera.roi.y_offset = 50;
  layout.camera.roi.width = 6, layout.camera.roi.height = 4;
  layout.camera.binning_x = layout.camera.binning_y = 2;
  layout.camera.P = {500, 0, 320, 0, 0, 400, 240, 0, 0, 0, 1, 0};
  const DepthView view = readable({layout, size});
  EXPECT_EQ(view.camera.fx, 250.0);
  EXPECT_EQ(view.camera.fy, 200.0);
  EXPECT_EQ(view.camera.cx, 110.0);
  EXPECT_EQ(view.camera.cy, 95.0);
}

TEST(DepthLayout, ImageOfNoPixelsIsReadable) {
  auto [layout, size] = well_formed_image();
  layout.width = layout.camera.width = 0, layout.height = layout.camera.height = 1u << 31, layout.step = 0;
  EXPECT_EQ(readable({layout, 0}).height, 0u) << "four billion rows of nothing";
}

}  // namespace
}  // namespace safety_control_cloud
