// SPDX-License-Identifier: BSD-3-Clause
#include "received_cloud.hpp"

#include "../../core/input/layout.hpp"
#include "wire.hpp"

namespace safety_control_cloud {
namespace {

using ros::serialization::IStream;

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
  const Bytes bytes = bytes_in(stream);
  stream.next(is_dense);  // only to see that it is there: what it claims of the points is not believed
  expect_end(stream);
  return view_of(layout, bytes.first, bytes.size);
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
