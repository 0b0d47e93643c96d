// SPDX-License-Identifier: BSD-3-Clause
// What the guard takes for a VGA cloud that has just come, and for a command, beside only reading the cloud's bytes.
#include <benchmark/benchmark.h>

#include "../../safety_control_cloud/core/guard_control.hpp"
#include "clouds.hpp"
#include "read_bytes.hpp"

namespace safety_control_cloud {
namespace {

constexpr Placement camera{{{{1, 0, 0, 0}, {0, 1, 0, -0.3f}, {0, 0, 1, 0.1f}}}};  // 0.3 m up, 0.1 m ahead

/// A guard with one camera that sends clouds at 20 Hz, at a robot that stands.
class Guarding {
 public:
  explicit Guarding(const CameraPicture& picture) : picture_(picture), clouds_(picture, true), control_(settings()) {
    for (int i = 0; i < 20; ++i) see();
    want();
  }

  void see() {
    now_ += 0.05;
    const auto view = std::get<CloudView>(view_of(picture_, clouds_.next()));
    control_.see(view, {now_, camera, "camera", "front"}, {now_, now_});
  }
  const Guarded& want() {
    Command wanted;
    wanted.linear[0] = 0.1;
    control_.want(wanted, {now_, now_});
    return control_.answer({now_, now_});
  }

 private:
  static Settings settings() {
    Settings settings;
    settings.mode = Mode::Guard;
    return settings;
  }

  CameraPicture picture_;
  Clouds clouds_;
  GuardControl control_;
  double now_ = 1.0;  ///< [s]
};

void read(benchmark::State& state, const CameraPicture& picture) {
  Clouds clouds(picture, true);
  for (auto _ : state) benchmark::DoNotOptimize(read_bytes(clouds.next(), picture.size()));
}

void see(benchmark::State& state, const CameraPicture& picture) {
  Guarding guarding(picture);
  for (auto _ : state) guarding.see();
}

void answer(benchmark::State& state, const CameraPicture& picture) {
  Guarding guarding(picture);
  for (auto _ : state) benchmark::DoNotOptimize(guarding.want().factor);
}

void add(const std::string& name, void (*run)(benchmark::State&, const CameraPicture&), const CameraPicture& picture) {
  benchmark::RegisterBenchmark(name.c_str(), run, picture)->Unit(benchmark::kMicrosecond);
}

void add_all() {
  for (const std::size_t point_step : {16, 32}) {
    for (const char* scene : {"wall_0.6m", "wall_2m", "mixed"}) {
      const CameraPicture picture{640, 480, point_step, 0.3, scene};
      const std::string what = "/step_" + std::to_string(point_step) + "/" + scene;
      add("read" + what, read, picture);
      add("see" + what, see, picture);
      add("answer" + what, answer, picture);
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
