// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "../input/runs.hpp"
#include "../look/sight.hpp"
#include "backdrop.hpp"
#include "camera_height.hpp"
#include "floor_strip.hpp"
#include "frame.hpp"
#include "hidden_floor.hpp"
#include "losses.hpp"
#include "low_obstacles.hpp"
#include "margins.hpp"
#include "near_things.hpp"
#include "optics.hpp"
#include "raster.hpp"
#include "settings.hpp"
#include "things_memory.hpp"
#include "written.hpp"

namespace safety_control_cloud {

/// Remembers what came near, because a depth camera is blind right before itself (an Xtion nearer than 0.4 m): an
/// obstacle that enters this zone looks like free space far away.
///
/// When a loss is believed and when it is forgiven, safe first and available second:
/// - A thing that was near and returns nothing now is still there; only what is seen behind it, in nearly all of its
///   extent, says that it has gone (see ThingsMemory). A single noisy pixel is no thing.
/// - A hall deeper than the camera's range returns nothing even when free, so somebody who walked past would stop the
///   robot for ever. But who stands on the floor also hides the near floor at the foot of the pixel column, or would if
///   he came nearer; when that floor is seen again, the column is free. A board that hangs never reached down to the
///   floor, so the floor says nothing of it.
/// - Near floor that goes blank over the width of a post is hidden by something too near to return.
/// - What ends below the corridor is lost from sight at the lower edge of the picture: see LowObstacles.
class NearLoss {
 public:
  explicit NearLoss(const NearLossLimits& limits) : limits_(limits) {}

  void limit(const NearLossLimits& limits) { limits_ = limits; }  ///< what came near is judged by them from now on
  void forget();                                                  ///< asked by ~reset; a clock that jumps does not

  /// What is lost or near, in some kilobytes of text, to outlive the process; empty if nothing is.
  /// Brought up to date four times a second, and at once when something is lost or found or nothing is near any more.
  const std::string& serialised() const { return written_.text(); }
  /// Goes on with what was written down, as who saw it would have. False, and nothing changes, if that makes no sense.
  bool restore(const std::string& text);

  /// The corridor is another one: what is remembered is judged by it from now on.
  void change_corridor() { low_.change_corridor(); }
  /// It is told in another frame.
  void change_axes() { are_axes_new_ = true; }
  /// It leads elsewhere, by so much to the left [rad].
  void turn_corridor(double angle);

  /// Whether look() is to tell the rows of this cloud apart: judge() asks for the nearest in each.
  Rows rows_for(const View& view) const;

  /// Whether the nearest that is seen begins where the sensor goes blind, so that a part of it may be nearer, unseen:
  /// of a wall that crosses the corridor, or a bench that runs along it, something farther away is always in view. Or
  /// it begins at the picture's lower border, as the top of a low box does once the camera looks over its front.
  bool cuts_off(const Sight& sight, const Outlook& outlook) const;

  /// What of the near obstacles is lost in this cloud, which look() has just seen. `now` [s], steady; `since` [s] the
  /// picture before: see PictureGap.
  std::optional<Loss> judge(const View& view, const Sight& sight, const Outlook& outlook, double now, double since);

  /// A cloud that is blind shows too little to say what is free: what is near in it is remembered, nothing is forgiven,
  /// and what it does not show is none of it lost.
  void note_blind(const View& view, const Sight& sight, const Outlook& outlook, double now);

  /// Whether any thing was near when it was shown last, or is lost.
  bool is_any_near() const { return limits_.distance > 0.0 && written_.is_any_near(); }

  /// In the latest picture, where what it cuts off at its lower border meets that, in the cloud's frame.
  const std::vector<Point>& ends_below() const { return ends_below_; }

  /// The number of the latest picture in which anything was near, or might have been.
  std::uint32_t picture() const { return things_.picture(); }

 private:
  std::optional<Loss> judge_organised(const View& view, const Sight& sight, const Outlook& outlook,
                                      const Patience& patience, float step);
  std::optional<Loss> judge_points(const View& view, const Sight& sight, const Outlook& outlook,
                                   const Patience& patience);
  void settle_in_axes();
  void move_with_camera(const Outlook& outlook);
  bool note_picture(const View& view, const Sight& sight, const Outlook& outlook);
  bool note_points(const View& view, const Outlook& outlook);
  /// What a raster shows.
  struct InRaster {
    Pixels picture;
    Sight sight;
    std::size_t least_pixels;  ///< fewer are noise
  };

  InRaster look_at_raster(const View& raster, const Outlook& outlook, const RayHits* hits, const UsualCells* usual);
  void look_at_ground(const Pixels& picture, const Outlook& outlook);
  bool note(const NearSearch& search);
  void note_backdrop(const Pixels& picture, bool stands);
  Pixels framed(const View& view, const Outlook& outlook);
  bool shows_near(const Sight& sight, const Outlook& outlook) const;
  void remember(const NearSearch& search, std::uint8_t clouds_of_floor, const Patience& patience,
                const std::optional<float>& nearer);
  bool move_to(const Frame& frame);
  void write_down(bool lost, double now);
  double blind_range() const;
  double kept_distance() const;
  KeptWithin kept() const;
  float near_distance() const;
  float watched_distance() const;

  NearLossLimits limits_;
  Frame frame_;  ///< in which the spots lie
  Optics optics_;
  CameraPose camera_;  ///< in the latest picture
  CameraHeight height_;
  NearGround ground_;
  FloorStrip floor_;
  HiddenFloor hidden_;
  LowObstacles low_;
  Raster raster_;
  Margins margins_;
  Backdrop backdrop_;
  ThingsMemory things_;
  std::optional<double> lost_since_;  ///< [s] anything, without a break
  bool is_cut_off_below_ = false;     ///< what that shows, at its lower border
  std::vector<Point> ends_below_;     ///< where
  bool are_axes_new_ = false;         ///< and no picture has come since
  Written written_;
};

}  // namespace safety_control_cloud
