// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "straying.hpp"

namespace safety_control_cloud {

/// All the ways on which a base may come to drive a wanted arc and to stop, for one that moves along already: as arcs
/// of curvatures in a band, and a bound on how far it strays from the nearest of them. Where a robot changes from one
/// arc to another, or brakes its turning sooner than its speed, the ways lie to one side of the wanted one, and a
/// margin to both sides (straying.hpp) keeps it from what it cannot touch. The reasoning:
///
/// As there, the base moves with u0 = `under_way` for the delay, changes each axis to s u1 and brakes, each axis at no
/// less than the law's rates. Let u0 drive k >= 0 times the linear part of u1. By the length sigma of its way, the
/// heading theta of the robot has a slope, the curvature w / v. That lies between the least and the greatest of u0's,
/// u1's and 0, but for what the turning gains while the speed is behind it:
/// - the old turning, where the speed has dropped to s already: half its excess over the band, times the time that
///   takes;
/// - the new turning, where the speed has not come up to s yet: the same of the speed's change;
/// - the last turning, where the speed is 0 already.
/// That makes an angle `gained` [rad] in all, which carries the footprint by gained (reach + S), with S the length of
/// the way. Of the rest, at each sigma the arc that ends in the same heading is one of the band; of two ways whose
/// slopes lie in a band of width B, and which begin and end in the same heading, one lies no farther than B S^2 / 8
/// from the other. The nearest of the arcs that are taken is off by half of what is between two of them, h / 2 of a
/// curvature: (h / 2) S (reach + S / 2). What u0 has across that direction is slight, and is shed as in straying.hpp.
struct Fan {
  static constexpr std::size_t size = 5;
  double share;                     ///< k
  std::array<Twist2, size> twists;  ///< each with the wanted one's linear part
  double widening;                  ///< [m]
};

/// None where the two do not drive in the same direction. Arguments as straying()'s.
std::optional<Fan> fan(const Outline& outline, const Law& law, const Response& response, const Twist2& under_way,
                       const Twist2& wanted, const Factors& factors);

}  // namespace safety_control_cloud
