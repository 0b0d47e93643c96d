// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../look/ray_lines.hpp"
#include "axis.hpp"

namespace safety_control_cloud {

/// Where a camera looks, and which way the pixels of its picture do.
struct Gaze {
  Outlook outlook;
  RayLines rays;
  Axis axis;
  bool has_turned = false;  ///< ever: TF may be a picture late as it turns again

  Gaze(const Outlook& look, const RayLines& lines) : outlook(look), rays(lines), axis(axis_of(look)) {}
};

}  // namespace safety_control_cloud
