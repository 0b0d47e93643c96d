// SPDX-License-Identifier: BSD-3-Clause
// The path of a point p under a twist (v, w), with a its apparent velocity, J a turn to the left, q = w / 2 and
// r = tan(q t) / q, is  p(r) = p + (r a - q r^2 J a) / (1 + q^2 r^2):  a circle, or a line for q = 0, by one formula
// that divides by nothing that vanishes. Put into the equation of a line, or of a circle, and multiplied by 1 + q^2
// r^2, it leaves a polynomial of degree 2 in r whose leading coefficient is q^2 times the distance, or the power, of
// the antipode 2 c - p, which is where the point has come after half a turn (c = J v / w is the centre of rotation).
#include "sweep.hpp"

#include <algorithm>

namespace safety_control_cloud {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double farthest = 1e6;   // [m]: squares of squares stay far from overflow
constexpr double rounding = 1e-6;  // [m] by which the broad phase is wider than the exact one

double square(double x) { return x * x; }

/// A distance, or a power, that is on the boundary but for rounding and `touch`.
double snapped(double value, double least) { return value < 0.0 && value >= -least ? 0.0 : value; }

/// No later than the moment by more than rounding, by the first terms of the arc tangent; 0 from half a turn on.
double about(const Moment& moment, double half_rate) {
  if (!(moment.denominator > 0.0)) return 0.0;
  const double ratio = moment.numerator / moment.denominator, tangent = half_rate * ratio;
  return ratio * (1.0 - tangent * tangent / 3.0) * (1.0 - 1e-12);
}

}  // namespace

double time_of(const Moment& moment, double half_rate) {
  const double ratio = moment.numerator / moment.denominator;
  const double tangent = half_rate * ratio;
  if (tangent >= 0.0 && tangent < 1e-4) return ratio * (1.0 - tangent * tangent / 3.0);  // atan(x) / x
  return std::atan2(half_rate * moment.numerator, moment.denominator) / half_rate;
}

Sweep::Sweep(const Outline& outline, const Twist2& twist, double widening, double horizon)
    : outline_(outline),
      twist_(twist),
      velocity_turned_(turned_left(linear(twist))),
      half_rate_(0.5 * twist.w),
      margin_(outline.radius() + outline.margin() + widening),
      horizon_(horizon),
      speed_(speed_of(twist)),
      extent_(outline.reach() + outline.margin() + widening),
      squared_reach_(squared_reach(horizon)),
      is_sound_(safety_control_cloud::is_sound(twist) && widening >= 0.0 && horizon >= 0.0) {
  for (const Side& side : outline.sides()) sides_.push_back(moved_outward(side));
  find_lane(margin_ + rounding);
}

Sweep::MovedSide Sweep::moved_outward(const Side& side) const {
  const Point2 velocity = linear(twist_);
  const double offset = dot(side.outward, side.segment.from) + margin_;
  return {side.outward,
          side.along,
          offset,
          dot(side.along, side.segment.from) - touch,
          dot(side.along, side.segment.to) + touch,
          half_rate_ * (dot(side.outward, velocity_turned_) - half_rate_ * offset),
          -dot(side.outward, velocity),
          dot(side.along, velocity),
          dot(side.along, velocity_turned_)};
}

/// A number that a point keeps while the twist lasts, and that grows with its distance from the centre of rotation
/// (|w| / 2 times the difference of the squared distances of point and origin from it); for w = 0, with how far it lies
/// to one side of the path. Its gradient is as long as the point's velocity.
double Sweep::lane_of(const Point2& point) const {
  const double lane = half_rate_ * dot(point, point) - dot(point, velocity_turned_);
  return half_rate_ < 0.0 ? -lane : lane;
}

