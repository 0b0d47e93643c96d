// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "../input/probes.hpp"
#include "doubt.hpp"

namespace safety_control_cloud {

/// What tells the pictures of two cameras apart that send over one connection.
struct Picture {
  double stamp = 0.0;               ///< [s]
  std::string frame = {};           ///< of its header
  double returns = 0.0;             ///< their share of all points
  std::optional<double> nearest{};  ///< [m]
  double inside = 0.0;              ///< the corridor, as a share of all points
  std::size_t points = 0;           ///< all of them; 0: so many that chance changes no share
  Probes probes = {};               ///< of a picture in rows and columns
};

/// Knows when the pictures of two cameras come in turn, though one publisher sends them: two drivers in one process
/// share its name and its connection. One camera's picture resembles the one before it; those of two go to and fro
/// between two frames, two contents, or stamps that run backwards. The nearest point alone may be one pixel that
/// flickers. One whose light goes on and off returns now more and now less of the same.
class TurnsWatch {
 public:
  /// A picture has come at `now` [s, steady]: a doubt if the latest went to and fro, and for `timeout` [s]
  /// after they last did.
  std::optional<Doubt> note(const Picture& picture, double now, double timeout);

 private:
  std::deque<Picture> latest_;
  std::optional<double> in_turn_;  ///< [s] steady: when they last came so
};

}  // namespace safety_control_cloud
