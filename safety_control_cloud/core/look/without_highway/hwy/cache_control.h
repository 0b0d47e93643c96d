// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "targets.hpp"

namespace safety_control_cloud::without_highway {

inline void Prefetch(const void* from) { __builtin_prefetch(from); }

}  // namespace safety_control_cloud::without_highway
