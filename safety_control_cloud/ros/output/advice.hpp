// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>

#include <string>

#include "../../core/doubt/cause.hpp"

namespace safety_control_cloud {

/// What a person can do about a cause, in brackets; empty where that is not plain. `age` [s] is that of the latest
/// cloud's stamp, `node` the node's resolved name.
std::string advice_for(Cause cause, double age, const std::string& node);

/// As a line of the log goes on that says why the robot stands: by itself it drives again when `hint` holds, if that is
/// not empty; and the advice, by the header of the latest cloud.
std::string way_out(const std::string& hint, Cause cause, const std_msgs::Header& cloud, const std::string& node);

}  // namespace safety_control_cloud
