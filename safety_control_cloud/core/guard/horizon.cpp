// SPDX-License-Identifier: BSD-3-Clause
#include "horizon.hpp"

#include <algorithm>
#include <cmath>

#include "new_ground.hpp"

namespace safety_control_cloud {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr int steps = 16, halvings = 12;

/// How steeply a ray of the camera's rises over the ground; infinite for one that does not lead along it.
double slope_of(const Outlook& outlook, double x, double y) {
  const Point from = outlook.camera();
  const Point to = outlook.placed(static_cast<float>(x), static_cast<float>(y), 1.0f);
  const double up = double{from.y} - to.y, along = std::hypot(double{to.x} - from.x, double{to.z} - from.z);
  return along > 0.0 ? up / along : std::copysign(inf, up);
}

/// Of those that look there, none sees so far.
bool is_beyond(const std::vector<Sighted>& sensors, const Point2& place, double margin) {
  bool is_looked_at = false;
  for (const Sighted& one : sensors) {
    if (!one.eye.sees(place)) continue;
    is_looked_at = true;
    const Point2 there = place - one.eye.place;
    const double distance = length_of(there);
    const Point2 direction = distance > 0.0 ? (1.0 / distance) * there : Point2{};
    if (distance + margin + one.nearer <= one.horizon.towards(direction)) return false;
  }
  return is_looked_at;
}

}  // namespace

Horizon::Horizon(const Outlook& outlook, const ScanView& scan, const Heights& heights)
    : range_(scan.range_max), above_(heights.top + outlook.camera().y), below_(-outlook.camera().y - heights.bottom) {
  // In the corridor's axes, y down; the plane's normal is the laser's z.
  const Point from = outlook.camera(), to = outlook.placed(0.0f, 0.0f, 1.0f);
  const double up = double{from.y} - to.y;
  if (up == 0.0) return;  // a plane on its edge; it does not look between the heights: WRONG_VIEW
  gradient_ = {-(double{to.z} - from.z) / up, (double{to.x} - from.x) / up};
}

Horizon::Horizon(const Outlook& outlook, const FieldOfView& field, const Heights& heights)
    : above_(heights.top + outlook.camera().y), below_(-outlook.camera().y - heights.bottom), low_(inf), high_(-inf) {
  const double across = 0.5 * (field.left + field.right), down = 0.5 * (field.top + field.bottom);
  for (const double slope : {slope_of(outlook, across, field.top), slope_of(outlook, across, field.bottom),
                             slope_of(outlook, field.left, down), slope_of(outlook, field.right, down)}) {
    low_ = std::min(low_, slope);
    high_ = std::max(high_, slope);
  }
}

double Horizon::towards(const Point2& direction) const {
  const double slope = dot(gradient_, direction);
  return at_slopes(low_ + slope, high_ + slope);
}

double Horizon::least() const {
  const double steepest = length_of(gradient_);
  return std::min(at_slopes(low_ + steepest, high_ + steepest), at_slopes(low_ - steepest, high_ - steepest));
}

double Horizon::at_slopes(double low, double high) const {
  double farthest = range_ < inf ? range_ / std::hypot(1.0, high) : inf;
  if (high < 0.0) farthest = std::min(farthest, below_ / -high);
  if (low > 0.0) farthest = std::min(farthest, above_ / low);
  return std::max(0.0, farthest);
}

double time_to_horizon(const Outline& outline, const std::vector<Sighted>& sensors, const Twist2& twist, double until) {
  const double to_there = outline.reach() + outline.margin() + fastest_point(outline, twist) * until;
  const bool within_all = std::all_of(sensors.begin(), sensors.end(), [&](const Sighted& one) {
    return length_of(one.eye.place) + to_there + one.nearer <= one.horizon.least();
  });
  if (within_all) return inf;
  const NewGround ground(outline);
  const auto is_beyond_after = [&](double time) {
    return ground.any(way_of(twist, time),
                      [&](const Point2& place) { return is_beyond(sensors, place, outline.margin()); });
  };
  double within = 0.0, beyond = inf;
  for (int i = 1; i <= steps && beyond == inf; ++i) {
    const double time = until * i / steps;
    (is_beyond_after(time) ? beyond : within) = time;
  }
  if (beyond == inf) return inf;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (within + beyond);
    (is_beyond_after(middle) ? beyond : within) = middle;
  }
  return within;
}

}  // namespace safety_control_cloud
