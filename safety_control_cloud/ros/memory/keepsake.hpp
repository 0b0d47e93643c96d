// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "../time/steady_condition.hpp"

namespace safety_control_cloud {

/// Keeps what is remembered of near things where the node's own end does not reach it: on the parameter server, as
/// NODE_lost/things, beside the node's own namespace, which its launch file clears. A thread of its own speaks with the
/// master, which may take any time to answer.
class Keepsake {
 public:
  using Texts = std::vector<std::string>;
  using Say = std::function<void(const std::string&)>;

  /// `say` is told what somebody should know, from any thread.
  Keepsake(const ros::NodeHandle& private_handle, Say say);
  ~Keepsake();  ///< once the latest is written, if the master answers

  /// What was kept when this was made; nothing if the master knows nothing of it, as after its own start.
  const std::optional<Texts>& found() const { return found_; }

  /// Returns at once.
  void keep(Texts texts);

 private:
  void write();
  void look_whether_it_is_still_there();
  void write_anew(const std::string& why);

  const std::string name_;
  const Say say_;
  const std::optional<Texts> found_;
  std::mutex mutex_;
  SteadyCondition changed_;
  Texts wanted_;
  bool ending_ = false;
  // Of the thread alone.
  std::optional<Texts> written_;
  ros::SteadyTime looked_;  ///< whether it is still there
  bool is_there_ = false;   ///< as it was asked last; what is there is asked next
  std::thread thread_;
};

}  // namespace safety_control_cloud
