// SPDX-License-Identifier: BSD-3-Clause
// Writes the fuzzers' seeds into two folders: seeds DECIDE GUARD. Every contradiction of the table, and robots that
// drive, stop, lose sight of something near and find the floor again; guarded ones, before walls and bumped.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "../core/input/malformed_clouds.hpp"
#include "../core/scene.hpp"
#include "guard_scenario.hpp"
#include "scenario.hpp"

namespace safety_control_cloud {
namespace {

using Steps = std::vector<Step>;
using GuardSteps = std::vector<GuardStep>;

Step claims(const ClaimedCloud& cloud) {
  Step step;
  step.event = Event::Claims;
  step.claims = cloud.layout;
  step.bytes.assign(cloud.size, 0x3f);  // 0.747f in every coordinate
  return step;
}

/// The scene in an eighth of its resolution.
Step picture(const Scene& scene) {
  constexpr std::size_t part = 4;
  const CloudView view = scene.view();
  Step step;
  step.width = static_cast<std::uint8_t>(view.width / part);
  step.height = static_cast<std::uint8_t>(view.height / part);
  for (std::size_t row = 0; row < view.height; row += part) {
    for (std::size_t column = 0; column < view.width; column += part) {
      const float z = reinterpret_cast<const Xyz*>(view.bytes + row * view.row_step)[column].z;
      step.bytes.push_back(std::isfinite(z) ? static_cast<std::uint8_t>(z * 50.0f) : std::uint8_t{0});
    }
  }
  return step;
}

/// A board that hangs in open space at `z` [m]; 0 is no return.
Step lone(float z) {
  Step step;
  step.width = step.height = 40;
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) {
      const bool on = row > 13 && row < 26 && column > 13 && column < 26;
      step.bytes.push_back(on ? static_cast<std::uint8_t>(z * 50.0f) : std::uint8_t{150});
    }
  }
  return step;
}

Step event(Event kind, std::uint16_t elapsed) {
  Step step;
  step.event = kind;
  step.elapsed = elapsed;
  return step;
}

Step in_base(Step step) {
  step.placing = 1;
  return step;
}

template <class Choice, class Step>
void write(const std::string& path, const Choice& choice, std::vector<Step> steps) {
  Recording recording;
  recording(choice);
  for (Step& step : steps) travel(recording, step);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(recording.bytes.data()),
             static_cast<std::streamsize>(recording.bytes.size()));
}

void write_all(const std::string& folder) {
  const Choice defaults;
  const Step free = picture(Scene()), near = picture(Scene({post(0.6f, 0.0f, 0.3f)})),
             lost = picture(Scene({post(0.3f, 0.0f, 0.3f)})), wall = picture(Scene({post(0.8f, 0.0f, 3.0f)}));
  for (const auto& malformed : malformed_clouds()) {
    write(folder + "/" + malformed.name, defaults, Steps{free, claims(malformed.cloud()), free});
  }
  Step unorganised = claims(well_formed_cloud());
  unorganised.claims.height = 1, unorganised.claims.width = 6, unorganised.claims.row_step = 96;
  write(folder + "/Unorganised", defaults, Steps{unorganised, free, unorganised});
  write(folder + "/Drive", defaults, Steps{free, wall, near, free, event(Event::Quiet, 100), event(Event::Quiet, 600)});
  write(folder + "/NearLoss", defaults, Steps{near, lost, lost, free});
  const Step kerb = picture(Scene({{0.72f, -0.2f, 0.2f, 0.22f, floor_y}})),
             nearer = picture(Scene({{0.64f, -0.2f, 0.2f, 0.22f, floor_y}}));
  write(folder + "/LowObstacle", defaults, Steps{free, kerb, nearer, nearer, free});
  write(folder + "/Restart", defaults,
        Steps{free, near, lost, event(Event::Restart, 0), lost, free, event(Event::Restart, 0)});
  Step commander = event(Event::Outside, 10), nobody = commander;
  commander.source = 1;
  write(folder + "/Outside", defaults, Steps{free, commander, free, nobody, free});
  Step another = free;
  another.source = 3;
  write(folder + "/TwoSources", defaults, Steps{free, another, free, another, free});
  write(folder + "/Lone", defaults, Steps{lone(0.5f), lone(0.0f), lone(0.0f), event(Event::Restart, 0), lone(0.0f)});
  write(folder + "/NearLossForgotten", defaults, Steps{near, lost, event(Event::Forget, 0), lost});
  Choice frozen;
  frozen.frozen_clouds = 1;
  write(folder + "/Frozen", frozen, Steps{free, free, free, near});
  Step infinite = free;
  infinite.bytes[0] = 2;
  write(folder + "/NoReturnInTwoWays", frozen, Steps{free, infinite, free, infinite});
  Choice in_frame;
  in_frame.target_frame = 1;
  write(folder + "/TargetFrame", in_frame, Steps{in_base(free), in_base(near), in_base(lost), in_base(free)});
  Choice patient;
  patient.min_points = patient.release_clouds = patient.release_time = 1;
  Step other = event(Event::Settings, 0);
  other.choice = patient;
  write(folder + "/OtherSettings", defaults, Steps{free, other, near, wall, free, free});
}

