// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "../input/depth.hpp"
#include "../text/problems.hpp"
#include "corridor.hpp"

namespace safety_control_cloud {

/// How the corridor is searched: both give the same Sight.
enum class Method : std::uint8_t {
  OnePass,  ///< look(): one pass over the bytes
  Pcl,      ///< passthrough(): the tutorial's PCL filters, the specification
};

const char* name_of(MinusInf meaning);  ///< "too_close" or "nothing"
std::optional<MinusInf> minus_inf_named(const std::string& name);

const char* name_of(Method method);  ///< "one_pass" or "pcl"
std::optional<Method> method_named(const std::string& name);

/// The corridor in a target frame (x forward, y left, z up), as distances and heights from its origin.
struct FrameCorridor {
  double left = 0.30;    ///< [m] to the left of the frame's x axis
  double right = 0.30;   ///< [m] to the right of it
  double bottom = 0.05;  ///< [m] height above the frame's origin
  double top = 0.55;     ///< [m] height above the frame's origin
};

/// Where to look, and how.
struct LookSettings {
  Corridor corridor;
  std::string target_frame;  ///< the corridor lies in this frame; empty: in the camera's optical frame
  FrameCorridor frame_corridor;
  MinusInf depth_minus_inf = MinusInf::TooClose;  ///< what -Inf in a depth image says; in a cloud it is too close
  bool inf_is_free = false;                       ///< +Inf in a scan has seen that nothing is there, up to range_max
  bool zero_is_inf = false;                       ///< 0 in a scan says what +Inf says
  Method method = Method::OnePass;
};

/// Calls visit(name, value) for every parameter; `look` may be const.
template <class LookSettingsOrConst, class Visit>
void for_each_look_parameter(LookSettingsOrConst& look, Visit& visit) {
  visit("x_min", look.corridor.x_min);
  visit("x_max", look.corridor.x_max);
  visit("y_min", look.corridor.y_min);
  visit("y_max", look.corridor.y_max);
  visit("target_frame", look.target_frame);
  visit("left", look.frame_corridor.left);
  visit("right", look.frame_corridor.right);
  visit("bottom", look.frame_corridor.bottom);
  visit("top", look.frame_corridor.top);
  visit("range_min", look.corridor.range_min);
  visit("min_points", look.corridor.min_points);
  visit("depth_minus_inf", look.depth_minus_inf);
  visit("inf_is_free", look.inf_is_free);
  visit("zero_is_inf", look.zero_is_inf);
  visit("method", look.method);
}

/// The limits to look within, in the axes x right, y down, z forward of whichever frame they lie in.
Corridor corridor_of(const LookSettings& look);

void check(const LookSettings& look, Problems& problems);

}  // namespace safety_control_cloud
