// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../../input/runs.hpp"
#include "../outlook.hpp"
#include "../places.hpp"

namespace safety_control_cloud {

/// How many points of some runs are what; as in Sight.
struct Counts {
  std::size_t returns = 0;
  std::size_t inside = 0;
  std::size_t too_close = 0;

  Counts& operator+=(const Counts& other) {
    returns += other.returns;
    inside += other.inside;
    too_close += other.too_close;
    return *this;
  }
};

/// Counts the points of the runs [begin, end) and writes the smallest z inside each of them [m], +inf where there is
/// none, to nearest[begin] ... nearest[end - 1]. Which point that is, is left to inside_of(): to look for it in one run
/// afterwards costs less than to carry it through the pass, and the same in every scene.
Counts scan(const Runs& runs, std::size_t begin, std::size_t end, const Outlook& outlook, float* nearest);

/// scan() of all runs, and what goes alongside it, over their bytes once.
Counts scan_and_gather(const Runs& runs, const Outlook& outlook, float* nearest, const Alongside& alongside);

/// The columns of the points inside, in their order.
struct Inside {
  static constexpr std::size_t longest_vector = 64;  ///< lanes; a vector is stored whole, wherever its last point ends

  std::array<std::uint32_t, Runs::longest + longest_vector> columns;
  std::size_t size;
};

Inside inside_of(const Run& run, const Outlook& outlook);

/// The instruction sets that scan() can use on this machine, best first, as "AVX2" or "NEON"; built without Highway
/// "GNU_AVX2", "GNU_NEON".
std::vector<std::string> instruction_sets();

/// For tests and benchmarks: scan() uses this one of instruction_sets() from now on, or the best again for "".
/// Throws std::invalid_argument if there is no such set. Not to be called while another thread scans.
void use_instruction_set(const std::string& name);

}  // namespace safety_control_cloud
