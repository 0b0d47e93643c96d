// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
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
  /// Another of its scans. What returns from the robot itself is none, nor what lies behind that.
  void note(const ScanView& scan, const Outlook& outlook, const std::vector<OwnBox>& self);

  /// Whether it has never measured anything there, nor around that, at a bearing [rad] in its own frame.
  bool is_blind_at(double bearing) const { return blind_[bin_of(bearing)]; }

  /// [rad] in its own frame, in [0, 2 pi).
  struct Gap {
    double middle, half_angle;
  };
  std::vector<Gap> gaps() const;

 private:
  static constexpr std::size_t bins = 720;
  static std::size_t bin_of(double bearing);
  void find_blind();

  std::array<bool, bins> measured_{};
  std::array<bool, bins> blind_{};  ///< of a gap that is wide enough to matter
};

}  // namespace safety_control_cloud
