// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <malloc.h>

#include <limits>

namespace safety_control_cloud {

/// For a process that receives clouds. roscpp takes new memory for each message that it receives. malloc would get a
/// buffer of megabytes from the system each time, which then clears it page by page; kept, it is the same memory again.
inline void keep_memory_for_reuse() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_ARENA_MAX, 1);  // a thread's own would end at 64 MB
}

}  // namespace safety_control_cloud
