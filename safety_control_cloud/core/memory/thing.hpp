// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "../input/cloud.hpp"
#include "camera_pose.hpp"

namespace safety_control_cloud {

/// By so much a thing grows in the picture when a robot that brakes comes nearer than it can see.
constexpr double growth = 0.25;

/// What juts out over what is seen below it by this much hangs before that; by less it may lean [m].
constexpr float clear_overhang = 0.02f;

constexpr std::size_t most_lost = 240;  ///< spots of one thing

/// A pixel in which a thing was seen, and what the picture is asked about there.
struct Spot {
  std::uint16_t row = 0, column = 0;
  bool row_shown = true, column_shown = true;  ///< by the picture as it is now; if not, it says nothing there
  Point point;                                 ///< in the cloud's frame [m]
  float share = 0.0f;                          ///< of the thing's size that it stands for [m2]
  std::uint8_t company = 0;                    ///< how many of the 3 x 3 pixels around it returned then
  std::uint8_t seen_past = 0;                  ///< so many successive clouds show something behind it
  std::uint8_t lost_for = 0;                   ///< so many clouds have been asked about it, or more than enough
  float overhang = 0.0f;                       ///< so much the thing recedes at once below it, or more [m]
  bool stands = false;                         ///< what is seen in this column reached down to the near floor
  bool foot_unseen = false;                    ///< nothing farther away returned in this column below what is seen
  bool hung_before = false;            ///< until what is below it was hidden: it does not go with the rest of a thing
  bool went_alone = false;             ///< the rest of the thing was still seen then: it does not go with that
  bool only_hides = false;             ///< what is behind it, and was never seen: it is there, or nearer on that ray
  CameraPose camera{};                 ///< then
  float came_nearer = 0.0f;            ///< [m] at most, by the first picture that did not show it
  float turning = 0.0f;                ///< [rad] by which its picture turned from the one before
  std::uint32_t picture = 0;           ///< the number of the one that showed it; 0: none did
  std::optional<double> lost_since{};  ///< [s] steady

  bool is_shown() const { return row_shown && column_shown; }
  /// In the corridor's axes [m].
  Point place() const { return camera(point.x, point.y, point.z); }
};

/// [m2] that they stand for.
inline double size_of(const std::vector<Spot>& spots) {
  return std::accumulate(spots.begin(), spots.end(), 0.0,
                         [](double sum, const Spot& spot) { return sum + double{spot.share}; });
}

/// The lowest pixel of a thing in a column of the picture.
struct Foot {
  std::uint16_t row = 0, column = 0;
  float ahead = 0.0f;  ///< [m] of the camera
};

/// Something connected that is seen in one cloud, in the corridor.
struct Thing {
  std::vector<Spot> spots;
  std::vector<Foot> feet;  ///< from left to right
  double size = 0.0;       ///< [m2] as it faces the camera
  std::size_t pixels = 0;  ///< that it takes
  float nearest = 0.0f;    ///< [m] ahead of the camera
  bool stands = false;     ///< on the near floor, in most of its columns
  bool hangs = false;      ///< in most of its columns something farther away is seen below it
  bool is_slight = false;  ///< few pixels of many that a picture has: they may be false
  bool is_edge = false;    ///< no more of it is seen than of something too near, and nowhere that it hangs
  bool at_border = false;  ///< of the picture or of the corridor: part of it may be out of sight
};

}  // namespace safety_control_cloud
