// SPDX-License-Identifier: BSD-3-Clause
#include "near_loss.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "../look/look.hpp"
#include "cut_off.hpp"
#include "losses.hpp"
#include "near_things.hpp"
#include "stand.hpp"

namespace safety_control_cloud {
namespace {

/// Remembered from this much farther than it counts, so that noise at the limit does not decide, pixel by pixel, what
/// is known of an obstacle.
constexpr double margin = 1.04;

/// By so much farther than it is blind a sensor shows what is cut off [m]: noise, and what a robot that slows drives
/// between two clouds.
constexpr double cut_off = 0.05;

/// So much farther than what counts, things are watched.
constexpr double watched = 1.6;

/// What is seen comes nearer between two pictures by so much, and by so much a second [m]: a robot of 0.2 m/s, and what
/// comes to meet it.
constexpr double least_step = 0.03, fastest_step = 0.4;
constexpr double longest_step = 0.5;                                                      ///< [s]
constexpr float step_after_pause = static_cast<float>(least_step + 0.25 * fastest_step);  ///< in more than 0.25 s

/// [m] by which a thing may have come nearer in so many seconds; of a long while, no more than of `longest_step`.
float step_in(double seconds) {
  return static_cast<float>(least_step + std::clamp(seconds, 0.0, longest_step) * fastest_step);
}

constexpr const char* what_frees =
    "the camera sees what is behind it, or the near floor on which it stood, or after ~reset, when somebody has looked";

/// Of a picture, fewer pixels are noise; a cloud of few points has no others.
constexpr std::size_t least_pixels = 4;
constexpr std::size_t pixels_of_few = 400;

/// Whether rows and columns mean neighbours, in counts that fit into 16 bits. One column is no picture: that is how
/// some drivers say "not organised".
bool is_picture(const View& view) {
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  const std::size_t width = width_of(view), height = height_of(view);
  return width >= 2 && height >= 2 && width <= most && height <= most;
}

}  // namespace

void NearLoss::forget() { *this = NearLoss(limits_); }

Rows NearLoss::rows_for(const View& view) const {
  return limits_.distance > 0.0 && is_picture(view) ? Rows::Apart : Rows::Joined;
}

/// [m] nearer than which the sensor sees nothing: as it is set, or as what vanished has shown.
double NearLoss::blind_range() const { return std::max(limits_.blind_range, double{things_.blind_range()}); }

/// [m] nearer than which a thing counts when it is lost: at a step from the blind range it must be kept.
double NearLoss::kept_distance() const {
  return std::max({limits_.distance, limits_.blind_range + step_nearer, 1.1 * double{things_.blind_range()}});
}
KeptWithin NearLoss::kept() const { return {kept_distance(), blind_range() + step_nearer}; }
float NearLoss::near_distance() const { return static_cast<float>(margin * kept_distance()); }
float NearLoss::watched_distance() const { return static_cast<float>(watched * kept_distance()); }

bool NearLoss::cuts_off(const Sight& sight, const Outlook& outlook) const {
  if (limits_.distance <= 0.0 || !sight.nearest) return false;
  return is_cut_off_below_ || sight.nearest->distance() - outlook.camera().z < blind_range() + cut_off;
}

std::optional<Loss> NearLoss::judge(const View& view, const Sight& sight, const Outlook& outlook, double now,
                                    double since) {
  is_cut_off_below_ = false;
  ends_below_.clear();
  if (limits_.distance <= 0.0) return std::nullopt;
  const Patience patience{now, limits_.timeout};
  move_with_camera(outlook);
  auto loss = is_picture(view) ? judge_organised(view, sight, outlook, patience, step_in(since))
                               : judge_points(view, sight, outlook, patience);
  write_down(loss && !is_in_sight(*loss), now);
  if (!loss || is_in_sight(*loss)) {
    lost_since_.reset();
    return loss;
  }
  if (!lost_since_) lost_since_ = now;
  loss->since = lost_since_;
  loss->hint = loss->cause == Cause::LowObstacle
                   ? "the floor before it is seen again, or after ~reset, when somebody has looked"
                   : what_frees;
  return loss;
}

void NearLoss::note_blind(const View& view, const Sight& sight, const Outlook& outlook, double now) {
  if (limits_.distance <= 0.0) return;
  move_with_camera(outlook);
  const bool any =
      is_picture(view) ? note_picture(view, sight, outlook) : shows_near(sight, outlook) && note_points(view, outlook);
  if (any) write_down(written_.is_any_lost(), now);
}

bool NearLoss::note_picture(const View& view, const Sight& sight, const Outlook& outlook) {
  const Pixels picture = framed(view, outlook);
  look_at_ground(picture, outlook);
  const bool any =
      shows_near(sight, outlook) && note({picture, outlook, sight.nearest_in_rows, watched_distance(), least_pixels});
  low_.note(ground_, picture, outlook);
  return any;
}

bool NearLoss::note_points(const View& view, const Outlook& outlook) {
  const InRaster shown = look_at_raster(raster_.picture_of_few(view, outlook.corridor), outlook, nullptr, nullptr);
  return note({shown.picture, outlook, shown.sight.nearest_in_rows, watched_distance(), shown.least_pixels});
}

void NearLoss::look_at_ground(const Pixels& picture, const Outlook& outlook) {
  ground_.look_at(picture, outlook, near_distance(), floor_.rows_to_read());
}

/// In the frame that the raster has from then on.
NearLoss::InRaster NearLoss::look_at_raster(const View& raster, const Outlook& outlook, const RayHits* hits,
                                            const UsualCells* usual) {
  Pixels picture(raster, outlook.corridor.range_min, hits, usual);
  picture.frame(raster_.framing());
  move_to({picture.width(), picture.height(), raster_.rays()});
  look_at_ground(picture, outlook);
  return {picture, look(raster, outlook, Crop::Skip, Rows::Apart),
          std::min(least_pixels, 1 + raster_.filled() / pixels_of_few)};
}

bool NearLoss::note(const NearSearch& search) {
  auto things = near_things(search);
  if (things.empty()) return false;
  place_on_ground(things, ground_, search.picture, search.outlook);
  things_.update_by_little(std::move(things), search.picture, near_distance(), camera_);
  return true;
}

bool NearLoss::shows_near(const Sight& sight, const Outlook& outlook) const {
  return sight.nearest && sight.nearest->distance() - outlook.camera().z < watched_distance();
}

/// In the frame that is known of it, in which what is remembered lies from then on.
Pixels NearLoss::framed(const View& view, const Outlook& outlook) {
  Pixels picture(view, outlook.corridor.range_min);
  const Frame frame{picture.width(), picture.height(), optics_.look_at(view, picture)};
  const double share = share_of_angle(frame_, frame);
  if (move_to(frame)) things_.scale_sizes(share);
  low_.move_to(frame);
  picture.look_along(frame.rays);
  return picture;
}

std::optional<Loss> NearLoss::judge_organised(const View& view, const Sight& sight, const Outlook& outlook,
                                              const Patience& patience, float step) {
  Pixels picture = framed(view, outlook);
  picture.frame(margins_.note(picture));
  look_at_ground(picture, outlook);
  remember({picture, outlook, sight.nearest_in_rows, watched_distance(), least_pixels}, 1, patience, step);
  const auto low = low_.judge(ground_, picture, outlook, patience, step > step_after_pause ? step : 0.0f);
  const auto thing = nearest_loss(things_.things(), outlook, kept());
  is_cut_off_below_ = recedes_at_the_bottom(picture, sight.nearest_in_rows);
  if (is_cut_off_below_) ends_below_ = ends_at_the_bottom(picture, outlook);
  note_backdrop(picture, thing && thing->whole);
  auto loss = nearer(low, thing);
  auto covered = floor_.covered();
  hidden_.note(floor_, covered, things_.things(), picture, {outlook, frame_.rays}, static_cast<float>(blind_range()));
  if (!covered.empty() || hidden_.may_be_there()) {
    loss = Loss{Cause::NearLoss, std::nullopt, true,
                "the near floor is hidden by something nearer than the camera can see"};
  }
  if (loss && !low) {
    loss->covered = std::move(covered);
    loss->spots = lost_spots(things_.things(), outlook, kept());
  }
  return loss;
}

/// Where a guard's robot goes on, what never returns moves in its picture, and would be taken for what it lost.
void NearLoss::note_backdrop(const Pixels& picture, bool stands) {
  if (!limits_.stands) return;
  std::vector<Backdrop::Part> lost;
  for (const Remembered& thing : things_.things())
    if (stands && !thing.lost.empty()) lost.push_back(part_around(thing.lost, picture.width()));
  backdrop_.note(picture, camera_, lost);
}

/// What hides the floor is noticed by itself only in a picture: here the floor has to be seen for longer, since strays
/// may fill a hole in it for a moment.
std::optional<Loss> NearLoss::judge_points(const View& view, const Sight& sight, const Outlook& outlook,
                                           const Patience& patience) {
  const bool free = things_.empty() && !shows_near(sight, outlook);
  if (free && !raster_.usual().learns()) return std::nullopt;
  const View raster = raster_.picture_of(view, outlook.corridor, !free);
  if (free) return std::nullopt;
  const bool sparse = 10 * raster_.filled() > 7 * sight.returns;
  const InRaster shown = look_at_raster(raster, outlook, sparse ? nullptr : &raster_.hits(), &raster_.usual());
  remember({shown.picture, outlook, shown.sight.nearest_in_rows, watched_distance(), shown.least_pixels, sparse},
           FloorStrip::lately, patience, std::nullopt);
  return nearest_loss(things_.things(), outlook, kept());
}

void NearLoss::remember(const NearSearch& search, std::uint8_t clouds_of_floor, const Patience& patience,
                        const std::optional<float>& nearer) {
  auto things = near_things(search);
  place_on_ground(things, ground_, search.picture, search.outlook);
  floor_.survey(ground_, patience);
  const auto is_seen_again = [&](std::size_t column) {
    const std::size_t i = ground_.column_at(column);
    return !ground_.is_near(i) && floor_.is_seen_again(i, clouds_of_floor > 1);
  };
  const NearFloor floor{is_seen_again, floor_.rows(), clouds_of_floor};
  const Gaze gaze{search.outlook, frame_.rays, nearer};
  things_.update(std::move(things), search.picture, floor, backdrop_, near_distance(), gaze);
  things_.forget_old(patience);
}

void NearLoss::write_down(bool lost, double now) {
  const auto kept = [this] {
    ThingsMemory things = things_;
    things.add_unseen(hidden_.spots());  // the camera may look elsewhere when the process comes up again
    return Kept{frame_.width, frame_.height, things_.blind_range(), things.things(),
                low_.floor(), camera_,       low_.any_beside()};
  };
  written_.bring_up_to_date(things_.things(), near_distance(), lost, now, kept);
}

bool NearLoss::restore(const std::string& text) {
  auto kept = kept_in(text);
  if (!kept) return false;
  forget();
  written_ = Written(text, !kept->things.empty() || is_any_low(*kept));
  frame_ = {kept->width, kept->height, {}};
  things_.add(std::move(kept->things), kept->blind_range, kept->camera);
  low_.move_to(frame_);
  camera_ = kept->camera;
  if (is_any_low(*kept)) low_.restore(std::move(kept->low), -place_of(camera_)[1]);
  return true;
}

/// The spots of what is remembered in another picture, from a camera that looks the same way; whether it is another.
/// Their sizes stay: in a raster, whose cells grow with the spacing of the points, one point is one pixel all the same.
bool NearLoss::move_to(const Frame& frame) {
  if (frame == frame_) return false;
  things_.add_unseen(hidden_.take());
  things_.for_each_spot([&](Spot& spot) { place(spot, frame_, frame); });
  frame_ = frame;
  floor_ = FloorStrip{};
  margins_ = Margins{};
  backdrop_ = Backdrop{};
  things_.stay();
  return true;
}

void NearLoss::settle_in_axes() {
  height_ = CameraHeight{};
  low_.change_axes();
  floor_.change_axes();
  things_.add_unseen(hidden_.take());
  things_.change_axes(camera_);
  things_.stay();
  backdrop_ = Backdrop{};
}

void NearLoss::move_with_camera(const Outlook& outlook) {
  camera_ = camera_pose_of(outlook);
  if (std::exchange(are_axes_new_, false)) settle_in_axes();
  things_.add_unseen(hidden_.left_behind(camera_));
  const float height = -place_of(camera_)[1];
  low_.move_to(height, height_.note(height));
  floor_.move_to(height);
}

/// What is known behind is told as the camera looked before, in the axes as they were: it is looked for anew.
void NearLoss::turn_corridor(double angle) {
  low_.change_corridor();
  backdrop_ = Backdrop{};
  things_.stay();
  things_.add_unseen(hidden_.take());
  things_.turn_corridor(angle);
}

}  // namespace safety_control_cloud
