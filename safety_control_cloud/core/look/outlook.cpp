// SPDX-License-Identifier: BSD-3-Clause
#include "outlook.hpp"

#include "settings.hpp"

namespace safety_control_cloud {
namespace {

/// [byte] Where a scan's points have their z.
std::size_t z_of(const ScanView& scan, const LookSettings& look) {
  if (look.inf_is_free) return look.zero_is_inf ? scan.z_if_both : scan.z_if_inf_is_free;
  return look.zero_is_inf ? scan.z_if_zero_is_inf : scan.points.offset[2];
}

}  // namespace

std::variant<Outlook, NoTransform> outlook_of(const LookSettings& look, const Placing& placing) {
  if (const auto* missing = std::get_if<NoTransform>(&placing)) return *missing;
  const auto* placement = std::get_if<Placement>(&placing);
  if (!placement && !look.target_frame.empty()) {
    return NoTransform{"the corridor lies in " + look.target_frame + ", and nobody says where the camera is in it"};
  }
  if (placement && look.target_frame.empty()) {
    return NoTransform{"the camera has a place in a frame, and the corridor lies in the camera's own: no target_frame"};
  }
  return placement ? Outlook(corridor_of(look), *placement) : Outlook(corridor_of(look));
}

Point Outlook::seen_from_camera(const Point& placed) const { return placement ? placement->seen(placed) : placed; }

View view_in(const Reading& reading, const LookSettings& look) {
  View view = view_in(reading);
  if (auto* image = std::get_if<DepthView>(&view)) image->minus_inf = look.depth_minus_inf;
  if (const auto* scan = std::get_if<ScanView>(&reading)) std::get<CloudView>(view).offset[2] = z_of(*scan, look);
  return view;
}

}  // namespace safety_control_cloud
