// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../look/ray_lines.hpp"
#include "camera_pose.hpp"

namespace safety_control_cloud {

/// Where a camera is and looks, and which way the pixels of its picture do.
struct Gaze {
  Outlook outlook;
  RayLines rays;
  CameraPose camera;
  bool has_turned = false;  ///< ever: TF may be a picture late as it turns again

  Gaze(const Outlook& look, const RayLines& lines) : outlook(look), rays(lines), camera(camera_pose_of(look)) {}
};

}  // namespace safety_control_cloud
