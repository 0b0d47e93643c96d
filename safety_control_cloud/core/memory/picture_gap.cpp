// SPDX-License-Identifier: BSD-3-Clause
#include "picture_gap.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace safety_control_cloud {
namespace {

/// [s] No camera takes two pictures sooner: such stamps are not of when they were taken.
constexpr double least = 1e-4;

}  // namespace

double PictureGap::note(double stamp, double now, double source_timeout) {
  const auto before = std::exchange(last_, Came{stamp, now});
  if (!before) return std::numeric_limits<double>::infinity();
  const double by_stamps = stamp - before->stamp, by_arrival = now - before->at;
  if (!(by_stamps >= least)) return by_arrival;
  return by_arrival > 0.5 * source_timeout ? std::max(by_stamps, by_arrival) : by_stamps;
}

}  // namespace safety_control_cloud
