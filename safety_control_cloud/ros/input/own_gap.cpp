// SPDX-License-Identifier: BSD-3-Clause
#include "own_gap.hpp"

#include "../../core/text/words.hpp"

namespace safety_control_cloud {

void OwnGap::beat(double steady, double ros, double limit) {
  if (last_ && steady - *last_ > limit) {
    gap_ = steady - *last_;
    went_on_ = steady;
    went_on_ros_ = ros;
  }
  last_ = steady;
}

std::optional<Doubt> OwnGap::doubt_about(double stamp, double steady, double limit) const {
  if (!went_on_ || steady - *went_on_ > limit || stamp >= went_on_ros_) return std::nullopt;
  return Doubt{Cause::Stale,
               "the cloud is from before this node went on, which had stood still for " + measured(gap_, "s")};
}

}  // namespace safety_control_cloud
