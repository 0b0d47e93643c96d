// SPDX-License-Identifier: BSD-3-Clause
#include "eye.hpp"

#include <algorithm>
#include <cmath>

#include "../input/angle.hpp"
#include "../path/escape.hpp"
#include "new_ground.hpp"
#include "pose.hpp"

namespace safety_control_cloud {
namespace {

constexpr int times = 8;
constexpr double way_ahead = 1.0;           ///< [s] of a twist: its direction counts, not how far it leads
constexpr double beside_view = 0.25 * pi;   ///< [rad] beyond which a way leads out of the picture
constexpr double far_ahead = 1.5;           ///< [m] from where on what a gap hides is as wide as a robot
constexpr double farthest_turn = 0.5 * pi;  ///< [rad] after that a twist leads elsewhere
constexpr double soon = 0.5;                ///< [s] of a twist, in which it leads to what is beside
constexpr double nearer = 0.01;             ///< [m] and by so much
constexpr double seam = 0.1;                ///< [rad] between the last beam of a whole turn and the first
constexpr double straight = 0.1;            ///< [rad/m] a driver's hand is not steadier
constexpr double least_away = 0.7071;       ///< cosine: half a right angle to each side

/// `ahead`: the axis in the sensor's own frame.
Eye towards(const Outlook& outlook, const Point& ahead, double half_angle) {
  const Point sensor = outlook.camera(), there = outlook.placed(ahead.x, ahead.y, ahead.z);
  const Point2 place{sensor.z, -sensor.x}, direction{double{there.z} - sensor.z, double{sensor.x} - there.x};
  const double length = length_of(direction);
  if (!(length > 0.1)) return {place, {}, 0.0};
  return {place, (1.0 / length) * direction, half_angle};
}

double angle_between(const Point2& a, const Point2& b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); }

/// Who backs on an arc swings his front into the picture, and drives into what nobody sees.
bool translates_away(const Eye& eye, const Twist2& twist) {
  return speed_of(twist) > 0.0 && angle_between(eye.direction, linear(twist)) > eye.half_angle + beside_view;
}

/// Whether any place to which the footprint comes by a twist, and where it is not now, is such a one.
template <class Is>
bool any_new_place(const Outline& outline, const Twist2& twist, Is is) {
  const NewGround ground(outline);
  for (int i = 1; i <= times; ++i)
    if (ground.any(way_of(twist, way_ahead * i / times), is)) return true;
  return false;
}

/// Whether from somewhere on its way all that the footprint comes to lies in a gap: beside that, it is seen as far as
/// it is new at once, but not what it drives into.
bool leads_into_a_gap(const Outline& outline, const Eye& eye, const Twist2& twist) {
  const double speed = speed_of(twist);
  if (!eye.has_gaps() || speed == 0.0) return false;
  const NewGround ground(outline);
  const double time = std::min(std::max(way_ahead, far_ahead / speed), farthest_turn / std::abs(twist.w));
  for (int i = 1; i <= times; ++i) {
    const Pose2 way = way_of(twist, time * i / times);
    bool is_any_new = false;
    const bool is_beside = ground.any(way, [&](const Point2& place) {
      is_any_new = true;
      return !eye.misses(place);
    });
    if (is_any_new && !is_beside) return true;
  }
  return false;
}

}  // namespace

bool Eye::is_wide() const { return half_angle > 0.5 * pi + seam; }

bool Eye::is_between_sides(const Point2& there) const { return angle_between(direction, there) <= half_angle; }

bool Eye::is_in_a_gap(const Point2& there) const {
  return std::any_of(blind.begin(), blind.end(),
                     [&](const Blind& one) { return angle_between(one.direction, there) <= one.half_angle; });
}

Eye eye_of(const Outlook& outlook, const FieldOfView& field) {
  return towards(outlook, {0.0f, 0.0f, 1.0f}, std::atan(std::max(0.0, std::min(-field.left, field.right))));
}

Eye eye_of(const Outlook& outlook, const ScanView& scan, const Bearings& bearings) {
  const auto along = [](double bearing) {
    return Point{static_cast<float>(std::cos(bearing)), static_cast<float>(std::sin(bearing)), 0.0f};
  };
  const bool all_around = scan.last - scan.first > full_turn - seam;
  Eye eye = towards(outlook, along(all_around ? 0.0 : 0.5 * (scan.first + scan.last)),
                    all_around ? pi : 0.5 * (scan.last - scan.first));
  for (const Bearings::Gap& gap : bearings.gaps())
    eye.blind.push_back({towards(outlook, along(gap.middle), 0.0).direction, gap.half_angle});
  return eye;
}

bool leads_into_the_unseen(const Outline& outline, const Eye& eye, const Twist2& twist) {
  const bool away = translates_away(eye, twist);
  bool is_any_new = false;
  const bool shows = any_new_place(outline, twist, [&](const Point2& place) {
    is_any_new = true;
    return !away && eye.sees(place);
  });
  return (is_any_new && !shows) || leads_into_a_gap(outline, eye, twist);
}

bool leads_to_where_it_looks(const Outline& outline, const Eye& eye, const Twist2& twist) {
  if (speed_of(twist) == 0.0)
    return !any_new_place(outline, twist, [&](const Point2& place) { return !eye.sees(place); });
  return length_of(eye.direction) > 0.0 && eye.looks_along(linear(twist));
}

bool leads_away_from(const Eye& eye, const Twist2& twist) {
  const double speed = speed_of(twist);
  const bool looks_there = eye.half_angle > pi - std::acos(least_away);
  return !looks_there && speed > 0.0 && std::abs(twist.w) <= straight * speed &&
         -dot(eye.direction, linear(twist)) >= least_away * speed;
}

bool is_approached(const Point2& point, const Outline& outline, const Twist2& twist) {
  return comes_nearer(outline, twist, point, soon, nearer);
}

}  // namespace safety_control_cloud
