// SPDX-License-Identifier: BSD-3-Clause
#include "reports.hpp"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <optional>

#include "../../core/text/words.hpp"
#include "../time/moments.hpp"
#include "advice.hpp"
#include "markers.hpp"
#include "messages.hpp"
#include "periods.hpp"

namespace safety_control_cloud {
namespace {

/// The same moment by ROS time, which may be younger than that.
ros::Time ros_time_of(const std::optional<double>& steady) {
  if (!steady) return {};
  const double then = ros::Time::now().toSec() - (ros::SteadyTime::now().toSec() - *steady);
  return ros::Time(std::max(then, 0.0));
}

}  // namespace

Reports::Reports(ros::NodeHandle& private_handle, Log& log)
    : log_(log),
      node_(private_handle.getNamespace()),
      state_(private_handle.advertise<SafetyState>("state", 1, true)),
      markers_(private_handle.advertise<visualization_msgs::MarkerArray>("markers", 1, true)) {}

void Reports::say(const Decision& decision, const Settings& settings, const std_msgs::Header& cloud) {
  const auto state = boost::make_shared<SafetyState>(to_state(decision, settings, cloud));
  state->resets = resets_;
  state->stuck_since = ros_time_of(decision.stuck_since);
  state_.publish(state);  // as a pointer, it wakes roscpp's thread only if somebody listens
  say_markers(decision, settings, cloud);
  say_in_log(decision, cloud);
}

void Reports::say_markers(const Decision& decision, const Settings& settings, const std_msgs::Header& cloud) {
  const bool has_frame =
      !settings.target_frame.empty() || !cloud.frame_id.empty();  // before the first cloud maybe none
  if (!has_frame || markers_.getNumSubscribers() == 0 || seconds_since(last_markers_) < markers_period) return;
  markers_.publish(to_markers(decision, settings, cloud));
  last_markers_ = ros::SteadyTime::now();
}

void Reports::say_in_log(const Decision& decision, const std_msgs::Header& cloud) {
  const bool changed = decision.zone != logged_.zone || decision.cause != logged_.cause;
  if (!changed && seconds_since(last_log_) < log_period) return;
  const auto zone = words(name_of(decision.zone), " zone");
  if (decision.cause == Cause::Seen) {
    log_.info(zone);
  } else {
    log_.warn(words(zone, ": ", name_of(decision.cause), ", ", decision.reason,
                    way_out(decision.hint, decision.cause, cloud, node_)));
  }
  logged_ = decision;
  last_log_ = ros::SteadyTime::now();
}

}  // namespace safety_control_cloud
