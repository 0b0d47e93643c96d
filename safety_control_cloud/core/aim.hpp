// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "doubt/doubt.hpp"
#include "input/scan.hpp"
#include "input/view.hpp"
#include "look/outlook.hpp"
#include "speed/settings.hpp"

namespace safety_control_cloud {

/// Whether the camera looks where the corridor is: its cloud must be an optical one, and of the corridor between the
/// two limits the picture must hold a fair share. The latter is asked of a camera that is placed; in its own frame the
/// corridor lies straight ahead.
std::optional<Doubt> doubt_about_aim(const View& view, const Outlook& outlook, const ZoneLimits& limits);

/// Whether a scan's plane lies, as far as to the nearer limit, between the corridor's bottom and top: what leaves it
/// there would call everything free.
std::optional<Doubt> doubt_about_plane(const ScanView& scan, const Outlook& outlook, const ZoneLimits& limits);

}  // namespace safety_control_cloud
