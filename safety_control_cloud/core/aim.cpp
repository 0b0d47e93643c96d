// SPDX-License-Identifier: BSD-3-Clause
#include "aim.hpp"

#include <cmath>

#include "look/field_of_view.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double fair_share = 0.25;  ///< of the corridor; a camera that looks 45 degrees aside sees less

}  // namespace

std::optional<Doubt> doubt_about_aim(const View& view, const Outlook& outlook, const ZoneLimits& limits) {
  const auto field = field_of(view, outlook.placement ? Sense::Either : Sense::Optical);
  if (const auto* other = std::get_if<NotOptical>(&field)) return Doubt{Cause::WrongView, other->reason};
  if (!outlook.placement) return std::nullopt;
  const double share = share_in_view(outlook, std::get<FieldOfView>(field), limits.danger, limits.warning);
  if (share >= fair_share) return std::nullopt;
  return Doubt{Cause::WrongView,
               words("of the corridor between danger_distance and warning_distance the camera, as it is"
                     " placed, sees ",
                     std::lround(100.0 * share), " %")};
}

std::optional<Doubt> doubt_about_plane(const ScanView& scan, const Outlook& outlook, const ZoneLimits& limits) {
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double bearing = scan.first + share * (scan.last - scan.first);
    const Point there = outlook.placed(static_cast<float>(limits.danger * std::cos(bearing)),
                                       static_cast<float>(limits.danger * std::sin(bearing)), 0.0f);
    if (there.y >= outlook.corridor.y_min && there.y <= outlook.corridor.y_max) continue;
    return Doubt{Cause::WrongView,
                 words("the scan's plane, as it is placed, lies at a height of ", measured(-double{there.y}, "m"),
                       " at ", measured(limits.danger, "m"), " distance, not between bottom and top")};
  }
  return std::nullopt;
}

}  // namespace safety_control_cloud
