// SPDX-License-Identifier: BSD-3-Clause
#include "directions.hpp"

#include <algorithm>

#include "command.hpp"

namespace safety_control_cloud {

std::uint8_t open_directions(const Guard& guard, const GuardSettings& settings, const UnderWay& under_way,
                             const std::vector<Known>& known) {
  const Outline& outline = guard.outline();
  std::uint8_t open = 0;
  for (const Direction& direction : directions) {
    const Twist2 wanted = at_speed(outline, direction, std::max(settings.escape_speed, settings.min_speed));
    const Twist2 given = limited(wanted, guard.allowed(wanted, under_way, known).factor);
    if (!stands(given) && fastest_point(outline, given) >= settings.min_speed) open |= direction.bit;
  }
  return open;
}

}  // namespace safety_control_cloud
