// SPDX-License-Identifier: BSD-3-Clause
#include "fan.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

constexpr double nearly_none = 0.02;  ///< [m/s] to the side, as odometry has it that is made of poses

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

/// What a motion has in the direction of the wanted one, and to its side [m/s].
struct Split {
  double along, across;
};

std::optional<Split> split(const Twist2& under_way, const Twist2& wanted) {
  const double speed = speed_of(wanted);
  if (!(speed > 0.0)) return std::nullopt;
  const double along = dot(linear(under_way), linear(wanted)) / speed;
  const double across = std::abs(cross(linear(under_way), linear(wanted))) / speed;
  const bool turns_in_place = along == 0.0 && under_way.w != 0.0;
  if (along < 0.0 || across > nearly_none || turns_in_place) return std::nullopt;
  return Split{along, across};
}

/// [m] that it leads until it has been shed.
double way_across(double across, double share, double speed, const Law& law, const Response& response,
                  const Factors& factors) {
  const double change = std::max(std::abs(factors.least - share), std::abs(factors.most - share));
  const double linear_time = ((change + factors.most) * speed + across) / law.linear_deceleration;
  return across * (response.delay + linear_time);
}

}  // namespace

std::optional<Fan> fan(const Outline& outline, const Law& law, const Response& response, const Twist2& under_way,
                       const Twist2& wanted, const Factors& factors) {
  const auto before = split(under_way, wanted);
  if (!before) return std::nullopt;
  const double speed = speed_of(wanted), share = before->along / speed;
  const double old_curvature = share > 0.0 ? under_way.w / before->along : 0.0, new_curvature = wanted.w / speed;
  const Band band{std::min({old_curvature, new_curvature, 0.0}), std::max({old_curvature, new_curvature, 0.0})};
  const double left = gained({under_way.w, wanted.w}, band.greatest, speed, share, law, factors);
  const double right = gained({-under_way.w, -wanted.w}, -band.least, speed, share, law, factors);
  const double way =
      speed * stopping_time(std::max(factors.most, share), response.reaction, response.braking);  // [m] at most
  const double reach = outline.turning_reach(), apart = band.width() / (Fan::size - 1);

  Fan fan{share, {}, 0.0};
  for (std::size_t i = 0; i < Fan::size; ++i)
    fan.twists[i] = {wanted.vx, wanted.vy, speed * (band.least + apart * static_cast<double>(i))};
  fan.widening = std::max(left, right) * (reach + way) + band.width() * way * way / 8.0 +
                 0.5 * apart * way * (reach + 0.5 * way) +
                 way_across(before->across, share, speed, law, response, factors);
  return fan;
}

}  // namespace safety_control_cloud
