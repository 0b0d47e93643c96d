// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/types.h>

#include <boost/shared_ptr.hpp>
#include <map>
#include <sstream>
#include <string>

namespace safety_control_cloud {

/// Who sent a message, by the header of the connection that it came over: the name that the sender gives itself, which
/// another may give itself too, and the connection, which is one's own.
inline std::string source_of(const boost::shared_ptr<ros::M_string>& connection_header) {
  std::ostringstream source;
  source << (*connection_header)["callerid"] << " over " << connection_header.get();
  return source.str();
}

}  // namespace safety_control_cloud
