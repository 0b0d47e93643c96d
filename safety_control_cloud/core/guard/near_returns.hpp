// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "../input/reading.hpp"
#include "../look/outlook.hpp"
#include "../path/obstacles.hpp"
#include "bearings.hpp"
#include "pose.hpp"

namespace safety_control_cloud {

/// One look of one sensor, placed in base_frame; borrowed for the length of a call.
struct Look {
  const Reading& reading;
  View view;
  Outlook outlook;
  double stamp;                        ///< [s] ROS time, of when it was taken
  double measures_from;                ///< [m] from here on, what is there returns
  double lasts = 0.0;                  ///< [s] from its stamp on in which its returns may have been taken
  std::size_t number = 0;              ///< of the sensor's looks
  const Bearings* bearings = nullptr;  ///< at which a range finder has measured lately, if that is known
};

/// Which returns are near.
struct Vicinity {
  double bottom = 0.0, top = 0.0;  ///< [m] heights, inclusive
  double distance = 0.0;           ///< [m] from base_frame's origin
  std::vector<OwnBox> self = {};   ///< of the robot itself

  /// What returns there, in base_frame; of NaN, false.
  bool holds(const Point2& place, double height) const {
    return holds(height) && dot(place, place) <= distance * distance && !is_own(self, place.x, place.y, height);
  }
  bool holds(double height) const { return height >= bottom && height <= top; }
};

/// Where something returned.
struct NearReturn {
  Point2 place;  ///< [m] in the frame that rests
  float height;  ///< [m] above base_frame
  double range;  ///< [m] from base_frame's origin then
};

/// Of a picture so large, every so many rows and columns are looked at.
std::size_t rows_apart(std::size_t height);
std::size_t columns_apart(std::size_t width);

/// Which rows those are, and between some of them, others in each look, one more: something thin may lie there.
std::vector<std::size_t> rows_looked_at(std::size_t height, std::size_t number_of_look);

/// The near returns of a look, or of some rows and every n-th column of a larger picture, with the robot at `pose` when
/// it began. It went on by `meanwhile`, so that each beam of a scan has a place of its own, in their order.
std::vector<NearReturn> near_returns(const Look& look, const Vicinity& vicinity, const Pose2& pose,
                                     const Pose2& meanwhile);

}  // namespace safety_control_cloud
