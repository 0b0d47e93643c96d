// SPDX-License-Identifier: BSD-3-Clause
#include "scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "../text/words.hpp"
#include "angle.hpp"

namespace safety_control_cloud {
namespace {

constexpr double least_step = 1e-6;  ///< [rad] finer than any; a number that is hardly one is none
constexpr double off_by = 1.5;       ///< increments: drivers disagree on whether angle_max is the last beam or the next
constexpr double rounding = 1e-5;    ///< [rad] a whole turn is more than itself as a float32, and as 6.28319
constexpr double longest_turn = 10.0;  ///< [s]
constexpr std::size_t most = 1000000;  ///< beams
constexpr float beyond = 1e4f;         ///< [m] farther than anything matters
constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

void require(bool holds, const std::string& sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

/// Written so that NaN is refused.
void check(const Scan& scan) {
  require(scan.size >= 1 && scan.size <= most, words("a scan of ", scan.size, " ranges"));
  const double step = scan.angle_increment, span = step * static_cast<double>(scan.size - 1);
  require(std::abs(scan.angle_min) <= full_turn + rounding && std::abs(scan.angle_max) <= full_turn + rounding,
          words("angles from ", scan.angle_min, " to ", scan.angle_max, " rad"));
  require(std::abs(step) <= full_turn && (std::abs(step) >= least_step || scan.size == 1) &&
              std::abs(span) <= full_turn + off_by * std::abs(step),
          words(scan.size, " ranges, ", step, " rad apart"));
  require(std::abs(scan.angle_min + span - scan.angle_max) <= off_by * std::abs(step) + rounding,
          words(scan.size, " ranges, ", step, " rad apart, do not lead from ", scan.angle_min, " to ", scan.angle_max,
                " rad"));
  require(scan.range_min >= 0.0 && scan.range_max > scan.range_min,
          words("range_min ", scan.range_min, " and range_max ", scan.range_max));
  const double lasts = scan.time_increment * static_cast<double>(scan.size - 1);
  require(scan.time_increment >= 0.0 && lasts <= longest_turn, words("time_increment ", scan.time_increment, " s"));
  require(scan.scan_time >= 0.0 && scan.scan_time <= longest_turn, words("scan_time ", scan.scan_time, " s"));
}

std::array<float, 6> point_of(float range, double bearing, const Scan& scan) {
  if (range == -inf) return {nan, nan, -inf, -inf, -inf, -inf};
  const auto along = static_cast<float>(std::cos(bearing)), across = static_cast<float>(std::sin(bearing));
  if (range == inf) return {beyond * along, beyond * across, nan, 0.0f, nan, 0.0f};
  if (range == 0.0f) {
    const float z = scan.range_min > 0.0 ? nan : -inf;
    return {beyond * along, beyond * across, z, z, nan, 0.0f};
  }
  if (!(range >= scan.range_min && range <= scan.range_max)) return {nan, nan, nan, nan, nan, nan};
  return {range * along, range * across, 0.0f, 0.0f, 0.0f, 0.0f};
}

}  // namespace

ScanView ScanPoints::of(const Scan& scan) {
  check(scan);
  points_.resize(scan.size);
  for (std::size_t i = 0; i < scan.size; ++i)
    points_[i] = point_of(scan.ranges[i], scan.angle_min + scan.angle_increment * static_cast<double>(i), scan);
  const double steps = static_cast<double>(scan.size - 1), end = scan.angle_min + scan.angle_increment * steps;
  ScanView view{in_rows(points_, scan.size), 3 * sizeof(float), 4 * sizeof(float), 5 * sizeof(float)};
  view.first = std::min(scan.angle_min, end), view.last = std::max(scan.angle_min, end);
  view.descending = scan.angle_increment < 0.0;
  view.range_min = scan.range_min, view.range_max = scan.range_max;
  view.lasts = scan.time_increment > 0.0 ? scan.time_increment * steps : scan.scan_time;
  return view;
}

}  // namespace safety_control_cloud
