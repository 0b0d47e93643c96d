// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/received_cloud.hpp"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "../serialised.hpp"

namespace safety_control_cloud {
namespace {

// [byte] in a serialised cloud whose frame_id is "camera": seq, stamp and the name's length come before the name.
constexpr std::size_t frame_id_length = 12, field_count = frame_id_length + 4 + 6 + 8,
                      first_name_length = field_count + 4;

sensor_msgs::PointCloud2 message() {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.seq = 7;
  cloud.header.stamp = ros::Time(12, 345678901);
  cloud.header.frame_id = "camera";
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  modifier.resize(5);
  return cloud;
}

Arrival arrival_of(Buffer bytes) {
  ros::serialization::IStream stream = stream_of(bytes);
  return arrival_in(stream);
}

Buffer with_number_at(std::size_t place, std::uint32_t number) {
  return safety_control_cloud::with_number_at(place, number, serialised(message()));
}

std::string reason_in(const Arrival& arrival) { return safety_control_cloud::reason_in(arrival.reading); }

TEST(ReceivedCloud, PointsAreBorrowedFromTheBuffer) {
  Buffer bytes = serialised(message());
  ros::serialization::IStream stream = stream_of(bytes);
  const Arrival arrival = arrival_in(stream);
  ASSERT_TRUE(std::holds_alternative<CloudView>(arrival.reading)) << reason_in(arrival);
  const CloudView& view = std::get<CloudView>(arrival.reading);
  EXPECT_EQ(view.bytes, bytes.data() + bytes.size() - 1 - message().data.size()) << "is_dense is the last byte";
  EXPECT_EQ(view.size(), std::size_t{5});
  EXPECT_EQ(view.point_step, std::size_t{32});
  EXPECT_EQ(view.offset, (std::array<std::size_t, 3>{0, 4, 8}));
  EXPECT_FALSE(view.swapped);
}

TEST(ReceivedCloud, HeaderIsTheMessages) {
  const Arrival arrival = arrival_of(serialised(message()));
  EXPECT_EQ(arrival.header.seq, 7u);
  EXPECT_EQ(arrival.header.stamp, ros::Time(12, 345678901));
  EXPECT_EQ(arrival.header.frame_id, "camera");
}

TEST(ReceivedCloud, MessageCutShortAnywhereIsUnreadable) {
  const Buffer whole = serialised(message());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto end = whole.begin() + static_cast<std::ptrdiff_t>(size);
    EXPECT_NE(reason_in(arrival_of(Buffer(whole.begin(), end))), "") << "cut at byte " << size;
  }
}

TEST(ReceivedCloud, MessageThatGoesOnIsUnreadable) {
  Buffer bytes = serialised(message());
  bytes.push_back(0);
  EXPECT_EQ(reason_in(arrival_of(bytes)), "the message goes on after its contents");
}

TEST(ReceivedCloud, LengthsBeyondTheMessageTakeNoMemory) {
  const std::size_t data_length = serialised(message()).size() - 1 - message().data.size() - 4;
  for (const std::size_t place : {frame_id_length, field_count, first_name_length, data_length}) {
    for (const std::uint32_t length : {0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
      EXPECT_NE(reason_in(arrival_of(with_number_at(place, length))), "") << length << " at byte " << place;
    }
  }
}

TEST(ReceivedCloud, HeaderIsKnownEvenIfTheRestIsUnreadable) {
  const Arrival arrival = arrival_of(with_number_at(field_count, 0xFFFFFFFFu));
  EXPECT_NE(reason_in(arrival), "");
  EXPECT_EQ(arrival.header.frame_id, "camera");
}

TEST(ReceivedCloud, BigEndianFlagReachesTheView) {
  sensor_msgs::PointCloud2 cloud = message();
  cloud.is_bigendian = true;
  EXPECT_TRUE(std::get<CloudView>(arrival_of(serialised(cloud)).reading).swapped);
}

TEST(ReceivedCloud, IsPointCloud2ToEveryPublisher) {
  EXPECT_STREQ(ros::message_traits::md5sum<ReceivedCloud>(), ros::message_traits::md5sum<sensor_msgs::PointCloud2>());
  EXPECT_STREQ(ros::message_traits::datatype<ReceivedCloud>(), "sensor_msgs/PointCloud2");
}

}  // namespace
}  // namespace safety_control_cloud
