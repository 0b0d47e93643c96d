// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "../core/settings.hpp"

namespace safety_control_cloud {

/// The parameters are unfit to drive with. what() lists every problem, a line each.
class BadParameters : public std::runtime_error {
 public:
  explicit BadParameters(const std::vector<std::string>& problems);
};

/// Reads the private parameters over the defaults of Settings{}.
/// Throws BadParameters for a wrong type, an unfit value or a name that no parameter has.
Settings load_settings(const ros::NodeHandle& private_handle);

/// A sentence for each argument of the command line, say danger_distance:=0.7, that roscpp takes for a topic's new name
/// and somebody meant for a parameter.
std::vector<std::string> parameters_without_underscore(int argc, const char* const* argv);

}  // namespace safety_control_cloud
