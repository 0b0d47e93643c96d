// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_message.hpp"

#include "../../core/input/layout.hpp"

namespace safety_control_cloud {
namespace {

Layout layout_of(const sensor_msgs::PointCloud2& cloud) {
  Layout layout;
  layout.height = cloud.height;
  layout.width = cloud.width;
  layout.is_bigendian = cloud.is_bigendian != 0;
  layout.point_step = cloud.point_step;
  layout.row_step = cloud.row_step;
  for (const auto& field : cloud.fields) {
    layout.fields.push_back(Field{field.name, field.offset, field.datatype, field.count});
  }
  return layout;
}

}  // namespace

Reading view_of(const sensor_msgs::PointCloud2& cloud) {
  return view_of(layout_of(cloud), cloud.data.data(), cloud.data.size());
}

}  // namespace safety_control_cloud
