// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/chrono/duration.hpp>
#include <boost/thread/condition_variable.hpp>
#include <cstdint>

namespace safety_control_cloud {

/// Waits by a steady clock. With g++ 9, Ubuntu 20.04's, the standard's waits by the computer's: for an hour longer if
/// that is set back by an hour meanwhile.
using SteadyCondition = boost::condition_variable_any;

/// What it waits for at most.
inline boost::chrono::nanoseconds for_seconds(double seconds) {
  return boost::chrono::nanoseconds(static_cast<std::int64_t>(1e9 * seconds));
}

}  // namespace safety_control_cloud
