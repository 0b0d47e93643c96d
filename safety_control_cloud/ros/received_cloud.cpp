// SPDX-License-Identifier: BSD-3-Clause
#include "received_cloud.hpp"

#include <stdexcept>

namespace safety_control_cloud {
namespace {

using ros::serialization::IStream;

/// The length of what follows, which cannot have more elements than the stream has room for.
std::uint32_t length_in(IStream& stream, std::uint32_t smallest_element) {
  std::uint32_t length;
  stream.next(length);
  if (length > stream.getLength() / smallest_element) throw std::length_error("the message ends before its contents");
  return length;
}

std::string text_in(IStream& stream) {
  const std::uint32_t length = length_in(stream, 1);
  return std::string(reinterpret_cast<const char*>(stream.advance(length)), length);
}

void read_header(IStream& stream, std_msgs::Header& header) {
  stream.next(header.seq);
  stream.next(header.stamp);
  header.frame_id = text_in(stream);
}

Field field_in(IStream& stream) {
  Field field;
  field.name = text_in(stream);
  stream.next(field.offset);
  stream.next(field.datatype);
  stream.next(field.count);
  return field;
}

/// sensor_msgs/PointCloud2 after its header, in the order of its definition.
Reading reading_in(IStream& stream) {
  constexpr std::uint32_t smallest_field = 13;  // [byte] of a PointField whose name is empty
  Layout layout;
  stream.next(layout.height);
  stream.next(layout.width);
  layout.fields.resize(length_in(stream, smallest_field));
  for (Field& field : layout.fields) field = field_in(stream);
  std::uint8_t is_bigendian, is_dense;
  stream.next(is_bigendian);
  layout.is_bigendian = is_bigendian != 0;
  stream.next(layout.point_step);
  stream.next(layout.row_step);
  const std::uint32_t size = length_in(stream, 1);
  const std::uint8_t* bytes = stream.advance(size);
  stream.next(is_dense);  // only to see that it is there: what it claims of the points is not believed
  if (stream.getLength() > 0) return Unreadable{"the message goes on after its contents"};
  return view_of(layout, bytes, size);
}

}  // namespace

Arrival arrival_in(IStream& stream) {
  Arrival arrival;
  arrival.reading = readable([&] {
    read_header(stream, arrival.header);
    return reading_in(stream);
  });
  return arrival;
}

}  // namespace safety_control_cloud
