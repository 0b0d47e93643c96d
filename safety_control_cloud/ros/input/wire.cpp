// SPDX-License-Identifier: BSD-3-Clause
#include "wire.hpp"

#include <stdexcept>

namespace safety_control_cloud {

using ros::serialization::IStream;

std::uint32_t length_in(IStream& stream, std::uint32_t smallest_element) {
  std::uint32_t length;
  stream.next(length);
  if (length > stream.getLength() / smallest_element) throw std::length_error("the message ends before its contents");
  return length;
}

std::string text_in(IStream& stream) {
  const Bytes text = bytes_in(stream);
  return std::string(reinterpret_cast<const char*>(text.first), text.size);
}

Bytes bytes_in(IStream& stream) {
  const std::uint32_t size = length_in(stream, 1);
  return {stream.advance(size), size};
}

void read_header(IStream& stream, std_msgs::Header& header) {
  stream.next(header.seq);
  stream.next(header.stamp);
  header.frame_id = text_in(stream);
}

void expect_end(IStream& stream) {
  if (stream.getLength() > 0) throw std::length_error("the message goes on after its contents");
}

}  // namespace safety_control_cloud
