// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "../../safety_control_cloud/core/look/corridor.hpp"
#include "../../safety_control_cloud/core/memory/near_loss.hpp"

namespace safety_control_cloud {

/// All that the node does for a cloud while it remembers what came near.
inline std::optional<Loss> look_and_judge(const View& view, NearLoss& near_loss, const Placement* placement = nullptr) {
  Gaze gaze;
  gaze.memory = near_loss.memory_for(view);
  gaze.placement = placement;
  const Sight sight = look(view, Corridor{}, gaze);
  return near_loss.judge(view, sight, Corridor{}, gaze, 0.0);
}

}  // namespace safety_control_cloud
