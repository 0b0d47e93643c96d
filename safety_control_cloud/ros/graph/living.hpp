// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace safety_control_cloud {

/// Whether the node at this address ("http://host:port/") may be alive: false only if its computer says that nobody is
/// there. One that is stopped lives. Takes half a second at most, and what it takes to find the host.
bool may_live(const std::string& address);

}  // namespace safety_control_cloud
