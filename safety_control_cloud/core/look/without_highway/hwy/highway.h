// SPDX-License-Identifier: BSD-3-Clause
// What the kernel uses of Highway, by the same names, in the vectors that GCC and Clang know by themselves: on the path
// of includes where Highway is not. Compiled once for every instruction set, as what includes it.
#include "targets.hpp"

#ifndef HWY_TARGET
#define HWY_TARGET HWY_BASELINE
#endif

#undef HWY_NAMESPACE
#undef HWY_BEFORE_NAMESPACE
#undef HWY_AFTER_NAMESPACE
#undef HWY_ATTR
#undef SAFETY_CONTROL_CLOUD_TARGET

#if HWY_TARGET == HWY_AVX2
#define HWY_NAMESPACE N_GNU_AVX2
#define SAFETY_CONTROL_CLOUD_TARGET "avx2,fma"
#elif HWY_TARGET == HWY_SSE4
#define HWY_NAMESPACE N_GNU_SSE4
#define SAFETY_CONTROL_CLOUD_TARGET "sse4.1"
#else
#define HWY_NAMESPACE N_GNU_BASELINE
#endif

#define SAFETY_CONTROL_CLOUD_PRAGMA_OF(...) _Pragma(#__VA_ARGS__)
#define SAFETY_CONTROL_CLOUD_PRAGMA(...) SAFETY_CONTROL_CLOUD_PRAGMA_OF(__VA_ARGS__)
#define SAFETY_CONTROL_CLOUD_SEMICOLON static_assert(true)

#ifndef SAFETY_CONTROL_CLOUD_TARGET
#define HWY_ATTR
#define HWY_BEFORE_NAMESPACE() SAFETY_CONTROL_CLOUD_SEMICOLON
#define HWY_AFTER_NAMESPACE() SAFETY_CONTROL_CLOUD_SEMICOLON
#else
#define HWY_ATTR __attribute__((target(SAFETY_CONTROL_CLOUD_TARGET)))
#ifdef __clang__
#define HWY_BEFORE_NAMESPACE()                                                     \
  SAFETY_CONTROL_CLOUD_PRAGMA(clang attribute push(HWY_ATTR, apply_to = function)) \
  SAFETY_CONTROL_CLOUD_SEMICOLON
#define HWY_AFTER_NAMESPACE() SAFETY_CONTROL_CLOUD_PRAGMA(clang attribute pop) SAFETY_CONTROL_CLOUD_SEMICOLON
#else
#define HWY_BEFORE_NAMESPACE()                  \
  SAFETY_CONTROL_CLOUD_PRAGMA(GCC push_options) \
  SAFETY_CONTROL_CLOUD_PRAGMA(GCC target(SAFETY_CONTROL_CLOUD_TARGET)) SAFETY_CONTROL_CLOUD_SEMICOLON
#define HWY_AFTER_NAMESPACE() SAFETY_CONTROL_CLOUD_PRAGMA(GCC pop_options) SAFETY_CONTROL_CLOUD_SEMICOLON
#endif
#endif

#include "lanes-inl.hpp"
#include "places-inl.hpp"
#include "tags-inl.hpp"
