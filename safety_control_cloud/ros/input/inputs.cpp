// SPDX-License-Identifier: BSD-3-Clause
#include "inputs.hpp"

#include "cloud_input.hpp"
#include "depth_input.hpp"

namespace safety_control_cloud {

std::unique_ptr<Input> input_of(InputKind kind, ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                                Delivery delivery, const OnArrival& on_arrival, const Warn& warn) {
  if (kind == InputKind::Depth) {
    return std::make_unique<DepthInput>(handle, private_handle, "camera/depth/image_rect", delivery, on_arrival, warn);
  }
  return std::make_unique<CloudInput>(handle, "camera/depth/points", delivery, on_arrival);
}

}  // namespace safety_control_cloud
