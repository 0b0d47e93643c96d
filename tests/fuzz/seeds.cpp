// SPDX-License-Identifier: BSD-3-Clause
// Writes the fuzzer's seeds into a folder: seeds FOLDER. Every contradiction of the table, and robots that drive, stop,
// lose sight of something near and find the floor again.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "../core/input/malformed_clouds.hpp"
#include "../core/scene.hpp"
#include "scenario.hpp"

namespace safety_control_cloud {
namespace {

using Steps = std::vector<Step>;

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

void write(const std::string& path, const Choice& choice, Steps steps) {
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
    write(folder + "/" + malformed.name, defaults, {free, claims(malformed.cloud()), free});
  }
  Step unorganised = claims(well_formed_cloud());
  unorganised.claims.height = 1, unorganised.claims.width = 6, unorganised.claims.row_step = 96;
  write(folder + "/Unorganised", defaults, {unorganised, free, unorganised});
  write(folder + "/Drive", defaults, {free, wall, near, free, event(Event::Quiet, 100), event(Event::Quiet, 600)});
  write(folder + "/NearLoss", defaults, {near, lost, lost, free});
  const Step kerb = picture(Scene({{0.72f, -0.2f, 0.2f, 0.22f, floor_y}})),
             nearer = picture(Scene({{0.64f, -0.2f, 0.2f, 0.22f, floor_y}}));
  write(folder + "/LowObstacle", defaults, {free, kerb, nearer, nearer, free});
  write(folder + "/Restart", defaults,
        {free, near, lost, event(Event::Restart, 0), lost, free, event(Event::Restart, 0)});
  Step commander = event(Event::Outside, 10), nobody = commander;
  commander.source = 1;
  write(folder + "/Outside", defaults, {free, commander, free, nobody, free});
  Step another = free;
  another.source = 3;
  write(folder + "/TwoSources", defaults, {free, another, free, another, free});
  write(folder + "/Lone", defaults, {lone(0.5f), lone(0.0f), lone(0.0f), event(Event::Restart, 0), lone(0.0f)});
  write(folder + "/NearLossForgotten", defaults, {near, lost, event(Event::Forget, 0), lost});
  Choice frozen;
  frozen.frozen_clouds = 1;
  write(folder + "/Frozen", frozen, {free, free, free, near});
  Step infinite = free;
  infinite.bytes[0] = 2;
  write(folder + "/NoReturnInTwoWays", frozen, {free, infinite, free, infinite});
  Choice in_frame;
  in_frame.target_frame = 1;
  write(folder + "/TargetFrame", in_frame, {in_base(free), in_base(near), in_base(lost), in_base(free)});
  Choice patient;
  patient.min_points = patient.release_clouds = patient.release_time = 1;
  Step other = event(Event::Settings, 0);
  other.choice = patient;
  write(folder + "/OtherSettings", defaults, {free, other, near, wall, free, free});
}

}  // namespace
}  // namespace safety_control_cloud

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return EXIT_FAILURE;
  }
  safety_control_cloud::write_all(argv[1]);
  return EXIT_SUCCESS;
}
