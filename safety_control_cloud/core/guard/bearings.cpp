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
constexpr float too_close = -std::numeric_limits<float>::infinity();

struct Beam {
  float x, y, z;
  float z_if_inf_is_free;
};

Beam beam_at(const ScanView& scan, std::size_t i) {
  Beam beam;
  std::memcpy(&beam, scan.points.bytes + i * scan.points.point_step, sizeof beam);
  return beam;
}

/// By what each beam is, and whether it shows the robot itself.
bool measures(const Beam& beam, const Outlook& outlook, const std::vector<OwnBox>& self) {
  if (beam.z == too_close) return true;
  if (std::isnan(beam.z)) return !std::isnan(beam.z_if_inf_is_free);
  const Point there = outlook.placed(beam.x, beam.y, beam.z);
  return !is_own(self, there.z, -there.x, -there.y);
}

}  // namespace

std::size_t Bearings::bin_of(double bearing) {
  const double turns = bearing / full_turn, part = turns - std::floor(turns);
  return std::min(bins - 1, static_cast<std::size_t>(part * static_cast<double>(bins)));
}

void Bearings::note(const ScanView& scan, const Outlook& outlook) {
  const std::size_t size = scan.points.width;
  const double step = size > 1 ? (scan.last - scan.first) / static_cast<double>(size - 1) : 0.0;
  bool any_new = false;
  for (std::size_t i = 0; i < size; ++i) {
    const double bearing =
        scan.descending ? scan.last - step * static_cast<double>(i) : scan.first + step * static_cast<double>(i);
    if (measured_[bin_of(bearing)] || !measures(beam_at(scan, i), outlook, self_)) continue;
    any_new = true;  // as far as half way to its neighbours
    for (double beside = 0.0; beside <= 0.5 * step; beside += bin)
      measured_[bin_of(bearing - beside)] = measured_[bin_of(bearing + beside)] = true;
    measured_[bin_of(bearing - 0.5 * step)] = measured_[bin_of(bearing + 0.5 * step)] = true;
  }
  if (any_new) find_gaps();
}

bool Bearings::is_blind_at(double bearing) const {
  return std::any_of(gaps_.begin(), gaps_.end(), [=](const Gap& gap) {
    return std::abs(std::remainder(bearing - gap.middle, full_turn)) < gap.half_angle;
  });
}

void Bearings::find_gaps() {
  gaps_.clear();
  const auto begin = static_cast<std::size_t>(std::find(measured_.begin(), measured_.end(), true) - measured_.begin());
  std::size_t missing = 0;
  for (std::size_t i = 1; i <= bins; ++i) {
    if (!measured_[(begin + i) % bins]) {
      ++missing;
      continue;
    }
    const double width = bin * static_cast<double>(std::exchange(missing, 0));
    if (width >= least_gap) gaps_.push_back({bin * static_cast<double>(begin + i) - 0.5 * width, 0.5 * width});
  }
}

}  // namespace safety_control_cloud
