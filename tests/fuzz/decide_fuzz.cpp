// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer: whatever a camera, a clock and a parameter server may send, in any order, with restarts. Both methods must
// decide the same, of clouds and of depth images; nothing but sight may move the robot, and what was near and is not
// seen to go is not forgotten.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <vector>

#include "../../safety_control_cloud/core/safety_control.hpp"
#include "../../safety_control_cloud/core/speed/speed.hpp"
#include "scenario.hpp"
#include "shown.hpp"

namespace safety_control_cloud {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

void require(bool holds, const char* sentence) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", sentence);
  std::abort();
}

template <class Value, std::size_t n>
Value one_of(const Value (&values)[n], std::uint8_t choice) {
  return values[choice % n];
}

Settings settings_of(const Choice& choice, Method method) {
  Settings settings;
  settings.method = method;
  settings.corridor.min_points = one_of<std::size_t>({1, 2, 5}, choice.min_points);
  settings.corridor.range_min = one_of<float>({0.0f, 0.2f}, choice.range_min);
  settings.release.clouds = one_of<std::size_t>({1, 2, 3}, choice.release_clouds);
  settings.release.time = one_of<double>({0.0, 0.2}, choice.release_time);
  settings.stamp_tolerance = one_of<double>({1.0, 0.0}, choice.stamp_tolerance);
  settings.min_valid_ratio = one_of<double>({0.1, 0.0, 1.0}, choice.min_valid_ratio);
  settings.near_loss.distance = one_of<double>({0.75, 0.0, NearLossLimits::farthest}, choice.near_loss_distance);
  settings.near_loss.timeout = one_of<double>({0.0, 0.3}, choice.near_loss_timeout);
  settings.frozen_clouds = one_of<std::size_t>({0, 2, 4}, choice.frozen_clouds);
  settings.target_frame = one_of<const char*>({"", "base"}, choice.target_frame);
  return settings;
}

/// Mostly one that belongs to these settings.
Placing placing_of(std::uint8_t choice, const Settings& settings) {
  Placement tilted, overflowing;
  tilted.rows = {{{1, 0, 0, 0.05f}, {0, 0.8f, -0.6f, 0}, {0, 0.6f, 0.8f, -0.09f}}};
  overflowing.rows = {{{0.7f, 0.7f, 0, 0}, {-0.7f, 0.7f, 0, 0}, {0, 0, 1, largest}}};
  if (choice % 8 == 7) return tilted;
  if (settings.target_frame.empty()) return one_of<Placing>({OpticalFrame{}, NoTransform{"nobody knows"}}, choice);
  return one_of<Placing>({tilted, OpticalFrame{}, NoTransform{"nobody knows"}, overflowing}, choice);
}

float depth_of(std::uint8_t pixel) {
  constexpr float special[] = {nan, 0.0f, inf, -inf, -1.0f, largest, std::numeric_limits<float>::denorm_min(), 1e-3f};
  return pixel < std::size(special) ? special[pixel] : static_cast<float>(pixel) * 0.02f;
}

Depths depths_of(const Step& step) {
  Depths picture{step.width % 64u, step.height % 64u, {}};
  for (std::size_t i = 0; i < picture.width * picture.height; ++i) {
    picture.z.push_back(depth_of(i < step.bytes.size() ? step.bytes[i] : 0));
  }
  return picture;
}

/// By a camera 60 degrees wide.
DepthView image_of(const Depths& picture) {
  DepthView image;
  image.bytes = reinterpret_cast<const std::uint8_t*>(picture.z.data());
  image.width = picture.width, image.height = picture.height;
  image.row_step = picture.width * sizeof(float);
  const double across = static_cast<double>(picture.width) / 2.0, down = static_cast<double>(picture.height) / 2.0;
  image.camera = {std::max(across, 1.0) / 0.577, std::max(down, 1.0) / 0.433, across, down};
  return image;
}

/// The points of such an image. In a cloud, -Inf is a point too close; an image here does not say so.
std::vector<float> points_of(const Depths& picture) {
  const Rays rays(image_of(picture));
  std::vector<float> points;
  for (std::size_t i = 0; i < picture.z.size(); ++i) {
    const float z = picture.z[i];
    const auto u = static_cast<float>(i % picture.width), v = static_cast<float>(i / picture.width);
    const float x = (u - rays.cx) * z * rays.x_scale, y = (v - rays.cy) * z * rays.y_scale;
    if (z == inf)
      points.insert(points.end(), {nan, nan, nan});
    else
      points.insert(points.end(), {x, y, z * rays.z_scale});
  }
  return points;
}

