// SPDX-License-Identifier: BSD-3-Clause
#include "near_loss.hpp"

#include <algorithm>
#include <limits>

namespace safety_control_cloud {
namespace {

/// Remembered from this much farther than it counts, so that noise at the limit does not decide, pixel by pixel, what
/// is known of an obstacle.
constexpr double margin = 1.04;

/// Whether rows and columns mean neighbours, in counts that fit into 16 bits. One column is no picture: that is how
/// some drivers say "not organised".
bool is_picture(std::size_t width, std::size_t height) {
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  return width >= 2 && height >= 2 && width <= most && height <= most;
}

bool is_in_sight(const Loss& loss) { return loss.cause == Cause::LowObstacle && !loss.whole; }

/// Where a loss is at the nearest [m].
double nearest_place(const Loss& loss) { return loss.whole || !loss.obstacle ? 0.0 : loss.obstacle->distance(); }

std::optional<Loss> nearer(const std::optional<Loss>& one, const std::optional<Loss>& other) {
  if (!one || !other) return one ? one : other;
  return nearest_place(*one) <= nearest_place(*other) ? one : other;
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
    floor_ = FloorStrip{};
    lost_ = LostPixels{};
  }
  memory_.distance = static_cast<float>(margin * limits_.distance);
  return &memory_;
}

std::optional<Loss> NearLoss::judge(const View& view, const Sight& sight, const Corridor& corridor, const Gaze& gaze,
                                    double now) {
  if (limits_.distance <= 0.0) return std::nullopt;
  const auto loss =
      gaze.memory ? judge_pixels(view, sight, gaze) : nearest_.judge(view, sight, corridor, gaze, limits_.distance);
  if (!loss || is_in_sight(*loss)) {
    lost_since_.reset();
    return loss;
  }
  if (!lost_since_) lost_since_ = now;
  if (limits_.timeout > 0.0 && now - *lost_since_ >= limits_.timeout) {
    forget();
    return std::nullopt;
  }
  return loss;
}

std::optional<Loss> NearLoss::judge_pixels(const View& view, const Sight& sight, const Gaze& gaze) {
  floor_.survey(memory_);
  // Also while the floor is covered: who comes near meanwhile is to be let go again.
  const std::size_t lost = lost_.forgive(memory_, floor_, sight);
  const auto low = low_.judge(memory_, view, gaze);
  if (floor_.is_covered()) {
    return Loss{Cause::NearLoss, std::nullopt, true,
                "the near floor is hidden by something nearer than the camera can see"};
  }
  return nearer(low, lost_.judge(memory_, lost, sight.total, limits_.distance));
}

}  // namespace safety_control_cloud
