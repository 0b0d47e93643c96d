// SPDX-License-Identifier: BSD-3-Clause
#include "guard_markers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace safety_control_cloud {
namespace {

using visualization_msgs::Marker;

constexpr double line_width = 0.01, sphere_diameter = 0.06, text_height = 0.08, above = 0.4;  // [m]
constexpr int around_circle = 36, outlines = 6;

std::vector<Point2> outline_of(const Footprint& footprint) {
  if (!footprint.polygon.empty()) return footprint.polygon;
  std::vector<Point2> points;
  for (int i = 0; i < around_circle; ++i) {
    const double angle = full_turn * i / around_circle, radius = footprint.radius + footprint.margin;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

std_msgs::ColorRGBA colour_of(const Guarded& answer) {
  std_msgs::ColorRGBA colour;
  colour.r = answer.factor >= 1.0 ? 0.1f : 0.95f;
  colour.g = answer.factor > 0.0 ? 0.75f : 0.1f;
  colour.b = 0.1f;
  colour.a = 1.0f;
  return colour;
}

Marker marker(const char* name, int type, const Guarded& answer, const Settings& settings) {
  Marker marker;
  marker.header.frame_id = settings.base_frame;
  marker.ns = name;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = true;
  marker.color = colour_of(answer);
  return marker;
}

void add_outline(Marker& lines, const std::vector<Point2>& outline, const Pose2& way) {
  const auto add = [&](const Point2& corner) {
    const Point2 place = way.place + turned(corner, way.heading);
    geometry_msgs::Point point;
    point.x = place.x, point.y = place.y;
    lines.points.push_back(point);
  };
  for (std::size_t i = 0; i < outline.size(); ++i) add(outline[i]), add(outline[(i + 1) % outline.size()]);
}

/// [s] of the given twist that it lasts until the robot stands.
double stopping_time(const Twist2& given, const Settings& settings) {
  const double braking = std::max(speed_of(given) / settings.stopping.base_deceleration,
                                  std::abs(given.w) / settings.angular_deceleration);
  return settings.latency + settings.base_reaction + 0.5 * braking;
}

Marker path(const Guarded& answer, const Settings& settings) {
  Marker lines = marker("path", Marker::LINE_LIST, answer, settings);
  lines.scale.x = line_width;
  lines.color.a = 0.4f;
  const auto outline = outline_of(footprint_of(settings));
  const Twist2 given = in_plane(answer.given);
  for (int i = 1; i <= outlines; ++i)
    add_outline(lines, outline, way_of(given, stopping_time(given, settings) * i / outlines));
  return lines;
}

Marker decider(const Guarded& answer, const Settings& settings) {
  Marker sphere = marker("decider", Marker::SPHERE, answer, settings);
  if (!answer.point) {
    sphere.action = Marker::DELETE;
    return sphere;
  }
  sphere.pose.position.x = answer.point->x;
  sphere.pose.position.y = answer.point->y;
  sphere.scale.x = sphere.scale.y = sphere.scale.z = sphere_diameter;
  return sphere;
}

}  // namespace

visualization_msgs::MarkerArray to_markers(const Guarded& answer, const Settings& settings) {
  Marker footprint = marker("footprint", Marker::LINE_LIST, answer, settings);
  footprint.scale.x = line_width;
  add_outline(footprint, outline_of(footprint_of(settings)), {});
  Marker text = marker("reason", Marker::TEXT_VIEW_FACING, answer, settings);
  text.pose.position.z = above;
  text.scale.z = text_height;
  text.text = answer.reason;
  visualization_msgs::MarkerArray markers;
  markers.markers = {footprint, path(answer, settings), decider(answer, settings), text};
  return markers;
}

}  // namespace safety_control_cloud