CloudView cloud_of(const std::vector<float>& points, const Depths& picture) {
  Layout layout;
  layout.width = static_cast<std::uint32_t>(picture.width), layout.height = static_cast<std::uint32_t>(picture.height);
  layout.fields = {{"x", 0, Field::FLOAT32, 1}, {"y", 4, Field::FLOAT32, 1}, {"z", 8, Field::FLOAT32, 1}};
  layout.point_step = 12;
  layout.row_step = layout.width * 12;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(points.data());
  return std::get<CloudView>(view_of(layout, bytes, points.size() * sizeof(float)));
}

bool is_minus_inf(float z) { return z == -inf; }

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void require_same(const std::optional<Obstacle>& a, const std::optional<Obstacle>& b) {
  require(a.has_value() == b.has_value(), "one method sees an obstacle and the other none");
  if (!a) return;
  const Point &p = a->point, &q = b->point;
  require(same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z), "both methods find the same nearest point");
}

void require_same(const Decision& a, const Decision& b) {
  require(a.cause == b.cause && a.reason == b.reason, "both methods give the same cause");
  require(a.zone == b.zone && a.speed == b.speed, "both methods give the same zone and speed");
  require_same(a.nearest, b.nearest);
  require_same(a.sight.nearest, b.sight.nearest);
  require(a.sight.returns == b.sight.returns && a.sight.total == b.sight.total, "both methods count the same returns");
  require(a.sight.inside == b.sight.inside, "both methods count the same points inside");
  require(a.sight.too_close == b.sight.too_close, "both methods count the same points that are too close");
  require(a.sight.nearest_in_rows == b.sight.nearest_in_rows, "both methods see the same nearest in each row");
}

bool has_looked(const Decision& decision) {
  const auto causes_of_sight = {Cause::Seen, Cause::NearLoss, Cause::LowObstacle};
  return std::find(causes_of_sight.begin(), causes_of_sight.end(), decision.cause) != causes_of_sight.end();
}

void require_safe(const Decision& decision, const Settings& settings) {
  require(decision.speed == speed_for(decision.zone, settings.speeds), "the speed is the zone's");
  require(has_looked(decision) || (decision.speed == 0.0 && decision.zone == Zone::Danger),
          "in doubt the robot stands");
  require(!decision.reason.empty(), "every decision has a reason");
  if (!has_looked(decision) || !decision.nearest) return;
  require(decision.zone <= zone_at(decision.nearest->distance(), settings.limits),
          "no zone is better than its obstacle");
  if (decision.sight.crop) require(decision.sight.crop->size() == decision.sight.inside, "the crop is what is inside");
}

/// Whether something near that is not seen any more keeps the robot where it is under these settings.
bool keeps(const Settings& settings) {
  return settings.near_loss.distance >= 0.75 && settings.near_loss.timeout == 0.0 && settings.target_frame.empty();
}

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
    require_same(decision, by_depth_.without_cloud(now_));
    require_safe(decision, one_pass_.settings());
  }

  void see(const Depths& picture, const Step& step) {
    const std::vector<float> points = points_of(picture);
    const CloudView cloud = cloud_of(points, picture);
    const bool says_too_close = std::any_of(picture.z.begin(), picture.z.end(), is_minus_inf);
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
    require_same(decision, by_depth_.decide(depth, origin, now_, crop));
    require_safe(decision, one_pass_.settings());
    return decision;
  }

  std::array<SafetyControl*, 3> all() { return {&one_pass_, &pcl_, &by_depth_}; }

  SafetyControl one_pass_, pcl_, by_depth_;
  Shown shown_;
  Instant now_{100.0, 1000.0};
};

}  // namespace
}  // namespace safety_control_cloud

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace safety_control_cloud;
  Tape tape(bytes, size);
  Choice choice;
  tape(choice);
  World world(choice);
  for (int steps = 0; tape.left() > 0 && steps < 32; ++steps) {
    Step step;
    travel(tape, step);
    world.go_on(step);
  }
  world.end_in_silence();
  return 0;
}
