// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "scenes.hpp"

namespace safety_control_cloud {

inline sensor_msgs::PointCloud2 message_of(const CameraPicture& picture) {
  sensor_msgs::PointCloud2 message;
  message.header.frame_id = "camera_depth_optical_frame";
  message.width = static_cast<std::uint32_t>(picture.width);
  message.height = static_cast<std::uint32_t>(picture.height);
  message.point_step = static_cast<std::uint32_t>(picture.point_step);
  message.row_step = message.width * message.point_step;
  for (const char* name : {"x", "y", "z"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(message.fields.size() * sizeof(float));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    message.fields.push_back(field);
  }
  message.data = bytes_of(picture);
  return message;
}

}  // namespace safety_control_cloud
