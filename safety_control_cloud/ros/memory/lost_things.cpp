// SPDX-License-Identifier: BSD-3-Clause
#include "lost_things.hpp"

#include <utility>

#include "../time/moments.hpp"

namespace safety_control_cloud {
namespace {

constexpr double reset_period = 1.0;  ///< [s] a program that resets again and again is as good as no memory
constexpr double kept_period = 0.5;   ///< [s] after which what is near is written down though the cause is the same
constexpr char nothing_told[] = "the ROS master tells nothing of what was near before this start";
constexpr char not_placed[] =
    "the ROS master tells of something near or lost before this start that this node cannot place";

}  // namespace

LostThings::LostThings(ros::NodeHandle& private_handle, Control control, Keepsake::Say warn,
                       std::function<bool()> may_have_waited)
    : control_(std::move(control)),
      warn_(std::move(warn)),
      may_have_waited_(std::move(may_have_waited)),
      keepsake_(private_handle, warn_),
      unknown_(recall()),
      reset_(private_handle.advertiseService("reset", &LostThings::on_reset, this)) {
  if (!unknown_.empty()) warn_(unknown_);
}

std::string LostThings::recall() const {
  const auto& found = keepsake_.found();
  if (!found || found->empty()) return nothing_told;
  return control_.recall(*found) ? "" : not_placed;
}

void LostThings::keep(Cause cause) {
  if (cause == cause_ && seconds_since(last_kept_) < kept_period) return;
  keepsake_.keep(control_.remembered());
  cause_ = cause;
  last_kept_ = ros::SteadyTime::now();
}

Doubt LostThings::nothing_seen(const std::string& why) const {
  const std::string known = unknown_.empty() ? "" : ", and " + unknown_;
  return {Cause::NoCloud, "no cloud has arrived yet" + known + "; " + why};
}

/// Empty: none.
std::string LostThings::refusal() const {
  if (may_have_waited_()) return "refused: this node had stood still until just now; ask again";
  const bool is_soon = !last_reset_.isZero() && seconds_since(last_reset_) < reset_period;
  return is_soon ? "refused: near obstacles are forgotten at most once a second" : "";
}

bool LostThings::on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& answer) {
  const std::string refused = refusal();
  answer.success = refused.empty();
  answer.message = answer.success ? "near obstacles lost from sight are forgotten" : refused;
  warn_("~reset: " + answer.message);
  if (!answer.success) return true;
  last_reset_ = ros::SteadyTime::now();
  control_.forget();
  unknown_.clear();
  keepsake_.keep(control_.remembered());
  return true;
}

}  // namespace safety_control_cloud
