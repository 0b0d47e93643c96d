// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cause.hpp"

namespace safety_control_cloud {

/// Why what a camera sent, or did not send, is not to be believed: with it the robot stands.
struct Doubt {
  Cause cause = Cause::NoCloud;
  std::string reason;  ///< the cause in words, with its figures
};

}  // namespace safety_control_cloud
