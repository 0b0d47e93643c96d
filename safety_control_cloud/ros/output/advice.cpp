// SPDX-License-Identifier: BSD-3-Clause
#include "advice.hpp"

#include <cmath>

#include "../../core/text/words.hpp"
#include "../time/moments.hpp"

namespace safety_control_cloud {
namespace {

constexpr double recording_age = 60.0;  ///< [s] an older stamp is a recording's, not a slow camera's

}  // namespace

std::string advice_for(Cause cause, double age, const std::string& node) {
  switch (cause) {
    case Cause::NearLoss:
      return words(" (if you have looked and nothing is there: rosservice call ", node, "/reset)");
    case Cause::Stale:
    case Cause::Future:
      if (!(std::abs(age) > recording_age)) return "";
      return " (a recording: rosparam set use_sim_time true, rosbag play --clock, and start this node anew; if its "
             "stamps"
             " are not of the bag's time either, stamp_tolerance 0)";
    default:
      return "";
  }
}

std::string way_out(const std::string& hint, Cause cause, const std_msgs::Header& cloud, const std::string& node) {
  return words(hint.empty() ? "" : "; it drives again when ", hint, advice_for(cause, age_of(cloud), node));
}

}  // namespace safety_control_cloud
