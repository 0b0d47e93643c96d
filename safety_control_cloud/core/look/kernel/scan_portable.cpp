// SPDX-License-Identifier: BSD-3-Clause
// scan() in plain C++, for machines where Highway is not installed.
#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "../../input/point_reader.hpp"
#include "../meaning.hpp"
#include "scan.hpp"

namespace safety_control_cloud {

Counts scan(const Runs& runs, std::size_t begin, std::size_t end, const Outlook& outlook, float* nearest) {
  Counts counts;
  const Corridor& corridor = outlook.corridor;
  for (std::size_t i = begin; i < end; ++i) {
    const Run run = runs[i];
    float nearest_of_run = std::numeric_limits<float>::infinity();
    for_each_point(run.points, [&](float x, float y, float z) {
      std::optional<Point> point;
      if (is_return(x, y, z, corridor)) point = outlook.placed(x, y, z);
      const bool inside = point && is_inside(*point, corridor);
      counts.returns += point.has_value();
      counts.inside += inside;
      counts.too_close += is_too_close(x, y, z, outlook);
      if (inside) nearest_of_run = std::min(nearest_of_run, point->z);
    });
    nearest[i] = nearest_of_run;
  }
  return counts;
}

Inside inside_of(const Run& run, const Outlook& outlook) {
  const Corridor& corridor = outlook.corridor;
  Inside found;
  found.size = 0;
  std::uint32_t column = 0;
  for_each_point(run.points, [&](float x, float y, float z) {
    found.columns[found.size] = column++;
    found.size += is_return(x, y, z, corridor) && is_inside(outlook.placed(x, y, z), corridor);
  });
  return found;
}

std::vector<std::string> instruction_sets() { return {"PORTABLE"}; }

void use_instruction_set(const std::string& name) {
  if (!name.empty() && name != "PORTABLE") throw std::invalid_argument("no instruction set " + name + " in this build");
}

}  // namespace safety_control_cloud
