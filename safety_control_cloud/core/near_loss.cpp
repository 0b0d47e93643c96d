// SPDX-License-Identifier: BSD-3-Clause
#include "near_loss.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "point_reader.hpp"

namespace safety_control_cloud {
namespace {

/// Lost pixels in this share of the cloud, and more of them than still return near, are an obstacle, not its edge.
constexpr std::size_t obstacle_share = 1000;
/// A return this little beside the ray of a kept point lies behind it: tan of about 1 degree.
constexpr float behind_slope = 0.02f;
/// The edge of what stands upright leans in the picture, as the robot pitches, by at most this share of its width: what
/// a column shows near the edge reaches the floor in another one.
constexpr std::size_t edge_share = 128;
/// Remembered from this much farther than it counts, so that noise at the limit does not decide, pixel by pixel, what
/// is known of an obstacle.
constexpr double margin = 1.04;
/// An obstacle that is seen this little farther than before has moved away, not vanished [m].
constexpr double retreat = 0.1;

/// Whether rows and columns mean neighbours, in counts that fit into 16 bits. One column is no picture: that is how
/// some drivers say "not organised".
bool is_picture(std::size_t width, std::size_t height) {
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  return width >= 2 && height >= 2 && width <= most && height <= most;
}

bool is_lost(std::uint16_t pixel) { return PixelMemory::is_near(pixel); }  // near, and without the flag `now`

/// The nearest pixel of those 2 x 2 of two rows that are all lost; not near if there are none.
std::uint16_t nearest_lost_block(const std::uint16_t* above, const std::uint16_t* below, std::size_t width) {
  std::uint16_t nearest = PixelMemory::nothing;
  for (std::size_t i = 1; i < width; ++i) {
    const std::uint16_t farthest = std::max(std::max(above[i - 1], above[i]), std::max(below[i - 1], below[i]));
    const std::uint16_t least = std::min(std::min(above[i - 1], above[i]), std::min(below[i - 1], below[i]));
    nearest = std::min(nearest, is_lost(farthest) ? least : PixelMemory::nothing);
  }
  return nearest;
}

}  // namespace

void NearLoss::limit(const NearLossLimits& limits) {
  if (limits.distance != limits_.distance) forget();
  limits_ = limits;
}

void NearLoss::forget() { *this = NearLoss(limits_); }

PixelMemory* NearLoss::memory_for(const View& view) {
  const std::size_t width = width_of(view), height = height_of(view);
  if (limits_.distance <= 0.0 || !is_picture(width, height)) return nullptr;
  if (width != memory_.width || height != memory_.height) {
    // What was near is still there whatever the resolution: every pixel of the new one has to see past it.
    std::uint16_t nearest = PixelMemory::nothing;
    for (const std::uint16_t pixel : memory_.pixels) nearest = std::min(nearest, PixelMemory::code_of(pixel));
    memory_.pixels.assign(width * height, PixelMemory::is_near(nearest) ? nearest : PixelMemory::nothing);
    memory_.width = width;
    memory_.height = height;
    hid_floor_.assign(width, false);
    floor_ = FloorStrip{};
  }
  memory_.distance = static_cast<float>(margin * limits_.distance);
  return &memory_;
}

std::optional<Loss> NearLoss::judge(const View& view, const Sight& sight, const Corridor& corridor, const Gaze& gaze,
                                    double now) {
  if (limits_.distance <= 0.0) return std::nullopt;
  const auto loss = gaze.memory ? judge_pixels(sight) : judge_nearest(view, sight, corridor, gaze);
  if (!loss) {
    lost_since_.reset();
    return std::nullopt;
  }
  if (!lost_since_) lost_since_ = now;
  if (limits_.timeout > 0.0 && now - *lost_since_ >= limits_.timeout) {
    forget();
    return std::nullopt;
  }
  return loss;
}

std::optional<Loss> NearLoss::judge_pixels(const Sight& sight) {
  floor_.survey(memory_);
  const bool something_near = sight.nearest && sight.nearest->distance() < memory_.distance;
  std::size_t lost = sight.lost;
  // Also while the floor is covered: who comes near meanwhile is to be let go again.
  if (lost > 0 || something_near) {
    note_what_hides_floor();
    lost -= release_columns_with_floor();
  }
  if (floor_.is_covered()) {
    return Loss{std::nullopt, true, "the near floor is hidden by something nearer than the camera can see"};
  }
  return lost > 0 ? lost_obstacle(lost, sight.total) : std::nullopt;
}

void NearLoss::note_what_hides_floor() {
  const auto near_now = [&](std::size_t i) { return PixelMemory::is_near(memory_.near.nearest_now[i]); };
  for (std::size_t i = 0; i < memory_.width; ++i) hid_floor_[i] = hid_floor_[i] && !near_now(i);
  const std::size_t edge = std::max<std::size_t>(1, memory_.width / edge_share);
  for (std::size_t i = 0; i < memory_.width; ++i) {
    if (!near_now(i)) continue;
    const auto [shown, hidden, foot, blank] = floor_.columns()[i];
    const bool hides = hidden > 0 && 4 * hidden >= shown + hidden;
    if (!hides && !floor_.is_reached(memory_, i)) continue;
    const std::size_t first = i - std::min(edge, i), last = std::min(i + edge, memory_.width - 1);
    for (std::size_t j = first; j <= last; ++j) hid_floor_[j] = hid_floor_[j] || near_now(j);
  }
}

/// How many lost pixels it lets go.
std::size_t NearLoss::release_columns_with_floor() {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < memory_.width; ++i) {
    const bool near_now = PixelMemory::is_near(memory_.near.nearest_now[i]);
    const auto [shown, hidden, foot, blank] = floor_.columns()[i];
    const bool floor_again = !near_now && shown > 0 && 8 * hidden <= shown;
    if (!hid_floor_[i] || !floor_again) continue;
    hid_floor_[i] = false;
    free.push_back(i);
  }
  return release(free);
}

