// SPDX-License-Identifier: BSD-3-Clause
#include "messages.hpp"

#include <pcl_conversions/pcl_conversions.h>

#include <algorithm>
#include <limits>

#include "../core/depth_layout.hpp"
#include "frame.hpp"

namespace safety_control_cloud {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double free_ahead = std::numeric_limits<double>::infinity();

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

CameraClaims claims_of(const sensor_msgs::CameraInfo& camera) {
  CameraClaims claims;
  claims.height = camera.height;
  claims.width = camera.width;
  claims.D = camera.D;
  std::copy(camera.K.begin(), camera.K.end(), claims.K.begin());
  std::copy(camera.P.begin(), camera.P.end(), claims.P.begin());
  claims.binning_x = camera.binning_x;
  claims.binning_y = camera.binning_y;
  claims.roi = {camera.roi.x_offset, camera.roi.y_offset, camera.roi.height, camera.roi.width};
  return claims;
}

double nearest_in(const Decision& decision) {
  if (decision.nearest) return decision.nearest->distance();
  return decision.cause == Cause::Seen ? free_ahead : unknown;
}

geometry_msgs::Point nearest_point_in(const Decision& decision, const CorridorFrame& frame) {
  if (!decision.nearest) return frame.point(unknown, unknown, unknown);
  const Point& point = decision.nearest->point;
  return frame.point(point.x, point.y, point.z);
}

}  // namespace

Reading view_of(const sensor_msgs::PointCloud2& cloud) {
  return view_of(layout_of(cloud), cloud.data.data(), cloud.data.size());
}

Reading view_of(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& camera, bool rectified) {
  const DepthLayout layout{image.height, image.width, image.encoding,   image.is_bigendian != 0,
                           image.step,   rectified,   claims_of(camera)};
  return view_of(layout, image.data.data(), image.data.size());
}

geometry_msgs::Twist to_twist(const Decision& decision) {
  geometry_msgs::Twist twist;
  twist.linear.x = decision.speed;
  return twist;
}

SafetyState to_state(const Decision& decision, const Settings& settings, const std_msgs::Header& cloud) {
  const CorridorFrame frame(settings, cloud);
  SafetyState state;
  state.header = cloud;
  state.zone = static_cast<std::uint8_t>(decision.zone);
  state.zone_text = name_of(decision.zone);
  state.cause = static_cast<std::uint8_t>(decision.cause);
  state.cause_text = name_of(decision.cause);
  state.reason = decision.reason;
  state.nearest = nearest_in(decision);
  state.nearest_point = nearest_point_in(decision, frame);
  state.nearest_frame = frame.id();
  state.inside = static_cast<std::uint32_t>(decision.sight.inside);
  state.returns = static_cast<std::uint32_t>(decision.sight.returns);
  state.total = static_cast<std::uint32_t>(decision.sight.total);
  state.speed = decision.speed;
  return state;
}

sensor_msgs::PointCloud2 to_output(const Cloud& crop, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 output;
  pcl::toROSMsg(crop, output);
  output.header = header;
  return output;
}

}  // namespace safety_control_cloud
