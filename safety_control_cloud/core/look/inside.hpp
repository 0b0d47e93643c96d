// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "../input/point_reader.hpp"
#include "../input/runs.hpp"
#include "outlook.hpp"

namespace safety_control_cloud {

/// Some of a run's points: their columns.
struct Chosen {
  const std::uint32_t* columns;
  std::size_t size;
};

/// Calls visit(x, y, z) for these points of a run, in the cloud's frame.
template <class Visit>
void for_each_of(const Chosen& chosen, const Run& run, Visit visit) {
  with_reader(run.points, [&](auto reader) {
    for (std::size_t i = 0; i < chosen.size; ++i) reader(0, chosen.columns[i], visit);
  });
}

/// Calls take(inside, run) for each run of a view, with its points inside the corridor in their order.
void choose_inside(const View& view, const Outlook& outlook,
                   const std::function<void(const Chosen& inside, const Run& run)>& take);

}  // namespace safety_control_cloud