std::size_t NearLoss::release(const std::vector<std::size_t>& columns) {
  std::size_t released = 0;
  if (columns.empty()) return released;
  for (std::size_t row = 0; row < memory_.height; ++row) {
    if (!PixelMemory::is_near(memory_.near.nearest_lost[row])) continue;
    for (const std::size_t i : columns) {
      std::uint16_t& pixel = memory_.row(row)[i];
      if (!is_lost(pixel)) continue;
      pixel = PixelMemory::elsewhere;
      ++released;
    }
  }
  return released;
}

std::optional<Loss> NearLoss::lost_obstacle(std::size_t lost, std::size_t total) const {
  const std::uint16_t limit = PixelMemory::near_code(static_cast<float>(limits_.distance));
  std::uint16_t nearest = limit;
  for (std::size_t row = 1; row < memory_.height; ++row) {
    const auto [nearer, farther] = std::minmax(memory_.near.nearest_lost[row - 1], memory_.near.nearest_lost[row]);
    if (nearer >= nearest || !PixelMemory::is_near(farther)) continue;
    nearest = std::min(nearest, nearest_lost_block(memory_.row(row - 1), memory_.row(row), memory_.width));
  }
  if (nearest == limit) return std::nullopt;
  const bool whole = lost > memory_.near.now && lost * obstacle_share >= total;
  return Loss{PixelMemory::distance_of_near(nearest), whole,
              "an obstacle has stopped returning and nothing is seen behind it"};
}

std::optional<Loss> NearLoss::judge_nearest(const View& view, const Sight& sight, const Corridor& corridor,
                                            const Gaze& gaze) {
  if (sight.nearest && sight.nearest->distance() < limits_.distance) {
    // What is too close to measure lies in no direction, so nothing could ever be seen behind it.
    if (sight.nearest->distance() > 0.0) nearest_ = sight.nearest;
    return std::nullopt;
  }
  if (!nearest_) return std::nullopt;
  const Point kept = nearest_->point;
  bool gone = sight.nearest && sight.nearest->distance() < nearest_->distance() + retreat;
  for_each_point(view, [&](float x, float y, float z) {
    if (gone || !is_return(x, y, z, corridor)) return;
    const Point point = placed(x, y, z, gaze);
    const float scale = point.z / kept.z, beside = behind_slope * point.z;
    gone =
        point.z > kept.z && std::abs(point.x - kept.x * scale) < beside && std::abs(point.y - kept.y * scale) < beside;
  });
  if (gone) {
    nearest_.reset();
    return std::nullopt;
  }
  return Loss{nearest_->distance(), true, "the nearest obstacle has stopped returning and nothing is seen behind it"};
}

}  // namespace safety_control_cloud
