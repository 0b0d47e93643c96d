// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace safety_control_cloud {

/// A node, whatever its mode. Its end leaves the robot standing.
class Node {
 public:
  virtual ~Node() = default;  ///< the last command is zero, and has left

  /// The last command is zero, whatever arrives. From any thread.
  virtual void end() = 0;
};

}  // namespace safety_control_cloud
