// SPDX-License-Identifier: BSD-3-Clause
// For which instruction sets the kernel is compiled, and which of them is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// The better, the smaller. AVX3 and SCALAR are never compiled, but asked for.
#define HWY_AVX3 1
#define HWY_AVX2 2
#define HWY_SSE4 4
#define HWY_BASELINE 8  // what every machine has that the compiler builds for
#define HWY_SCALAR 16

#define HWY_INLINE inline __attribute__((always_inline))
#define HWY_NOINLINE __attribute__((noinline))
#define HWY_RESTRICT __restrict__
#define HWY_ALIGN alignas(32)  // the longest vector

namespace safety_control_cloud::without_highway {

struct Target {
  std::int64_t id;
  const char* name;
};

#ifdef __x86_64__
constexpr Target targets[] = {{HWY_AVX2, "GNU_AVX2"}, {HWY_SSE4, "GNU_SSE4"}, {HWY_BASELINE, "GNU_SSE2"}};
#define HWY_EXPORT(FUNCTION)                                                                                      \
  constexpr decltype(&N_GNU_BASELINE::FUNCTION) FUNCTION##_for[] = {&N_GNU_AVX2::FUNCTION, &N_GNU_SSE4::FUNCTION, \
                                                                    &N_GNU_BASELINE::FUNCTION}
#else
#ifdef __ARM_NEON
constexpr Target targets[] = {{HWY_BASELINE, "GNU_NEON"}};
#else
constexpr Target targets[] = {{HWY_BASELINE, "GNU"}};
#endif
#define HWY_EXPORT(FUNCTION) \
  constexpr decltype(&N_GNU_BASELINE::FUNCTION) FUNCTION##_for[] = {&N_GNU_BASELINE::FUNCTION}
#endif

#define HWY_DYNAMIC_DISPATCH(FUNCTION) (*FUNCTION##_for[hwy::place_of_chosen()])

inline bool is_supported(std::int64_t target) {
#ifdef __x86_64__
  if (target == HWY_AVX2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (target == HWY_SSE4) return __builtin_cpu_supports("sse4.1");
#endif
  return target == HWY_BASELINE;
}

inline std::vector<std::int64_t> SupportedAndGeneratedTargets() {
  std::vector<std::int64_t> supported;
  for (const Target& target : targets) {
    if (is_supported(target.id)) supported.push_back(target.id);
  }
  return supported;
}

inline const char* TargetName(std::int64_t id) {
  for (const Target& target : targets) {
    if (target.id == id) return target.name;
  }
  return "";
}

/// 0: whatever the machine has.
inline std::int64_t only_target = 0;
inline void SetSupportedTargetsForTest(std::int64_t target) { only_target = target; }

inline std::size_t place_of_chosen() {
  std::size_t place = 0;
  while (only_target ? targets[place].id != only_target : !is_supported(targets[place].id)) ++place;
  return place;
}

}  // namespace safety_control_cloud::without_highway

namespace hwy = safety_control_cloud::without_highway;  // no name of the library's own, beside which this may be linked
