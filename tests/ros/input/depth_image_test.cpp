// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/depth_image.hpp"

#include <gtest/gtest.h>

#include "../../../safety_control_cloud/ros/input/received.hpp"
#include "../serialised.hpp"

namespace safety_control_cloud {
namespace {

// [byte] in a serialised image whose frame_id is "camera": seq, stamp and the name's length come before the name.
constexpr std::size_t frame_id_length = 12, height = frame_id_length + 4 + 6, encoding_length = height + 8,
                      is_bigendian = encoding_length + 4 + 5, data_length = is_bigendian + 1 + 4;

sensor_msgs::Image message() {
  sensor_msgs::Image image;
  image.header.seq = 7;
  image.header.stamp = ros::Time(12, 345678901);
  image.header.frame_id = "camera";
  image.height = 2;
  image.width = 3;
  image.encoding = "16UC1";
  image.step = 8;
  image.data.assign(16, 1);
  return image;
}

sensor_msgs::CameraInfo camera() {
  sensor_msgs::CameraInfo info;
  info.height = 2;
  info.width = 3;
  info.K = {4.0, 0.0, 1.5, 0.0, 4.0, 1.0, 0.0, 0.0, 1.0};
  info.P = {4.0, 0.0, 1.5, 0.0, 0.0, 4.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

DepthImage received(Buffer& bytes) {
  ros::serialization::IStream stream = stream_of(bytes);
  return image_in(stream);
}

Buffer with_number_at(std::size_t place, std::uint32_t number) {
  return safety_control_cloud::with_number_at(place, number, serialised(message()));
}

TEST(DepthImage, DepthsAreBorrowedFromTheBuffer) {
  Buffer bytes = serialised(message());
  const DepthImage image = received(bytes);
  EXPECT_EQ(image.problem, "");
  const Reading reading = view_of(image, camera(), true);
  ASSERT_TRUE(std::holds_alternative<DepthView>(reading)) << reason_in(reading);
  const DepthView& view = std::get<DepthView>(reading);
  EXPECT_EQ(view.bytes, bytes.data() + data_length + 4);
  EXPECT_EQ(view.size(), std::size_t{6});
  EXPECT_EQ(view.row_step, std::size_t{8});
  EXPECT_EQ(view.depth, Depth::Millimetres);
  EXPECT_EQ(view.camera.cx, 1.5);
  EXPECT_FALSE(view.swapped);
}

TEST(DepthImage, IsTheSameFromAMessageOfThisProcess) {
  const sensor_msgs::Image::ConstPtr shared = boost::make_shared<const sensor_msgs::Image>(message());
  const DepthImage image = image_in(shared);
  const DepthView view = std::get<DepthView>(view_of(image, camera(), true));
  EXPECT_EQ(view.bytes, shared->data.data());
  EXPECT_EQ(image.owner, shared);
  Buffer bytes = serialised(message());
  const DepthImage other = received(bytes);
  EXPECT_EQ(image.header, other.header);
  EXPECT_EQ(image.bytes.size, other.bytes.size);
  EXPECT_EQ(image.layout.height, other.layout.height);
  EXPECT_EQ(image.layout.width, other.layout.width);
  EXPECT_EQ(image.layout.encoding, other.layout.encoding);
  EXPECT_EQ(image.layout.is_bigendian, other.layout.is_bigendian);
  EXPECT_EQ(image.layout.step, other.layout.step);
}

TEST(DepthImage, HeaderIsTheMessages) {
  Buffer bytes = serialised(message());
  EXPECT_EQ(received(bytes).header, message().header);
}

TEST(DepthImage, MessageCutShortAnywhereHasAProblem) {
  const Buffer whole = serialised(message());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Buffer part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    const DepthImage image = received(part);
    EXPECT_NE(image.problem, "") << "cut at byte " << size;
    EXPECT_NE(reason_in(view_of(image, camera(), true)), "") << "cut at byte " << size;
  }
}

TEST(DepthImage, MessageThatGoesOnHasAProblem) {
  Buffer bytes = serialised(message());
  bytes.push_back(0);
  EXPECT_EQ(received(bytes).problem, "the message goes on after its contents");
}

TEST(DepthImage, LengthsBeyondTheMessageTakeNoMemory) {
  for (const std::size_t place : {frame_id_length, encoding_length, data_length}) {
    for (const std::uint32_t length : {0x11u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
      Buffer bytes = with_number_at(place, length);
      EXPECT_NE(received(bytes).problem, "") << length << " at byte " << place;
    }
  }
}

TEST(DepthImage, SizesBeyondTheMessageAreUnreadable) {
  for (const std::size_t place : {height, height + 4, is_bigendian + 1}) {
    Buffer bytes = with_number_at(place, 0xFFFFFFFFu);
    const DepthImage image = received(bytes);
    EXPECT_EQ(image.problem, "");
    EXPECT_NE(reason_in(view_of(image, camera(), true)), "") << "at byte " << place;
  }
}

TEST(DepthImage, HeaderIsKnownEvenIfTheRestIsNot) {
  Buffer bytes = with_number_at(encoding_length, 0xFFFFFFFFu);
  const DepthImage image = received(bytes);
  EXPECT_NE(image.problem, "");
  EXPECT_EQ(image.header, message().header);
}

TEST(DepthImage, BigEndianFlagReachesTheView) {
  sensor_msgs::Image big = message();
  big.is_bigendian = true;
  Buffer bytes = serialised(big);
  EXPECT_TRUE(std::get<DepthView>(view_of(received(bytes), camera(), true)).swapped);
}

TEST(DepthImage, DistortedCamerasImageIsReadableOnceItIsRectified) {
  sensor_msgs::CameraInfo distorted = camera();
  distorted.D = {0.1, 0.0, 0.0, 0.0, 0.0};
  Buffer bytes = serialised(message());
  EXPECT_EQ(reason_in(view_of(received(bytes), distorted, true)), "");
  EXPECT_NE(reason_in(view_of(received(bytes), distorted, false)), "");
}

TEST(DepthImage, IsImageToEveryPublisher) {
  using ReceivedImage = Received<sensor_msgs::Image>;
  EXPECT_STREQ(ros::message_traits::md5sum<ReceivedImage>(), ros::message_traits::md5sum<sensor_msgs::Image>());
  EXPECT_STREQ(ros::message_traits::datatype<ReceivedImage>(), "sensor_msgs/Image");
}

}  // namespace
}  // namespace safety_control_cloud
