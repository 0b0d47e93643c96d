// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "moved.hpp"
#include "thing.hpp"

namespace safety_control_cloud {

/// A thing that came near, over many clouds.
struct Remembered {
  Thing seen;                    ///< as the latest cloud shows it that is not blind for it; no spots if it does not
  std::vector<Spot> lost;        ///< what was seen of it, and now is neither seen nor seen past
  double size = 0.0;             ///< [m2] at most
  double freed = 0.0;            ///< [m2] of the lost, since it was last seen, that is seen past by now
  unsigned clouds = 0;           ///< that have shown it
  bool stood = false;            ///< on the near floor, until it was seen to hang
  bool at_border = false;        ///< when it was seen last
  bool vanished = false;         ///< in mid-air: see ThingsMemory
  std::optional<Moved> moved{};  ///< none: it is lost where it was seen
  bool is_slight = false;        ///< of few pixels, which in a single cloud may be false

  bool is_seen() const { return !seen.spots.empty(); }
  bool was_never_seen() const { return !lost.empty() && lost.front().only_hides; }  ///< but only what it hid
};

}  // namespace safety_control_cloud