void Sweep::find_lane(double margin) {
  const double q = std::abs(half_rate_);
  const auto speed_at = [&](const Point2& point) { return length_of(apparent_velocity(twist_, point)); };
  nearest_lane_ = infinity, farthest_lane_ = -infinity;
  Point2 nearest;
  const auto include = [&](const Point2& point) {
    const double lane = lane_of(point);
    if (lane < nearest_lane_) nearest_lane_ = lane, nearest = point;
    farthest_lane_ = std::max(farthest_lane_, lane + margin * speed_at(point) + q * margin * margin);
  };
  for (const Point2& corner : outline_.round_corners()) include(corner);
  for (const Side& side : outline_.sides()) {
    include(side.segment.from);
    const Point2 from_centre = 2.0 * q * side.segment.from - (half_rate_ < 0.0 ? -1.0 : 1.0) * velocity_turned_;
    const double foot = -dot(from_centre, side.along) / (2.0 * q);  // of the perpendicular from the centre
    if (foot > 0.0 && foot < length_of(side.segment.to - side.segment.from))
      include(side.segment.from + foot * side.along);
  }
  const Point2 centre = (0.5 / half_rate_) * velocity_turned_;
  if (is_finite(centre) && outline_.signed_distance(centre) <= margin - outline_.radius()) {
    nearest_lane_ = lane_of(centre) - q * margin * margin;
  } else {
    nearest_lane_ += q * margin * margin - margin * speed_at(nearest);
  }
}

/// [m2] from the origin, of all that may be touched within so much time.
double Sweep::squared_reach(double time) const {
  return square(std::min(farthest, extent_ + rounding + (speed_ > 0.0 ? speed_ * time : 0.0)));
}

bool Sweep::may_be_reached(const Point2& point, double squared_distance, double before) const {
  if (squared_distance > (before < horizon_ ? squared_reach(before) : squared_reach_)) return false;
  const double lane = lane_of(point);
  return lane >= nearest_lane_ && lane <= farthest_lane_;
}

std::optional<Moment> Sweep::entry_through(const MovedSide& side, const Point2& point,
                                           const std::optional<Moment>& earliest) const {
  const double x = dot(side.outward, point), s = dot(side.along, point), q = half_rate_;
  const Crossing crossing{snapped(side.antipode - q * q * x, q * q * touch), side.inward_speed + twist_.w * s,
                          snapped(x - side.offset, touch)};
  const std::optional<Moment> moment = entry(crossing, q != 0.0);
  if (!moment || (earliest && !is_before(*moment, *earliest))) return std::nullopt;
  const double n = moment->numerator, d = moment->denominator;
  const double forward = -side.speed_along - twist_.w * x, sideward = twist_.w * s - side.turned_speed_along;
  const double there = s + n * (d * forward - q * n * sideward) / (d * d + q * q * n * n);
  if (there < side.first || there > side.last) return std::nullopt;
  return moment;
}

std::optional<Moment> Sweep::entry_around(const Point2& corner, const Point2& point) const {
  const Point2 away = point - corner, antipode = velocity_turned_ - half_rate_ * (point + corner);
  const double least = touch * (2.0 * margin_ + touch);
  const Crossing crossing{snapped(dot(antipode, antipode) - square(half_rate_ * margin_), square(half_rate_) * least),
                          2.0 * (twist_.w * cross(point, corner) - dot(away, linear(twist_))),
                          snapped(dot(away, away) - square(margin_), least)};
  return entry(crossing, half_rate_ != 0.0);
}

double Sweep::time_to_contact(const Point2& point, double before) const {
  const double squared_distance = dot(point, point);
  if (!is_sound_ || std::isnan(squared_distance)) return 0.0;
  if (squared_distance <= square(extent_) && outline_.signed_distance(point) < margin_ - outline_.radius() - touch)
    return 0.0;
  if (!may_be_reached(point, squared_distance, before)) return infinity;
  std::optional<Moment> earliest;
  for (const MovedSide& side : sides_) {
    if (const auto moment = entry_through(side, point, earliest)) earliest = moment;
  }
  for (const Point2& corner : outline_.round_corners()) {
    if (margin_ == 0.0) break;
    const auto moment = entry_around(corner, point);
    if (moment && (!earliest || is_before(*moment, *earliest))) earliest = moment;
  }
  if (!earliest || about(*earliest, std::abs(half_rate_)) > std::min(before, horizon_)) return infinity;
  const double time = time_of(*earliest, std::abs(half_rate_));
  return time <= horizon_ ? time : infinity;
}

}  // namespace safety_control_cloud
