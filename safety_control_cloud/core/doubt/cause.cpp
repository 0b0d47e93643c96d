// SPDX-License-Identifier: BSD-3-Clause
#include "cause.hpp"

namespace safety_control_cloud {

const char* name_of(Cause cause) {
  switch (cause) {
    case Cause::Seen:
      return "SEEN";
    case Cause::NoCloud:
      return "NO_CLOUD";
    case Cause::Silent:
      return "SILENT";
    case Cause::Unreadable:
      return "UNREADABLE";
    case Cause::Blind:
      return "BLIND";
    case Cause::Stale:
      return "STALE";
    case Cause::Future:
      return "FUTURE";
    case Cause::ClockJump:
      return "CLOCK_JUMP";
    case Cause::NearLoss:
      return "NEAR_LOSS";
    case Cause::Frozen:
      return "FROZEN";
    case Cause::NoTransform:
      return "NO_TRANSFORM";
    case Cause::TwoSources:
      return "TWO_SOURCES";
    case Cause::LowObstacle:
      return "LOW_OBSTACLE";
    case Cause::TwoCommanders:
      return "TWO_COMMANDERS";
    case Cause::WrongView:
      return "WRONG_VIEW";
    case Cause::NoTime:
      return "NO_TIME";
    case Cause::NoCommand:
      return "NO_COMMAND";
    case Cause::BadCommand:
      return "BAD_COMMAND";
    case Cause::NoOdometry:
      return "NO_ODOMETRY";
    case Cause::Bumper:
      return "BUMPER";
    case Cause::Cliff:
      return "CLIFF";
  }
  return "UNKNOWN";
}

}  // namespace safety_control_cloud
