// SPDX-License-Identifier: BSD-3-Clause
#include "own_gap.hpp"

#include <algorithm>

#include "../../core/text/words.hpp"

namespace safety_control_cloud {

namespace {

/// [s] in which a node that runs does something.
double limit(const Settings& settings) { return std::max(settings.source_timeout, 2.0 / settings.publish_rate); }

/// [s] in which a node that runs does something, or what is asked meanwhile holds anyway.
double limit_of_wishes(const Settings& settings) {
  if (settings.mode == Mode::Drive) return limit(settings);
  return std::max(settings.command_timeout,
                  2.0 * std::min(1.0 / settings.publish_rate, settings.stopping.sensor_period));
}

}  // namespace

std::optional<double> OwnGap::beat(const Instant& now, const Settings& settings) {
  const double since = now.steady - last_.value_or(now.steady);
  last_ = now.steady;
  const bool is_gap = since > limit(settings), is_gap_of_wishes = since > limit_of_wishes(settings);
  if (is_gap) gap_ = since, went_on_ = now;
  if (is_gap_of_wishes) hears_since_ = now.steady;
  return is_gap || is_gap_of_wishes ? std::optional(since) : std::nullopt;
}

std::optional<Doubt> OwnGap::doubt_about(double stamp, const Instant& now, const Settings& settings) const {
  if (settings.stamp_tolerance <= 0.0) return std::nullopt;
  if (!went_on_ || now.steady - went_on_->steady > limit(settings) || stamp >= went_on_->ros) return std::nullopt;
  return Doubt{Cause::Stale,
               "the cloud is from before this node went on, which had stood still for " + measured(gap_, "s")};
}

bool OwnGap::has_gone_on_within(double seconds, const Instant& now) const {
  return hears_since_ && now.steady - *hears_since_ < seconds;
}

}  // namespace safety_control_cloud
