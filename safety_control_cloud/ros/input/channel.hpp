// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "awaited.hpp"
#include "inputs.hpp"

namespace safety_control_cloud {

/// One sensor's way into the node: what it sends, or why nothing has come.
class Channel {
 public:
  /// `own`: a topic on which the node answers with what a sensor might send too; none: it does not.
  Channel(const SensorSettings& sensor, const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
          const std::string& own = {});

  /// From now on what comes is handed over; `log` is told of the first, `warn` what somebody should know.
  void open(ros::NodeHandle& handle, const ros::NodeHandle& private_handle, Delivery delivery,
            const OnArrival& on_arrival, const Warn& log, const Warn& warn);

  bool has_sent() const { return has_sent_; }
  std::string why_nothing_came() const { return awaited_.why(); }

 private:
  const SensorSettings sensor_;
  Awaited awaited_;
  bool has_sent_ = false;
  std::unique_ptr<Input> input_;
};

}  // namespace safety_control_cloud
