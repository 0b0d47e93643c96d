// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "exchange.hpp"
#include "scenes.hpp"

namespace safety_control_cloud {

/// What a camera of the benchmark shows.
struct Plan {
  CameraPicture picture;
  double rate;                   ///< [Hz] at most: the next cloud waits for the answer to the last
  int warm_up, clouds;           ///< those before the measured ones, and those
  std::vector<pid_t> processes;  ///< whose CPU time is measured
};

/// Shows the source's clouds, which it sends by the publisher, to a node, and prints one line of JSON for exchange.py.
void measure(const Plan& plan, const ros::Publisher& clouds, const CloudSource& source);

/// A camera's main(): runs the plan of its command line, WIDTH HEIGHT RATE WARM_UP CLOUDS [PID...], in a ROS node of
/// this name. Without a PID its own process is measured. Returns the exit code.
int run_camera(int argc, char** argv, const std::string& node, const std::function<void(const Plan&)>& run);

}  // namespace safety_control_cloud
