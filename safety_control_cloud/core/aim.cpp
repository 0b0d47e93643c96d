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

}  // namespace safety_control_cloud
