// SPDX-License-Identifier: BSD-3-Clause
#include "contact.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {

Contact contact(const Obstacles& obstacles, const std::vector<double>& times, std::size_t min_points) {
  std::vector<std::size_t> touched;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (std::isfinite(times[i])) touched.push_back(i);
  }
  const auto is_sooner = [&](std::size_t a, std::size_t b) { return times[a] < times[b]; };
  std::sort(touched.begin(), touched.end(), is_sooner);
  std::size_t returns = 0;
  for (const std::size_t i : touched) {
    returns += obstacles.counts.empty() ? 1 : obstacles.counts[i];
    if (returns >= min_points) return {times[i], i};
  }
  return {};
}

}  // namespace safety_control_cloud
