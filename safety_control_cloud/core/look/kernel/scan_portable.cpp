// SPDX-License-Identifier: BSD-3-Clause
// scan() in plain C++, for machines where Highway is not installed.
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "../../input/point_reader.hpp"
#include "scan.hpp"

namespace safety_control_cloud {
namespace {

/// A pixel after a point has come, or has not.
std::uint16_t updated(std::uint16_t pixel, const std::optional<Point>& point, const Corridor& corridor,
                      const Gaze& gaze) {
  if (!point) return PixelMemory::code_of(pixel);
  return static_cast<std::uint16_t>(remembered(*point, corridor, gaze) | PixelMemory::now);
}

}  // namespace

Counts scan(const Runs& runs, std::size_t begin, std::size_t end, const Corridor& corridor, const Gaze& gaze,
            float* nearest) {
  Counts counts;
  for (std::size_t i = begin; i < end; ++i) {
    const Run run = runs[i];
    std::uint16_t* pixel = gaze.memory ? gaze.memory->pixels.data() + run.first : nullptr;
    float nearest_of_run = std::numeric_limits<float>::infinity();
    for_each_point(run.points, [&](float x, float y, float z) {
      std::optional<Point> point;
      if (is_return(x, y, z, corridor)) point = placed(x, y, z, gaze);
      const bool inside = point && is_inside(*point, corridor);
      counts.returns += point.has_value();
      counts.inside += inside;
      counts.too_close += is_too_close(x, y, z, corridor, gaze);
      if (inside) nearest_of_run = std::min(nearest_of_run, point->z);
      if (!pixel) return;
      *pixel = updated(*pixel, point, corridor, gaze);
      ++pixel;
    });
    if (gaze.memory) gaze.memory->note(run.first, width_of(run.points));
    nearest[i] = nearest_of_run;
  }
  return counts;
}

Inside inside_of(const Run& run, const Corridor& corridor, const Gaze& gaze) {
  Inside found;
  found.size = 0;
  std::uint32_t column = 0;
  for_each_point(run.points, [&](float x, float y, float z) {
    found.columns[found.size] = column++;
    found.size += is_return(x, y, z, corridor) && is_inside(placed(x, y, z, gaze), corridor);
  });
  return found;
}

std::vector<std::string> instruction_sets() { return {"PORTABLE"}; }

void use_instruction_set(const std::string& name) {
  if (!name.empty() && name != "PORTABLE") throw std::invalid_argument("no instruction set " + name + " in this build");
}

}  // namespace safety_control_cloud
