// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "../input/scan.hpp"
#include "../look/outlook.hpp"
#include "../path/obstacles.hpp"

namespace safety_control_cloud {

/// Where a range finder has ever measured anything, be it that nothing is there (+Inf, REP 117). A filter may take
/// beams away and leave the angles as they are, and behind a part of the robot itself nobody looks: what a scan names
/// is not what it shows.
class Bearings {
 public:
  /// What returns from the robot itself is no measurement, nor is what lies behind that.
  explicit Bearings(std::vector<OwnBox> self) : self_(std::move(self)) {}
  Bearings() = default;

  /// Another of its scans.
  void note(const ScanView& scan, const Outlook& outlook);

  /// Where it has never measured anything, over so much that it matters [rad] in its own frame.
  struct Gap {
    double middle, half_angle;
  };
  const std::vector<Gap>& gaps() const { return gaps_; }

  /// Whether a bearing [rad], in its own frame, lies in one of them.
  bool is_blind_at(double bearing) const;

 private:
  static constexpr std::size_t bins = 720;
  static constexpr double full_turn = 6.283185307179586, bin = full_turn / static_cast<double>(bins);  ///< [rad]
  static std::size_t bin_of(double bearing);
  void find_gaps();

  std::vector<OwnBox> self_;
  std::array<bool, bins> measured_{};
  std::vector<Gap> gaps_;
};

}  // namespace safety_control_cloud
