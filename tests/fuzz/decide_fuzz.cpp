// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer: whatever a camera, a clock and a parameter server may send, in any order. Both methods must decide the
// same, and nothing but sight may move the robot.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "../../safety_control_cloud/core/safety_control.hpp"
#include "../../safety_control_cloud/core/speed/speed.hpp"
#include "scenario.hpp"

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

/// A picture as a cloud: a camera 60 degrees wide.
Layout layout_of(Step& step, std::vector<std::uint8_t>& bytes) {
  Layout layout;
  layout.width = step.width % 64;
  layout.height = step.height % 64;
  layout.fields = {{"x", 0, Field::FLOAT32, 1}, {"y", 4, Field::FLOAT32, 1}, {"z", 8, Field::FLOAT32, 1}};
  layout.point_step = 12;
  layout.row_step = layout.width * 12;
  std::vector<float> points;
  for (std::size_t i = 0; i < std::size_t{layout.width} * layout.height; ++i) {
    const float z = depth_of(i < step.bytes.size() ? step.bytes[i] : 0);
    const float column = static_cast<float>(i % layout.width), row = static_cast<float>(i / layout.width);
    const float across = static_cast<float>(layout.width) / 2.0f, down = static_cast<float>(layout.height) / 2.0f;
    points.insert(points.end(), {z * 0.577f * (column - across) / across, z * 0.433f * (row - down) / down, z});
  }
  const auto* from = reinterpret_cast<const std::uint8_t*>(points.data());
  bytes.assign(from, from + points.size() * sizeof(float));
  return layout;
}

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

void require_safe(const Decision& decision, const Settings& settings) {
  require(decision.speed == speed_for(decision.zone, settings.speeds), "the speed is the zone's");
  const auto causes_of_sight = {Cause::Seen, Cause::NearLoss, Cause::LowObstacle};
  const bool has_looked =
      std::find(causes_of_sight.begin(), causes_of_sight.end(), decision.cause) != causes_of_sight.end();
  require(has_looked || (decision.speed == 0.0 && decision.zone == Zone::Danger), "in doubt the robot stands");
  require(!decision.reason.empty(), "every decision has a reason");
  if (!has_looked || !decision.nearest) return;
  require(decision.zone <= zone_at(decision.nearest->distance(), settings.limits),
          "no zone is better than its obstacle");
  if (decision.sight.crop) require(decision.sight.crop->size() == decision.sight.inside, "the crop is what is inside");
}

/// One node for each method, in the same world.
class World {
 public:
  explicit World(const Choice& choice)
      : one_pass_(settings_of(choice, Method::OnePass)), pcl_(settings_of(choice, Method::Pcl)) {}

  void go_on(Step& step) {
    now_.steady += step.elapsed / 1000.0;
    now_.ros += step.ros_elapsed / 1000.0;
    if (step.event == Event::Forget) return forget();
    if (step.event == Event::Settings) return take(step.choice);
    if (step.event == Event::Quiet) return check(one_pass_.without_cloud(now_), pcl_.without_cloud(now_));
    see(step);
  }

  void end_in_silence() {
    now_.steady += 0.6;
    const Decision decision = one_pass_.without_cloud(now_);
    require(decision.speed == 0.0 && decision.cause != Cause::Seen, "silence stops the robot");
  }

 private:
  void forget() {
    one_pass_.forget_losses();
    pcl_.forget_losses();
  }

  void take(const Choice& choice) {
    one_pass_.adopt(settings_of(choice, Method::OnePass));
    pcl_.adopt(settings_of(choice, Method::Pcl));
  }

  void see(Step& step) {
    std::vector<std::uint8_t> bytes = step.bytes;
    const Layout layout = step.event == Event::Picture ? layout_of(step, bytes) : step.claims;
    const Reading reading = view_of(layout, bytes.data(), bytes.size());
    const Origin origin{now_.ros - step.stamp_age / 1000.0, placing_of(step.placing, one_pass_.settings())};
    const Crop crop = step.crop % 2 ? Crop::Keep : Crop::Skip;
    check(one_pass_.decide(reading, origin, now_, crop), pcl_.decide(reading, origin, now_, crop));
  }

  void check(const Decision& by_one_pass, const Decision& by_pcl) {
    require_same(by_one_pass, by_pcl);
    require_safe(by_one_pass, one_pass_.settings());
  }

  SafetyControl one_pass_, pcl_;
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
