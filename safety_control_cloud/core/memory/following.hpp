// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "remembered.hpp"

namespace safety_control_cloud {

/// By which picture something is shown.
struct Shown {
  std::uint32_t picture;  ///< its number
  float turning;          ///< [rad] by which the camera turned from the one before
};

/// Which of the things that were seen are those that are seen now: the ones that have most in common; others are added.
/// Of each thing what was seen before, unless it has moved as a whole. Nearer than `near` [m] ahead of the camera is
/// near.
std::vector<Thing> follow(std::vector<Remembered>& things, std::vector<Thing> seen, float near, const Shown& shown);

}  // namespace safety_control_cloud
