// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "../../safety_control_cloud/core/look/look.hpp"
#include "../../safety_control_cloud/core/memory/near_loss.hpp"

namespace safety_control_cloud {

/// All that the node does for a cloud while it remembers what came near.
inline std::optional<Loss> look_and_judge(const View& view, NearLoss& near_loss, const Placement* placement = nullptr) {
  const Outlook outlook({}, placement ? std::optional<Placement>(*placement) : std::nullopt);
  const Sight sight = look(view, outlook, Crop::Skip, near_loss.rows_for(view));
  return near_loss.judge(view, sight, outlook, 0.0, 0.0);
}

}  // namespace safety_control_cloud
