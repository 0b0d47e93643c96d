// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "../input/angle.hpp"
#include "../input/scan.hpp"
#include "../look/outlook.hpp"
#include "../path/obstacles.hpp"

namespace safety_control_cloud {

/// Where a range finder has measured anything lately, be it that nothing is there (+Inf, REP 117). A filter may take
/// beams away and leave the angles as they are, dirt may hide a part of the window, and behind a part of the robot
/// itself nobody looks: what a scan names is not what it shows.
class Bearings {
 public:
  /// What a range of 0 says.
  enum class Zero { Nothing, WhatInfSays };

  /// What returns from the robot itself is no measurement, nor is what lies behind that.
  explicit Bearings(std::vector<OwnBox> self, Zero zero = Zero::Nothing) : self_(std::move(self)), zero_(zero) {
    measured_.fill(never);
  }
  Bearings() : Bearings(std::vector<OwnBox>()) {}

  /// Another of its scans, which comes now [s].
  void note(const ScanView& scan, const Outlook& outlook, double now);

  /// Where it has measured nothing lately, over so much that it matters [rad] in its own frame.
  struct Gap {
    double middle, half_angle;
  };
  const std::vector<Gap>& gaps() const { return gaps_; }

  /// Whether it has measured lately at a bearing [rad] in its own frame, or there was no scan yet: between two that it
  /// did not measure at there may be no gap, and yet a post.
  bool measures_at(double bearing) const;

 private:
  static constexpr std::size_t bins = 720;
  static constexpr double bin = full_turn / static_cast<double>(bins);  ///< [rad]
  static constexpr double never = -std::numeric_limits<double>::infinity();
  static std::size_t bin_of(double bearing);
  /// By what the beam is, and whether it shows the robot itself.
  bool measures(const ScanView& scan, std::size_t beam, const Outlook& outlook) const;
  bool is_recent(double measured) const;
  void find_gaps();

  std::vector<OwnBox> self_;
  Zero zero_;
  std::array<double, bins> measured_;  ///< when for the last time [s]
  double latest_ = never;              ///< scan [s]
  std::vector<Gap> gaps_;
};

}  // namespace safety_control_cloud
