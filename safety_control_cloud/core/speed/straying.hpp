// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law.hpp"

namespace safety_control_cloud {

/// The factors at which a wanted twist may come to be driven.
struct Factors {
  double least;
  double most;
  bool in_step = false;  ///< told to slow no faster than both axes can, so that neither is ahead of the other
};

/// How far a base leaves the path of a wanted twist on which it is judged, since it cannot change its twist at once and
/// brakes each axis at a rate of its own. A bound, for the margin; the reasoning:
///
/// The base moves with u0 = `under_way` until a command has its effect, changes each axis from u0 to s u1 (u1 =
/// `wanted`, s within `factors`) and brakes each axis to 0, linearly in time and at no less than the law's rates. Split
/// u0 = k u1 + u', with a k >= 0: the robot's `share`. What is left is a motion along the path of u1, at a factor
/// between k and s, and what lies beside it:
/// - u' itself, until it has been shed: its integral, delay + half the time of the change + half that of braking;
/// - two axes that need times t and t' for the same change of factor c: c |t - t'| / 2 of either axis, whichever of the
///   two one takes for the one that keeps to the path.
/// An error e in the angle carries the footprint sideways by e times its reach, and all that follows by e times the
/// length of that path; where e grows while the robot slows, as between two axes that brake together, by half of it.
/// Time along the path is no concern here: the law's is that of the greater of k and s.
struct Straying {
  double share;     ///< k, chosen so that the bound is small
  double widening;  ///< [m]
};
Straying straying(const Outline& outline, const Law& law, const Response& response, const Twist2& under_way,
                  const Twist2& wanted, const Factors& factors);

}  // namespace safety_control_cloud
