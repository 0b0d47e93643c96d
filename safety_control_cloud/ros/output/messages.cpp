// SPDX-License-Identifier: BSD-3-Clause
#include "messages.hpp"

#include <pcl_conversions/pcl_conversions.h>

#include <limits>

#include "frame.hpp"

namespace safety_control_cloud {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double free_ahead = std::numeric_limits<double>::infinity();

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
  state.hint = decision.hint;
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
