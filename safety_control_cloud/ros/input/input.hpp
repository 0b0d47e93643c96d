// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace safety_control_cloud {

/// What somebody should know; returns at once.
using Warn = std::function<void(const std::string&)>;

/// Hands over what the camera sends, as readings, for as long as it lives.
class Input {
 public:
  virtual ~Input() = default;
};

}  // namespace safety_control_cloud
