// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace safety_control_cloud {

/// For how long what is lost is remembered.
struct Patience {
  double now = 0.0;      ///< [s] steady
  double timeout = 0.0;  ///< [s]; 0 = never

  bool ends(double lost_since) const { return timeout > 0.0 && now - lost_since >= timeout; }
};

}  // namespace safety_control_cloud
