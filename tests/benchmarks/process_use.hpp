// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <vector>

namespace safety_control_cloud {

/// What processes have used so far, all their threads together.
struct ProcessUse {
  double cpu = 0.0;  ///< [s] in user space and in the kernel, to the nanosecond
  long faults = 0;   ///< pages that the kernel had to provide without reading them from a disk
};

/// Throws std::runtime_error if one of them does not exist.
ProcessUse use_of(const std::vector<pid_t>& processes);

}  // namespace safety_control_cloud
