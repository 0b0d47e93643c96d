// SPDX-License-Identifier: BSD-3-Clause
#include "new_ground.hpp"

#include <cmath>

#include "../input/angle.hpp"

namespace safety_control_cloud {
namespace {

constexpr int around_circle = 24;
constexpr double nearest = 2e-3;  ///< [m] from where the footprint is now

}  // namespace

NewGround::NewGround(const Outline& outline) : outline_(outline) {
  for (const Side& side : outline.sides()) {
    boundary_.push_back(side.segment.from);
    boundary_.push_back(0.5 * (side.segment.from + side.segment.to));
  }
  for (int i = 0; outline.sides().empty() && i < around_circle; ++i) {
    const double angle = full_turn * i / around_circle;
    boundary_.push_back({outline.radius() * std::cos(angle), outline.radius() * std::sin(angle)});
  }
}

bool NewGround::is_new(const Point2& place) const { return outline_.signed_distance(place) > nearest; }

}  // namespace safety_control_cloud