GuardStep guard_event(GuardEvent kind, std::array<std::uint8_t, 6> numbers = {}, std::uint16_t elapsed = 0) {
  GuardStep step;
  step.event = kind;
  step.elapsed = elapsed, step.ros_elapsed = static_cast<std::int16_t>(elapsed);
  step.numbers = numbers;
  return step;
}

GuardStep wall_at(float z) {
  GuardStep step = guard_event(GuardEvent::Look, {}, 50);
  step.bytes = {static_cast<std::uint8_t>(z * 50.0f)};
  return step;
}

GuardStep wish(double forward, double turn = 0.0) {
  const auto number = [](double value) { return static_cast<std::uint8_t>(128.0 + 100.0 * value); };
  return guard_event(GuardEvent::Want, {number(forward), 0, 0, 0, 0, number(turn)});
}

void write_all_of_guard(const std::string& folder) {
  const GuardChoice circle;
  GuardChoice rectangle, overridden;
  rectangle.footprint = 1;
  overridden.override_max = 1;
  const GuardStep ahead = wish(0.5), back = wish(-0.3), turn = wish(0.0, 0.9), arc = wish(0.4, 0.4);
  const GuardStep far = wall_at(3.0f), near = wall_at(0.6f), at_rest = guard_event(GuardEvent::Odometry, {}, 10);
  const GuardStep bump = guard_event(GuardEvent::Switch, {1}), release = guard_event(GuardEvent::Switch, {0}, 600);
  const GuardStep ask = guard_event(GuardEvent::Override, {228, 138, 1});
  write(folder + "/Approach", circle, GuardSteps{far, ahead, wall_at(1.5f), ahead, near, ahead, back, turn});
  write(folder + "/Arcs", rectangle, GuardSteps{far, arc, far, ahead, near, arc, wall_at(0.8f), turn, ahead});
  write(folder + "/Odometry", rectangle, GuardSteps{at_rest, far, ahead, at_rest, near, ahead, at_rest, far, back});
  write(folder + "/Bumped", circle, GuardSteps{far, ahead, bump, ahead, back, release, far, ahead});
  write(folder + "/Overridden", overridden, GuardSteps{near, ahead, ask, ahead, far, ahead});
  write(folder + "/Restarted", circle, GuardSteps{far, ahead, guard_event(GuardEvent::Restart), ahead, far, ahead});
}

}  // namespace
}  // namespace safety_control_cloud

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s DECIDE GUARD\n", argv[0]);
    return EXIT_FAILURE;
  }
  safety_control_cloud::write_all(argv[1]);
  safety_control_cloud::write_all_of_guard(argv[2]);
  return EXIT_SUCCESS;
}
