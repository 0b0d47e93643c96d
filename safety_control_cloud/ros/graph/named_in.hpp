// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

namespace safety_control_cloud {

/// A name of a handle's namespace, which roscpp is to remap. Of the root it is absolute: roscpp takes that for the
/// process's own namespace, which is another one if a camera's driver starts its nodelet manager in one of its own, and
/// finds none of the nodelet's remappings there.
inline std::string named_in(const ros::NodeHandle& handle, const std::string& name) {
  const bool is_relative = !name.empty() && name[0] != '/' && name[0] != '~';
  return is_relative && handle.getUnresolvedNamespace() == "/" ? "/" + name : name;
}

}  // namespace safety_control_cloud
