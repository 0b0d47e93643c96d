// SPDX-License-Identifier: BSD-3-Clause
#include "clock.hpp"

namespace safety_control_cloud {
namespace {

/// [s] by which ROS time may go back without a stop: clocks of computers are set right in such small steps.
constexpr double clock_slack = 0.1;

}  // namespace

std::optional<Doubt> ClockWatch::note(double now) {
  if (now == 0.0) return Doubt{Cause::NoTime, "ROS time is 0: use_sim_time is set and nobody publishes /clock"};
  const bool back = latest_ && now < *latest_ - clock_slack;
  latest_ = now;
  if (!back) return std::nullopt;
  return Doubt{Cause::ClockJump, "ROS time went backwards"};
}

}  // namespace safety_control_cloud
