// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "remembered.hpp"

namespace safety_control_cloud {

/// Which of the things that were seen are those that are seen now: the ones that have most in common; others are added.
/// Of each thing what was seen before, unless it has moved as a whole. Nearer than `near` [m] ahead of the camera,
/// which has turned by `turning` [rad] from the picture before, is near.
std::vector<Thing> follow(std::vector<Remembered>& things, std::vector<Thing> seen, float near, float turning);

}  // namespace safety_control_cloud
