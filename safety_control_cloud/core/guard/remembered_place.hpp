// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "horizon.hpp"

namespace safety_control_cloud {

constexpr std::uint8_t believed = 2;  ///< looks that show a place, or what is behind it
constexpr double well_placed = 0.02;  ///< [m] odometry that drifted by no more has a place where it is
constexpr double well_known = 0.2;    ///< [m] what may be off by more explains nothing that is lost, nor grows younger

/// Some of the sensors, by their numbers.
class SomeSensors {
 public:
  void add(std::size_t sensor) { bits_ |= bit(sensor); }
  void remove(std::size_t sensor) { bits_ &= ~bit(sensor); }
  bool has(std::size_t sensor) const { return (bits_ & bit(sensor)) != 0; }
  friend SomeSensors operator|(SomeSensors a, SomeSensors b) {
    a.bits_ |= b.bits_;
    return a;
  }

 private:
  /// Of more than 64, some are as one.
  static std::uint64_t bit(std::size_t sensor) { return std::uint64_t{1} << (sensor % 64); }
  std::uint64_t bits_ = 0;
};

/// Where something returned that no sensor shows any more.
struct RememberedPlace {
  double x, y;                   ///< [m] in the resting frame, which may begin far away
  float z;                       ///< [m] above base_frame
  Heights stands;                ///< what it is a part of
  std::uint64_t look;            ///< the latest that showed it
  double first_seen, last_seen;  ///< [s] steady
  double off = 0.0;      ///< [m] by which it may have been displaced as it was seen, or before this frame rested
  double drifted = 0.0;  ///< [m] and by which the way since may be off, as seen from the robot
  std::uint8_t looks = 1, away = 0;
  bool is_recalled = false;  ///< another process kept it, and nobody shows it in this one
  bool is_too_near = false;  ///< nothing returns there in its sensor's latest look, which does not measure so near

  SomeSensors looked_past = {};  ///< since it was shown last, though it is shown by the latest look of who showed it
  SomeSensors do_not_see = {};   ///< as the latter, and it was shown again: glass to a camera, say

  /// Nothing returns there any more where a sensor could measure it.
  struct Absent {
    double since;        ///< [s] steady
    std::size_t sensor;  ///< that tells
  };
  std::optional<Absent> absent = std::nullopt;
};

}  // namespace safety_control_cloud
