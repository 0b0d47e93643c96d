// SPDX-License-Identifier: BSD-3-Clause
// What it costs to see the nearest obstacle in a cloud, beside only reading its bytes and beside PCL.
#include <benchmark/benchmark.h>

#include <memory>

#include "clouds.hpp"
#include "look_and_judge.hpp"
#include "read_bytes.hpp"
#include "scene_message.hpp"
#include "tutorial.hpp"

namespace safety_control_cloud {
namespace {

/// The latest ones stay, because the library calls every benchmark several times.
Clouds& clouds_of(const CameraPicture& picture, bool fresh) {
  static std::unique_ptr<Clouds> latest;
  if (!latest || !latest->are(picture, fresh)) {
    latest.reset();
    latest = std::make_unique<Clouds>(picture, fresh);
  }
  return *latest;
}

void read(benchmark::State& state, const CameraPicture& picture, bool fresh) {
  Clouds& clouds = clouds_of(picture, fresh);
  for (auto _ : state) benchmark::DoNotOptimize(read_bytes(clouds.next(), picture.size()));
}

void one_pass(benchmark::State& state, const CameraPicture& picture, bool fresh) {
  Clouds& clouds = clouds_of(picture, fresh);
  for (auto _ : state) benchmark::DoNotOptimize(look(view_of(picture, clouds.next()), Corridor{}));
}

/// Before, every pixel returned once: those that do not now may have lost something near.
void remember(benchmark::State& state, const CameraPicture& picture, const Placement* placement) {
  Clouds& clouds = clouds_of(picture, true);
  NearLoss near_loss{NearLossLimits{}};
  const auto judge = [&](const std::uint8_t* bytes) {
    return look_and_judge(view_of(picture, bytes), near_loss, placement);
  };
  CameraPicture before = picture;
  before.nan_share = 0.0;
  judge(bytes_of(before).data());
  for (auto _ : state) benchmark::DoNotOptimize(judge(clouds.next()));
}

const sensor_msgs::PointCloud2& latest_message_of(const CameraPicture& picture) {
  static CameraPicture shown;
  static sensor_msgs::PointCloud2 latest;
  if (latest.data.empty() || !(shown == picture)) {
    latest = message_of(picture);
    shown = picture;
  }
  return latest;
}

template <auto Look>
void by_pcl(benchmark::State& state, const CameraPicture& picture) {
  const auto& message = latest_message_of(picture);
  for (auto _ : state) benchmark::DoNotOptimize(Look(message));
}

template <class Run>
void add(const std::string& name, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
}

void add_fresh(const CameraPicture& picture, const std::string& what) {
  static const Placement in_another_frame;
  add("read_fresh" + what, [=](benchmark::State& state) { read(state, picture, true); });
  add("one_pass_fresh" + what, [=](benchmark::State& state) { one_pass(state, picture, true); });
  add("near_loss" + what, [=](benchmark::State& state) { remember(state, picture, nullptr); });
  add("near_loss_placed" + what, [=](benchmark::State& state) { remember(state, picture, &in_another_frame); });
}

void add_cloud(const CameraPicture& picture) {
  const std::string what = "/" + std::to_string(picture.width) + "x" + std::to_string(picture.height) + "/step_" +
                           std::to_string(picture.point_step) + "/" + picture.scene + "/nan_" +
                           std::to_string(std::lround(100.0 * picture.nan_share));
  add_fresh(picture, what);
  add("read_cached" + what, [=](benchmark::State& state) { read(state, picture, false); });
  add("one_pass_cached" + what, [=](benchmark::State& state) { one_pass(state, picture, false); });
  add("pcl_indices" + what, [=](benchmark::State& state) { by_pcl<pcl_with_indices>(state, picture); });
  add("tutorial" + what, [=](benchmark::State& state) { by_pcl<tutorial>(state, picture); });
}

/// Depth images, which are no message of the tutorial's.
void add_depths(const std::string& scene, double nan_share) {
  for (const std::size_t pixel_step : {2, 4}) {
    add_fresh({640, 480, pixel_step, nan_share, scene}, "/640x480/depth_" + std::to_string(pixel_step) + "/" + scene);
  }
}

void add_all() {
  for (const char* scene : {"wall_0.6m", "wall_2m", "mixed"}) add_depths(scene, 0.3);
  using Size = std::pair<std::size_t, std::size_t>;
  for (const auto& [width, height] : {Size{320, 240}, Size{640, 480}, Size{1280, 720}, Size{4096, 3072}}) {
    for (const std::size_t point_step : {12, 16, 20, 32}) {
      for (const char* scene : {"wall_0.6m", "wall_2m", "mixed"}) {
        for (const double nan_share : {0.0, 0.3}) add_cloud({width, height, point_step, nan_share, scene});
      }
    }
  }
}

}  // namespace
}  // namespace safety_control_cloud

int main(int argc, char** argv) {
  safety_control_cloud::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
