// SPDX-License-Identifier: BSD-3-Clause
#include "fan.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// Of curvatures [rad/m].
struct Band {
  double least, greatest;
  double width() const { return greatest - least; }
};

/// One side of the question: turning in this direction counts as positive.
struct Turning {
  double before, wanted;  ///< [rad/s]
};

/// [rad] that the heading gains beyond `curvature`, the band's end in this direction.
double gained(const Turning& turning, double curvature, double speed, double share, const Law& law,
              const Factors& factors) {
  const double excess = std::max(0.0, turning.before - curvature * speed * std::min(factors.least, share));
  const double faster = std::max(0.0, factors.most - share);
  const double last = std::max({turning.before, factors.most * turning.wanted, 0.0});
  return 0.5 * (excess * excess + last * last) / law.angular_deceleration +
         0.5 * std::max(0.0, turning.wanted) * faster * faster * speed / law.linear_deceleration;
}

}  // namespace

std::optional<Fan> fan(const Outline& outline, const Law& law, const Response& response, const Twist2& under_way,
                       const Twist2& wanted, const Factors& factors) {
  const double speed = speed_of(wanted), before = speed_of(under_way);
  const double along = dot(linear(under_way), linear(wanted));
  const bool same_direction = along >= 0.0 && cross(linear(under_way), linear(wanted)) == 0.0;
  if (!(speed > 0.0) || !same_direction || (before == 0.0 && under_way.w != 0.0)) return std::nullopt;

  const double share = before / speed;
  const double old_curvature = before > 0.0 ? under_way.w / before : 0.0, new_curvature = wanted.w / speed;
  const Band band{std::min({old_curvature, new_curvature, 0.0}), std::max({old_curvature, new_curvature, 0.0})};
  const double left = gained({under_way.w, wanted.w}, band.greatest, speed, share, law, factors);
  const double right = gained({-under_way.w, -wanted.w}, -band.least, speed, share, law, factors);
  const double way =
      speed * stopping_time(std::max(factors.most, share), response.reaction, response.braking);  // [m] at most
  const double reach = outline.turning_reach(), apart = band.width() / (Fan::size - 1);

  Fan fan{share, {}, 0.0};
  for (std::size_t i = 0; i < Fan::size; ++i)
    fan.twists[i] = {wanted.vx, wanted.vy, speed * (band.least + apart * static_cast<double>(i))};
  fan.widening =
      std::max(left, right) * (reach + way) + band.width() * way * way / 8.0 + 0.5 * apart * way * (reach + 0.5 * way);
  return fan;
}

}  // namespace safety_control_cloud
