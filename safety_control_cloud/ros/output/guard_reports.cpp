// SPDX-License-Identifier: BSD-3-Clause
#include "guard_reports.hpp"

#include <boost/make_shared.hpp>
#include <cmath>

#include "../../core/text/words.hpp"
#include "../time/moments.hpp"
#include "advice.hpp"
#include "guard_markers.hpp"
#include "guard_messages.hpp"
#include "periods.hpp"

namespace safety_control_cloud {
namespace {

const char* what_is_given(const Guarded& answer) {
  if (answer.factor >= 1.0) return "Passes";
  return answer.factor > 0.0 ? "Scaled" : "Stands";
}

/// Whether two commands want the same way, within ten degrees; a radian counts as a metre.
bool point_alike(const Command& a, const Command& b) {
  const Twist2 one = in_plane(a), other = in_plane(b);
  const auto product = [](const Twist2& p, const Twist2& q) { return p.vx * q.vx + p.vy * q.vy + p.w * q.w; };
  return product(one, other) >= 0.985 * std::sqrt(product(one, one) * product(other, other));
}

}  // namespace

GuardReports::GuardReports(ros::NodeHandle& private_handle, Log& log)
    : log_(log),
      node_(private_handle.getNamespace()),
      state_(private_handle.advertise<SafetyState>("state", 1, true)),
      blocked_(private_handle.advertise<Blocked>("blocked", 1, true)),
      markers_(private_handle.advertise<visualization_msgs::MarkerArray>("markers", 1, true)) {}

void GuardReports::say(const Guarded& answer, const Settings& settings, const std_msgs::Header& cloud) {
  const auto state = boost::make_shared<SafetyState>(to_state(answer, settings, cloud));
  state->resets = resets_;
  state_.publish(state);  // as a pointer, it wakes roscpp's thread only if somebody listens
  say_blocked(answer, settings);
  say_markers(answer, settings);
  say_override(answer);
  say_in_log(answer, cloud);
}

void GuardReports::say_blocked(const Guarded& answer, const Settings& settings) {
  const bool same = answer.stuck == blocked_by_.stuck &&
                    (!answer.stuck || (answer.cause == blocked_by_.cause && answer.open == blocked_by_.open &&
                                       point_alike(answer.wanted, blocked_by_.wanted)));
  if (said_blocked_ && same) return;
  const auto blocked = boost::make_shared<Blocked>(to_blocked(answer, settings));
  blocked->header.stamp = ros::Time::now();
  blocked_.publish(blocked);
  blocked_by_ = answer;
  said_blocked_ = true;
}

void GuardReports::say_markers(const Guarded& answer, const Settings& settings) {
  if (markers_.getNumSubscribers() == 0 || seconds_since(last_markers_) < markers_period) return;
  markers_.publish(to_markers(answer, settings));
  last_markers_ = ros::SteadyTime::now();
}

void GuardReports::say_override(const Guarded& answer) {
  const bool overrides = answer.override_left > 0.0;
  if (overridden_ && !overrides) log_.warn("~override has ended");
  overridden_ = overrides;
}

void GuardReports::say_in_log(const Guarded& answer, const std_msgs::Header& cloud) {
  const bool changed = what_is_given(answer) != what_is_given(logged_) || answer.cause != logged_.cause;
  const bool matters = answer.override_left > 0.0 || (answer.factor < 1.0 && answer.cause != Cause::NoCommand);
  const bool again = matters && seconds_since(last_log_) >= log_period;
  if (!changed && !again) return;
  const std::string line = words(what_is_given(answer), ": ", name_of(answer.cause), ", ", answer.reason,
                                 way_out(answer.hint, answer.cause, cloud, node_));
  const bool is_usual =
      answer.override_left == 0.0 && (answer.cause == Cause::Seen || answer.cause == Cause::NoCommand);
  is_usual ? log_.info(line) : log_.warn(line);
  logged_ = answer;
  last_log_ = ros::SteadyTime::now();
}

}  // namespace safety_control_cloud
