// SPDX-License-Identifier: BSD-3-Clause
#include "markers.hpp"

#include <cmath>
#include <cstdio>

#include "frame.hpp"

namespace safety_control_cloud {
namespace {

using visualization_msgs::Marker;

constexpr double plane_thickness = 0.004, sphere_diameter = 0.06, text_height = 0.08;  // [m]
constexpr float translucent = 0.25f, opaque = 1.0f;

std_msgs::ColorRGBA colour_of(Zone zone, float alpha) {
  std_msgs::ColorRGBA colour;
  colour.r = zone == Zone::Safe ? 0.1f : 0.95f;
  colour.g = zone == Zone::Danger ? 0.1f : 0.75f;
  colour.b = 0.1f;
  colour.a = alpha;
  return colour;
}

/// Draws in the corridor's frame; every marker has its own name, so that a newer one takes the place of the older.
class Drawing {
 public:
  Drawing(const Settings& settings, const std_msgs::Header& cloud)
      : corridor_(corridor_of(settings)), frame_(settings, cloud), stamp_(cloud.stamp) {}

  Marker marker(const char* name, int type) const {
    Marker marker;
    marker.header.frame_id = frame_.id();
    marker.header.stamp = stamp_;
    marker.ns = name;
    marker.type = type;
    marker.pose.orientation.w = 1.0;
    return marker;
  }

  /// The corridor between two distances [m].
  Marker box(const char* name, double from, double to, const std_msgs::ColorRGBA& colour) const {
    Marker box = marker(name, Marker::CUBE);
    box.pose.position = frame_.point((corridor_.x_min + corridor_.x_max) / 2.0f,
                                     (corridor_.y_min + corridor_.y_max) / 2.0f, (from + to) / 2.0);
    const auto size = frame_.point(corridor_.x_max - corridor_.x_min, corridor_.y_max - corridor_.y_min, to - from);
    box.scale.x = std::abs(size.x);
    box.scale.y = std::abs(size.y);
    box.scale.z = std::abs(size.z);
    box.color = colour;
    return box;
  }

  Marker plane(const char* name, double distance, Zone zone) const {
    return box(name, distance - plane_thickness / 2, distance + plane_thickness / 2, colour_of(zone, 0.6f));
  }

  Marker sphere(const char* name, const Decision& decision) const {
    Marker sphere = marker(name, Marker::SPHERE);
    const bool placed = decision.nearest && std::isfinite(decision.nearest->point.x);
    if (!placed) {
      sphere.action = Marker::DELETE;
      return sphere;
    }
    const Point& point = decision.nearest->point;
    sphere.pose.position = frame_.point(point.x, point.y, point.z);
    sphere.scale.x = sphere.scale.y = sphere.scale.z = sphere_diameter;
    sphere.color = colour_of(decision.zone, opaque);
    return sphere;
  }

  Marker text(const char* name, const Decision& decision) const {
    Marker text = marker(name, Marker::TEXT_VIEW_FACING);
    text.pose.position = frame_.point(0.0, corridor_.y_min - text_height, 0.5);
    text.scale.z = text_height;
    text.color.r = text.color.g = text.color.b = text.color.a = opaque;
    char distance[32] = "";
    if (decision.nearest) std::snprintf(distance, sizeof distance, "  %.2f m", decision.nearest->distance());
    text.text = std::string(name_of(decision.zone)) + distance;
    if (decision.cause != Cause::Seen) text.text += std::string("\n") + name_of(decision.cause);
    return text;
  }

 private:
  Corridor corridor_;
  CorridorFrame frame_;
  ros::Time stamp_;
};

}  // namespace

visualization_msgs::MarkerArray to_markers(const Decision& decision, const Settings& settings,
                                           const std_msgs::Header& cloud) {
  const Drawing drawing(settings, cloud);
  visualization_msgs::MarkerArray markers;
  markers.markers = {drawing.box("corridor", 0.0, settings.limits.warning, colour_of(decision.zone, translucent)),
                     drawing.plane("warning_distance", settings.limits.warning, Zone::Warning),
                     drawing.plane("danger_distance", settings.limits.danger, Zone::Danger),
                     drawing.sphere("nearest", decision), drawing.text("zone", decision)};
  return markers;
}

}  // namespace safety_control_cloud
