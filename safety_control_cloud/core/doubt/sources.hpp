// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

#include "doubt.hpp"

namespace safety_control_cloud {

/// Knows who sends clouds. What two cameras see is neither's view, and the memory would mix them.
class SourceWatch {
 public:
  /// A cloud of `source` has come at `now` [s, steady]: a doubt if another source is at work as well. One is, as long
  /// as it has not missed two of its own clouds, and at least for `timeout` [s]; so one that sends seldom does not let
  /// the robot go and stop in turn, and a camera that is started anew under another name is soon believed.
  std::optional<Doubt> note(const std::string& source, double now, double timeout);

 private:
  struct Sent {
    double last = 0.0;    ///< [s] steady
    double period = 0.0;  ///< [s] between its latest two clouds
  };

  std::map<std::string, Sent> sent_;
};

}  // namespace safety_control_cloud
