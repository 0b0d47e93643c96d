// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "../../core/doubt/cause.hpp"

namespace safety_control_cloud {

/// What a person can do about a cause, in brackets; empty where that is not plain. `age` [s] is that of the latest
/// cloud's stamp, `node` the node's resolved name.
std::string advice_for(Cause cause, double age, const std::string& node);

}  // namespace safety_control_cloud
