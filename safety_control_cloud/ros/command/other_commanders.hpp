// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "../../core/doubt/doubt.hpp"

namespace safety_control_cloud {

/// Knows who else commands the robot: by what was heard of them, and by who could be heard any moment. May be asked
/// from any thread; times are steady [s].
class OtherCommanders {
 public:
  explicit OtherCommanders(std::string topic) : topic_(std::move(topic)) {}

  /// A command of somebody else has come.
  void heard(const std::string& name, double now);

  /// These are connected now, whether they have said anything or not.
  void connected(std::vector<std::string> names);

  /// A doubt as long as there is one. Who is not connected, as another nodelet of one's own process, is at work until
  /// it has been silent for two of its own periods, and for 1 s at least.
  std::optional<Doubt> doubt(double now);

 private:
  struct Sent {
    double last = 0.0;    ///< [s] steady
    double period = 0.0;  ///< [s] between its latest two commands
  };

  const std::string topic_;
  std::mutex mutex_;
  std::map<std::string, Sent> sent_;
  std::vector<std::string> connected_;
};

}  // namespace safety_control_cloud
