// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace safety_control_cloud {

/// Bytes of a message, borrowed from it.
struct Bytes {
  const std::uint8_t* first = nullptr;
  std::size_t size = 0;
};

// What comes next in a serialised message. No length in it is believed before it has been checked: all throw if the
// message ends sooner.

/// The length of what follows, whose elements have this size [byte] at least.
std::uint32_t length_in(ros::serialization::IStream& stream, std::uint32_t smallest_element);

std::string text_in(ros::serialization::IStream& stream);
Bytes bytes_in(ros::serialization::IStream& stream);

/// Field by field, so that what came before a fault is known.
void read_header(ros::serialization::IStream& stream, std_msgs::Header& header);

/// Throws if the message goes on.
void expect_end(ros::serialization::IStream& stream);

}  // namespace safety_control_cloud
