// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "../look/ray_lines.hpp"
#include "camera_pose.hpp"

namespace safety_control_cloud {

/// Where a camera is and looks, and which way the pixels of its picture do.
struct Gaze {
  Outlook outlook;
  RayLines rays;
  CameraPose camera;
  std::optional<float> nearer;  ///< [m] by which what is seen may have come since the picture before; none: of a raster
  bool has_turned = false;      ///< ever: TF may be a picture late as it turns again

  Gaze(const Outlook& look, const RayLines& lines, const std::optional<float>& step = std::nullopt)
      : outlook(look), rays(lines), camera(camera_pose_of(look)), nearer(step) {}
};

}  // namespace safety_control_cloud
