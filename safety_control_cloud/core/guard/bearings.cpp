// SPDX-License-Identifier: BSD-3-Clause
#include "bearings.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace safety_control_cloud {
namespace {

/// [rad] A narrower gap is that of a leg, or by chance: at a metre no robot fits into it.
constexpr double least_gap = 0.25;
/// [s] Less than it takes for what no longer returns to be gone: dirt that comes on the way takes nothing with it.
constexpr double lately = 1.0;
constexpr float too_close = -std::numeric_limits<float>::infinity();

struct Beam {
  float x, y, z;
  float z_if_inf_is_free, z_if_zero_is_inf, z_if_both;
};

Beam beam_at(const ScanView& scan, std::size_t i) {
  Beam beam;
  std::memcpy(&beam, scan.points.bytes + i * scan.points.point_step, sizeof beam);
  return beam;
}

}  // namespace

bool Bearings::measures(const ScanView& scan, std::size_t beam, const Outlook& outlook) const {
  const Beam seen = beam_at(scan, beam);
  if (seen.z == too_close) return true;
  if (std::isnan(seen.z)) return !std::isnan(zero_ == Zero::WhatInfSays ? seen.z_if_both : seen.z_if_inf_is_free);
  const Point there = outlook.placed(seen.x, seen.y, seen.z);
  return !is_own(self_, there.z, -there.x, -there.y);
}

std::size_t Bearings::bin_of(double bearing) {
  const double turns = bearing / full_turn, part = turns - std::floor(turns);
  return std::min(bins - 1, static_cast<std::size_t>(part * static_cast<double>(bins)));
}

void Bearings::note(const ScanView& scan, const Outlook& outlook, double now) {
  const std::size_t size = scan.points.width;
  const double step = size > 1 ? (scan.last - scan.first) / static_cast<double>(size - 1) : 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    const double bearing =
        scan.descending ? scan.last - step * static_cast<double>(i) : scan.first + step * static_cast<double>(i);
    if (!measures(scan, i, outlook)) continue;
    for (double beside = 0.0; beside <= 0.5 * step; beside += bin)  // as far as half way to its neighbours
      measured_[bin_of(bearing - beside)] = measured_[bin_of(bearing + beside)] = now;
    measured_[bin_of(bearing - 0.5 * step)] = measured_[bin_of(bearing + 0.5 * step)] = now;
  }
  latest_ = now;
  find_gaps();
}

bool Bearings::is_recent(double measured) const { return latest_ - measured < lately; }

/// Where a bearing is counted from another turn than the beam's, rounding may take it for the bin beside.
bool Bearings::measures_at(double bearing) const {
  const auto is_measured = [&](double at) { return is_recent(measured_[bin_of(at)]); };
  return latest_ == never || is_measured(bearing) || is_measured(bearing - 0.5 * bin) ||
         is_measured(bearing + 0.5 * bin);
}

void Bearings::find_gaps() {
  gaps_.clear();
  const auto first = std::find_if(measured_.begin(), measured_.end(), [this](double at) { return is_recent(at); });
  if (first == measured_.end()) return gaps_.push_back({0.0, pi});
  const auto begin = static_cast<std::size_t>(first - measured_.begin());
  std::size_t missing = 0;
  for (std::size_t i = 1; i <= bins; ++i) {
    if (!is_recent(measured_[(begin + i) % bins])) {
      ++missing;
      continue;
    }
    const double width = bin * static_cast<double>(std::exchange(missing, 0));
    if (width >= least_gap) gaps_.push_back({bin * static_cast<double>(begin + i) - 0.5 * width, 0.5 * width});
  }
}

}  // namespace safety_control_cloud
