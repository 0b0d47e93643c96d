// SPDX-License-Identifier: BSD-3-Clause
// Compiles HWY_TARGET_INCLUDE, which includes this, for every instruction set but the last; it goes on for that one.
#ifndef SAFETY_CONTROL_CLOUD_FOREACH_TARGET
#define SAFETY_CONTROL_CLOUD_FOREACH_TARGET

#include "targets.hpp"

#ifdef __x86_64__

#define HWY_TARGET HWY_AVX2
#include HWY_TARGET_INCLUDE
#define HWY_TARGET_TOGGLE

#undef HWY_TARGET
#define HWY_TARGET HWY_SSE4
#include HWY_TARGET_INCLUDE
#undef HWY_TARGET_TOGGLE

#endif

#undef HWY_TARGET
#define HWY_TARGET HWY_BASELINE
#define HWY_ONCE 1

#endif
