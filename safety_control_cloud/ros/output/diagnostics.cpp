// SPDX-License-Identifier: BSD-3-Clause
#include "diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../../core/text/words.hpp"
#include "../time/diagnostic_period.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::size_t kept_durations = 300;  // ten seconds of a 30 Hz camera
constexpr std::uint32_t largest_gap = 1000;  // a greater one is another publisher, not dropped clouds
constexpr double milliseconds = 1000.0;
constexpr double usual_period = 1.0;  // [s]

std::uint8_t level_of(const Decision& decision) {
  using diagnostic_msgs::DiagnosticStatus;
  if (decision.cause == Cause::NoCommand) return DiagnosticStatus::OK;  // nobody wants to drive
  if (decision.cause != Cause::Seen) return DiagnosticStatus::ERROR;
  return decision.zone == Zone::Safe ? DiagnosticStatus::OK : DiagnosticStatus::WARN;
}

double share_of_returns(const Sight& sight) {
  return sight.total == 0 ? 0.0 : static_cast<double>(sight.returns) / static_cast<double>(sight.total);
}

}  // namespace

void Durations::add(double seconds) {
  latest_.push_back(seconds);
  if (latest_.size() > kept_durations) latest_.pop_front();
}

double Durations::quantile(double share) const {
  if (latest_.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sorted(latest_.begin(), latest_.end());
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
  return sorted[static_cast<std::size_t>(rank)];
}

void Diagnostics::Fed::note(const std_msgs::Header& cloud) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (last_arrival) periods.add((now - *last_arrival).toSec());
  last_arrival = now;
  const std::uint32_t gap = last_seq ? cloud.seq - *last_seq - 1 : 0;
  if (gap <= largest_gap) dropped += gap;
  last_seq = cloud.seq;
}

void Diagnostics::Fed::add_to(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const std::string whose = name.empty() ? "" : name + ": ";
  status.add(whose + "input rate [Hz]", 1.0 / periods.quantile(0.5));
  status.add(whose + "age of the last cloud [s]",
             last_arrival ? (ros::SteadyTime::now() - *last_arrival).toSec() : std::nan(""));
  status.add(whose + "clouds dropped", dropped);
}

Diagnostics::Diagnostics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, Say warn,
                         const std::vector<std::string>& sensors)
    : updater_(handle, private_handle, private_handle.getNamespace()),
      warn_(std::move(warn)),
      updated_(ros::SteadyTime::now()) {
  for (const std::string& name : sensors) fed_.push_back({name});
  updater_.setHardwareID("depth camera");
  updater_.add("safety", this, &Diagnostics::report);
}

void Diagnostics::on_cloud(const Decision& decision, const std_msgs::Header& cloud, double decision_time,
                           double latency, std::size_t sensor) {
  fed_[sensor].note(cloud);
  decision_times_.add(decision_time);
  latencies_.add(latency);
  decision_ = decision;
  update();
}

void Diagnostics::on_quiet(const Decision& decision) {
  decision_ = decision;
  update();
}

/// By a steady clock: where ROS time stands still or goes back, it is needed the most, and the updater would wait. That
/// reads ~diagnostic_period anew each time, which may be anything by now, and throws what ros::Duration cannot hold.
void Diagnostics::update() {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const double period = updater_.getPeriod();
  if ((now - updated_).toSec() < (is_diagnostic_period(period) ? period : usual_period)) return;
  updated_ = now;
  try {
    updater_.force_update();
    is_period_bad_ = false;
  } catch (const std::runtime_error& problem) {
    if (!std::exchange(is_period_bad_, true)) warn_(words("~diagnostic_period is no time: ", problem.what()));
  }
}

void Diagnostics::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  status.summary(level_of(decision_), std::string(name_of(decision_.zone)) + ": " + decision_.reason);
  status.add("zone", name_of(decision_.zone));
  status.add("cause", name_of(decision_.cause));
  status.add("speed [m/s]", decision_.speed);
  status.add("nearest [m]", decision_.nearest ? decision_.nearest->distance() : std::nan(""));
  if (decision_.stuck_since) {
    status.add("stuck for [s]", ros::SteadyTime::now().toSec() - *decision_.stuck_since);
    if (!decision_.hint.empty()) status.add("freed by", decision_.hint);
  }
  if (override_left_ > 0.0) status.add("override for [s]", override_left_);
  status.add("share of returns", share_of_returns(decision_.sight));
  for (const Fed& fed : fed_) fed.add_to(status);
  status.add("decision time p50 [ms]", decision_times_.quantile(0.5) * milliseconds);
  status.add("decision time p99 [ms]", decision_times_.quantile(0.99) * milliseconds);
  status.add("publish to decision p50 [ms]", latencies_.quantile(0.5) * milliseconds);
  status.add("publish to decision p99 [ms]", latencies_.quantile(0.99) * milliseconds);
}

}  // namespace safety_control_cloud
