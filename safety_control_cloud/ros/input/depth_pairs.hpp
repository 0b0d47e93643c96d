// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_event.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "depth_image.hpp"

namespace safety_control_cloud {

using CameraEvent = ros::MessageEvent<const sensor_msgs::CameraInfo>;

/// Brings each depth image together with the CameraInfo of its stamp, whichever comes first. The latest few of both
/// wait for the other one; what is older than a pair waits no longer. Memory that keeps an image is used again.
class DepthPairs {
 public:
  using OnPair = std::function<void(const DepthImage& image, const CameraEvent& camera)>;

  static constexpr std::size_t waiting = 5;  ///< of each kind at most

  explicit DepthPairs(OnPair on_pair);

  void add(const DepthImage& image);
  void add(const CameraEvent& camera);

 private:
  using Memory = std::vector<std::uint8_t>;

  struct Kept {
    DepthImage image;
    Memory copy;  ///< of its bytes, if they were only borrowed
  };

  void keep(const DepthImage& image);
  void forget_until(const ros::Time& stamp);

  OnPair on_pair_;
  std::deque<CameraEvent> cameras_;  ///< in the order in which they came, as not every clock runs forward
  std::deque<Kept> images_;          ///< the same
  Memory spare_;
};

}  // namespace safety_control_cloud
