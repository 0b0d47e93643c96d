// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "outline.hpp"
#include "twist.hpp"

namespace safety_control_cloud {

/// [m] by which a point that is inside the margin may come nearer on the way out of it: the sensor's noise. Outside the
/// footprint itself no more than half of the way that is left, so that no series of such motions ever touches it.
double allowance_for(double signed_distance, double noise);

/// Whether a resting point comes nearer to the footprint (inside it: deeper) by `allowance` [m] or more within
/// `duration` [s] of the twist; or is nearer at the end by an eighth of that, or by 2 % of its way: else a series of
/// short motions would creep toward it.
///
/// No says that it surely does not; yes may also be said to one that comes nearer by more than half the allowance. The
/// point moves at a constant speed u, and no distance to a thing changes faster than one moves: standing d above the
/// floor it must not reach, it cannot reach it for d / u. So the path is walked in steps of just that length.
bool comes_nearer(const Outline& outline, const Twist2& twist, const Point2& point, double duration, double allowance);

}  // namespace safety_control_cloud
