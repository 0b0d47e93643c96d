// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../../core/doubt/doubt.hpp"
#include "keepsake.hpp"

namespace safety_control_cloud {

/// What the control remembers of near things, beyond the life of this process: recalled at its start, written down
/// while it runs, forgotten at ~reset.
class LostThings {
 public:
  struct Control {
    std::function<bool(const std::vector<std::string>&)> recall;  ///< false: not with all
    std::function<std::vector<std::string>()> remembered;
    std::function<void()> forget;
  };

  /// Of a control and the reports that count its resets.
  template <class AnyControl, class AnyReports>
  static Control of(AnyControl& control, AnyReports& reports) {
    return {[&control](const std::vector<std::string>& texts) { return control.recall(texts); },
            [&control] { return control.remembered(); },
            [&control, &reports] {
              control.forget_losses();
              reports.count_reset();
            }};
  }

  /// Recalls at once what another process remembered. `may_have_waited`: whether a wish that comes now may have done so
  /// while this process stood still.
  LostThings(ros::NodeHandle& private_handle, Control control, Keepsake::Say warn,
             std::function<bool()> may_have_waited);

  /// Writes down what is remembered, if `cause` is another than before or it was long ago.
  void keep(Cause cause);

  /// Nothing has been seen yet, and why. The reason says so where nobody knows what was near before, or where.
  Doubt nothing_seen(const std::string& why) const;

 private:
  std::string recall() const;
  std::string refusal() const;
  bool on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& answer);

  const Control control_;
  const Keepsake::Say warn_;
  const std::function<bool()> may_have_waited_;
  Keepsake keepsake_;
  std::string unknown_;  ///< why not all is known that was near before, until somebody has looked; empty: it is
  std::optional<Cause> cause_;
  ros::SteadyTime last_kept_, last_reset_;
  ros::ServiceServer reset_;
};

}  // namespace safety_control_cloud
