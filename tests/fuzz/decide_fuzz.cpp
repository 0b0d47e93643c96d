// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer: whatever a camera, a clock and a parameter server may send, in any order, with restarts. Both methods must
// decide the same, of clouds and of depth images; nothing but sight may move the robot, and what was near and is not
// seen to go is not forgotten.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "../../safety_control_cloud/core/look/ray_lines.hpp"
#include "inputs.hpp"
#include "promises.hpp"
#include "scenario.hpp"
#include "shown.hpp"

namespace safety_control_cloud {
namespace {

/// One node for each method, and one that is given depth images where the others are given clouds, in the same world.
class World {
 public:
  explicit World(const Choice& choice)
      : one_pass_(settings_of(choice, Method::OnePass)),
        pcl_(settings_of(choice, Method::Pcl)),
        by_depth_(settings_of(choice, Method::OnePass)) {}

  void go_on(Step& step) {
    now_.steady += step.elapsed / 1000.0;
    now_.ros += step.ros_elapsed / 1000.0;
    if (step.event == Event::Forget) return forget();
    if (step.event == Event::Settings) return take(step.choice);
    if (step.event == Event::Quiet) return wait();
    if (step.event == Event::Restart) return restart();
    if (step.event == Event::Outside) return note_outside(step);
    if (step.event == Event::Picture) return see(depths_of(step), step);
    see(view_of(step.claims, step.bytes.data(), step.bytes.size()), step);
  }

  void end_in_silence() {
    now_.steady += 0.6;
    const Decision decision = one_pass_.without_cloud(now_);
    require(decision.speed == 0.0 && decision.cause != Cause::Seen, "silence stops the robot");
  }

 private:
  void forget() {
    for (SafetyControl* each : all()) each->forget_losses();
    shown_.forget();
  }

  void take(const Choice& choice) {
    one_pass_.adopt(settings_of(choice, Method::OnePass));
    pcl_.adopt(settings_of(choice, Method::Pcl));
    by_depth_.adopt(settings_of(choice, Method::OnePass));
    if (!keeps(one_pass_.settings())) shown_.forget();
  }

  /// kill -9, and a new process with what the old one wrote down.
  void restart() {
    for (SafetyControl* each : all()) {
      SafetyControl another(each->settings());
      another.recall(each->remembered());
      *each = std::move(another);
    }
  }

  void note_outside(const Step& step) {
    std::optional<Doubt> doubt;
    if (step.source % 2 == 1) doubt = Doubt{Cause::TwoCommanders, "somebody commands"};
    for (SafetyControl* each : all()) each->note_outside(doubt);
  }

  void wait() {
    const Decision decision = one_pass_.without_cloud(now_);
    require_same(decision, pcl_.without_cloud(now_));
    const Decision by_depth = by_depth_.without_cloud(now_);
    if (are_alike_) require_same(decision, by_depth);
    require_safe(decision, one_pass_.settings());
  }

  void see(const Depths& picture, const Step& step) {
    const std::vector<float> points = points_of(picture);
    const CloudView cloud = cloud_of(points, picture);
    const bool says_too_close = std::any_of(picture.z.begin(), picture.z.end(), is_minus_inf);
    note_rays(picture, cloud);
    const bool must_stand = shown_.stands_for(picture);
    const Decision decision = see(cloud, says_too_close ? Reading(cloud) : Reading(image_of(picture)), step);
    require(!must_stand || decision.speed == 0.0, "what was near and was not seen to go is not forgotten");
    if (step.placing % 8 == 7 || !keeps(one_pass_.settings())) return shown_.forget();
    if (has_looked(decision)) shown_.note(picture);
  }

  void see(const Reading& cloud, const Step& step) {
    see(cloud, cloud, step);
    shown_.forget();
  }

  Decision see(const Reading& cloud, const Reading& depth, const Step& step) {
    const Origin origin{now_.ros - step.stamp_age / 1000.0, placing_of(step.placing, one_pass_.settings()),
                        one_of<const char*>({"camera", "camera", "", "another"}, step.source), "frame"};
    const Crop crop = step.crop % 2 ? Crop::Keep : Crop::Skip;
    const Decision decision = one_pass_.decide(cloud, origin, now_, crop);
    require_same(decision, pcl_.decide(cloud, origin, now_, crop));
    const Decision by_depth = by_depth_.decide(depth, origin, now_, crop);
    are_alike_ = are_alike_ && is_of_one_size_ && is_lost(decision) == is_lost(by_depth) &&
                 (tell_their_rays_ || !is_lost(decision) || decision.reason == by_depth.reason);
    if (are_alike_) require_same(decision, by_depth);
    require_safe(by_depth, by_depth_.settings());
    require_safe(decision, one_pass_.settings());
    return decision;
  }

  /// Where in a picture lies what is remembered, of another size or after it was blind, a depth image tells at once,
  /// and a cloud only by enough returns: one may stand for what the other still sees, or has seen to go, or for one
  /// thing more.
  void note_rays(const Depths& picture, const CloudView& cloud) {
    const RayLines rays = ray_lines_of(cloud);
    tell_their_rays_ = tell_their_rays_ && rays.across && rays.down;
    const bool is_first = width_ == 0 && height_ == 0;
    is_of_one_size_ = is_of_one_size_ && (is_first || (picture.width == width_ && picture.height == height_));
    width_ = picture.width, height_ = picture.height;
  }

  static bool is_lost(const Decision& decision) { return decision.cause == Cause::NearLoss; }

  std::array<SafetyControl*, 3> all() { return {&one_pass_, &pcl_, &by_depth_}; }

  SafetyControl one_pass_, pcl_, by_depth_;
  std::size_t width_ = 0, height_ = 0;  ///< of the latest picture
  bool is_of_one_size_ = true;          ///< all that have been seen
  bool tell_their_rays_ = true;         ///< the clouds, all that have been seen
  bool are_alike_ = true;               ///< the cloud and the depth image, all that have been seen
  Shown shown_;
  Instant now_{100.0, 1000.0};
};

}  // namespace
}  // namespace safety_control_cloud

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace safety_control_cloud;
  return happen_as_told<World, Choice, Step>(bytes, size, 32);
}
