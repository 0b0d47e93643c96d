// SPDX-License-Identifier: BSD-3-Clause
// What a point costs that is asked when it will be touched, and what a command costs before a thousand of them.
#include <benchmark/benchmark.h>

#include <random>

#include "../../safety_control_cloud/core/speed/limit.hpp"

namespace safety_control_cloud {
namespace {

Outline rectangle() { return Outline({{{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}}, 0.0, 0.05}); }

std::vector<Point2> random_points(std::size_t count, double extent) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-extent, extent);
  std::vector<Point2> points(count);
  for (Point2& point : points) point = {anywhere(random), anywhere(random)};
  return points;
}

/// `extent`: within 1 m nearly every point is in the way, within 5 m nearly none.
void time_to_contact_of_a_point(benchmark::State& state) {
  const Sweep sweep(rectangle(), {0.5, 0.0, 0.5});
  const std::vector<Point2> points = random_points(1000, static_cast<double>(state.range(0)));
  for (auto _ : state) {
    for (const Point2& point : points) benchmark::DoNotOptimize(sweep.time_to_contact(point));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(time_to_contact_of_a_point)->ArgName("extent_m")->Arg(1)->Arg(5);

void a_sweep_is_made(benchmark::State& state) {
  const Outline outline = rectangle();
  for (auto _ : state) benchmark::DoNotOptimize(Sweep(outline, {0.5, 0.0, 0.5}));
}
BENCHMARK(a_sweep_is_made);

/// A wall of a thousand points ahead of a robot at a third of its wish: far off all passes, near it is limited.
void a_command_is_limited(benchmark::State& state) {
  Obstacles wall{random_points(1000, 1.0), {}, 0.0};
  for (Point2& point : wall.points) point.x = 0.01 * static_cast<double>(state.range(0)) + 0.01 * point.x;
  const Outline outline = rectangle();
  const Twist2 wanted{0.5, 0.0, 0.5};
  for (auto _ : state)
    benchmark::DoNotOptimize(limit(outline, Law{}, wall, {}, {{limited(wanted, 0.3)}}, wanted).factor);
}
BENCHMARK(a_command_is_limited)->ArgName("wall_cm")->Arg(500)->Arg(60);

}  // namespace
}  // namespace safety_control_cloud

BENCHMARK_MAIN();
