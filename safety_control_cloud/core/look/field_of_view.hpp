// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>

#include "../input/view.hpp"
#include "outlook.hpp"

namespace safety_control_cloud {

/// What a picture spans, as x/z and y/z in the camera's frame. As it is made: 90 degrees each way, more than most depth
/// cameras see, for one of which nothing is known.
struct FieldOfView {
  double left = -1.0, right = 1.0, top = -1.0, bottom = 1.0;

  bool holds(const Point& point) const;
};

/// The points do not lie as those of a camera that looks along its z axis.
struct NotOptical {
  std::string reason;
};

/// Which way x/z may grow over the columns, and y/z over the rows.
enum class Sense {
  Optical,  ///< to the right and down: of any other nobody knows which way is up
  Either,   ///< mirrored or upside down too, where the camera's place says which way is up
};

/// What the camera's picture spans, by the rays of some of its pixels: in an optical cloud x/z depends on the column
/// alone and y/z on the row alone, evenly, whatever the depths, and z itself points into the picture. In any other
/// frame (x forward and z up, say) that is not so. A cloud that is not organised, or that returns too little to tell,
/// is believed.
std::variant<FieldOfView, NotOptical> field_of(const View& view, Sense sense);

/// The share of the corridor between two distances [m] that lies in the picture of a camera that is placed.
double share_in_view(const Outlook& outlook, const FieldOfView& field, double from, double to);

}  // namespace safety_control_cloud
