// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>

#include <exception>
#include <functional>
#include <string>

#include "../../core/input/reading.hpp"

namespace safety_control_cloud {

/// What the camera sent, borrowed for the length of the call that hands it over.
struct Arrival {
  std_msgs::Header header;  ///< as far as it could be read
  Reading reading;
  std::string source;  ///< who sent it, as source_of() has it
};

/// What read() returns, or why it threw.
template <class Read>
Reading readable(Read read) {
  try {
    return read();
  } catch (const std::exception& problem) {
    return Unreadable{problem.what()};
  }
}

using OnArrival = std::function<void(const Arrival&)>;

/// How messages are taken.
enum class Delivery {
  InPlace,  ///< looked at in the buffer that they were received in, from another process: no message is ever built
  Shared,   ///< of this process, as a pointer to the publisher's message; those of other processes are copied
};

}  // namespace safety_control_cloud
