// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#endif

namespace safety_control_cloud {

constexpr std::size_t cache_line = 64;     ///< [byte]
constexpr std::size_t memory_page = 4096;  ///< [byte]

/// How a processor is best told what it will read, while little is done with it.
enum class Told {
  LinesTwice,  ///< each line, early into the outer cache and soon into the inner one: Intel's, and others that nobody
               ///< measured
  LinesOnce,   ///< each line, early into the inner cache: AMD's from Zen 5 on
  Pages,       ///< the pages alone: earlier ones of AMD ask early enough for the lines of a page that they have found
};

/// Told otherwise, a look at a VGA cloud of 12 bytes a point takes a Zen 4 1.1 times as long as reading it, and 0.9 so;
/// a Zen 5 1.6 times with pages alone, 1.0 with lines twice, and 0.86 so.
inline const Told best_told = [] {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_cpu_init();
  if (__builtin_cpu_is("amd") == 0) return Told::LinesTwice;
  constexpr unsigned zen_5 = 0x1a;
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (__get_cpuid(1, &a, &b, &c, &d) == 0) return Told::LinesTwice;
  const unsigned family = ((a >> 8U) & 0xfU) + ((a >> 20U) & 0xffU);
  return family >= zen_5 ? Told::LinesOnce : Told::Pages;
#else
  return Told::LinesTwice;
#endif
}();

/// Asks for a line that will be read in a while, into the outer cache, which can ask for more at once than the inner.
/// Where nothing lies it does no harm.
[[gnu::always_inline]] inline void fetch_line(const std::uint8_t* from) { __builtin_prefetch(from, 0, 2); }

/// The same for the bytes that come up, where a cloud is read from end to end: most processors see that by themselves,
/// but ask too late, and none across the end of a page.
[[gnu::always_inline]] inline void fetch_early(const std::uint8_t* from, std::size_t size) {
  constexpr std::size_t distance = 6144;
  for (std::size_t i = 0; i < size; i += cache_line) fetch_line(from + distance + i);
}

/// The same, and those that come up soon into the inner cache.
[[gnu::always_inline]] inline void fetch_twice(const std::uint8_t* from, std::size_t size) {
  constexpr std::size_t distance = 1536;
  fetch_early(from, size);
  for (std::size_t i = 0; i < size; i += cache_line) __builtin_prefetch(from + distance + i);
}

/// The same, each line once, early, into the inner cache.
[[gnu::always_inline]] inline void fetch_once(const std::uint8_t* from, std::size_t size) {
  constexpr std::size_t distance = 8192;
  for (std::size_t i = 0; i < size; i += cache_line) __builtin_prefetch(from + distance + i);
}

/// The first line of each page of the blocks that begin so far after those.
template <std::size_t distance, std::size_t block>
[[gnu::always_inline]] inline void fetch_pages_of_blocks(const std::uint8_t* from, std::size_t size) {
  const auto begin = reinterpret_cast<std::uintptr_t>(from) + distance;
  for (std::uintptr_t next = (begin + block - 1) / block * block; next < begin + size; next += block) {
    for (std::size_t i = 0; i < block; i += memory_page) fetch_line(reinterpret_cast<const std::uint8_t*>(next + i));
  }
}

/// The first line of each page that comes up after those: where a page lies takes the processor as long to find as a
/// line does to come, and whatever is asked of the page waits for it. The first, since Intel's go on upward from there
/// by themselves: told another line of each, a Xeon takes 1.15 times as long for rows of 7,680 bytes. A Zen 4 goes on
/// to nothing else while it looks for a page, but for several at the same time, so it is asked for many whenever a
/// block of them begins: so it looks at a VGA cloud of 12 bytes a point in 0.15 ms, and page by page in 0.16, or in
/// 0.19 beside other work.
[[gnu::always_inline]] inline void fetch_pages(const std::uint8_t* from, std::size_t size) {
  if (best_told == Told::Pages) return fetch_pages_of_blocks<32768, 16 * memory_page>(from, size);
  fetch_pages_of_blocks<12288, memory_page>(from, size);
}

}  // namespace safety_control_cloud
