// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>

namespace safety_control_cloud {

/// A moment of a motion that turns by w: numerator / denominator = tan(|w| t / 2) / (|w| / 2), which is t itself at
/// w = 0. As a ratio it names every moment of one full turn, half of it (denominator 0) among them, and two of them are
/// compared without a division or an arc tangent. numerator >= 0.
struct Moment {
  double numerator = 0.0;
  double denominator = 1.0;
};

inline bool is_before(const Moment& a, const Moment& b) {
  return a.numerator * b.denominator < b.numerator * a.denominator;
}

/// [s]; half_rate: |w| / 2.
double time_of(const Moment& moment, double half_rate);

/// a r^2 + b r + c, over the ratio r of a moment, has the sign of a point's distance to a boundary: outside it is more
/// than 0. So have both kinds of boundary of a widened polygon, whatever the twist: see sweep.cpp.
struct Crossing {
  double a;
  double b;
  double c;
};

/// When the point comes in from outside, which happens once in a turn or never; to touch the boundary is not to enter.
inline std::optional<Moment> entry(const Crossing& crossing, bool turns) {
  const auto& [a, b, c] = crossing;
  const double discriminant = b * b - 4.0 * a * c;
  const bool falls_in_from_the_boundary = c == 0.0 && b == 0.0 && a < 0.0;
  if (!(discriminant > 0.0) && !falls_in_from_the_boundary) return std::nullopt;
  // Of the two roots that where the sign falls; in the form in which nothing cancels.
  const double root = std::sqrt(discriminant);
  Moment moment = b < 0.0 ? Moment{2.0 * c, root - b} : Moment{-(b + root), 2.0 * a};
  if (moment.numerator < 0.0) moment = {-moment.numerator, -moment.denominator};
  if (moment.numerator == 0.0) return Moment{};
  if (!turns && moment.denominator <= 0.0) return std::nullopt;  // on a line, what has passed does not come again
  return moment;
}

}  // namespace safety_control_cloud
