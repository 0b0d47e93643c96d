// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include "../text/choice.hpp"

namespace safety_control_cloud {
namespace {

bool same_limits(const FrameCorridor& a, const FrameCorridor& b) {
  return a.left == b.left && a.right == b.right && a.bottom == b.bottom && a.top == b.top;
}

/// The limits that do not apply must stand at their defaults: whoever set them meant something else than will happen.
void check_axes(const LookSettings& look, Problems& problems) {
  problems.require_frame("target_frame", look.target_frame);
  if (look.target_frame.empty()) {
    problems.require(same_limits(look.frame_corridor, FrameCorridor{}),
                     "left, right, bottom and top need a target_frame; without one the corridor is x_min, x_max, y_min "
                     "and y_max in the camera's optical frame");
  } else {
    problems.require(same_limits(look.corridor, Corridor{}),
                     "x_min, x_max, y_min and y_max lie in the camera's optical frame; with target_frame the corridor "
                     "is left, right, bottom and top");
  }
}

}  // namespace

const char* name_of(MinusInf meaning) { return meaning == MinusInf::TooClose ? "too_close" : "nothing"; }

std::optional<MinusInf> minus_inf_named(const std::string& name) {
  return choice_named(name, {MinusInf::TooClose, MinusInf::Nothing});
}

const char* name_of(Method method) { return method == Method::Pcl ? "pcl" : "one_pass"; }

std::optional<Method> method_named(const std::string& name) {
  return choice_named(name, {Method::OnePass, Method::Pcl});
}

Corridor corridor_of(const LookSettings& look) {
  Corridor corridor = look.corridor;
  if (look.target_frame.empty()) return corridor;
  corridor.x_min = static_cast<float>(-look.frame_corridor.left);
  corridor.x_max = static_cast<float>(look.frame_corridor.right);
  corridor.y_min = static_cast<float>(-look.frame_corridor.top);
  corridor.y_max = static_cast<float>(-look.frame_corridor.bottom);
  return corridor;
}

void check(const LookSettings& look, Problems& problems) {
  const Corridor& corridor = look.corridor;
  const FrameCorridor& in_frame = look.frame_corridor;
  problems.require(corridor.x_min < corridor.x_max, "x_min must be less than x_max");
  problems.require(corridor.y_min < corridor.y_max, "y_min must be less than y_max");
  problems.require(in_frame.left > -in_frame.right, "left and right must leave a corridor between them");
  problems.require(in_frame.bottom < in_frame.top, "bottom must be less than top");
  problems.require(corridor.range_min >= 0.0f, "range_min must not be negative");
  problems.require(corridor.min_points >= 1, "min_points must be at least 1");
  check_axes(look, problems);
}

}  // namespace safety_control_cloud
