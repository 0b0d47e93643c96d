// SPDX-License-Identifier: BSD-3-Clause
#include "hidden_edges.hpp"

#include <algorithm>
#include <cstddef>

namespace safety_control_cloud {
namespace {

/// Of the columns that are read: 3 mm each of 160, at 0.4 m.
constexpr std::size_t most_columns = 2;
/// A post of 2 cm at 0.4 m, where an Xtion goes blind, takes 1/24 of its 60 degrees.
constexpr std::size_t post_share_of_width = 24;
/// Strays fill it here and there, in no twelfth of the picture's height by more than 1/share.
constexpr std::size_t bands = 12, stray_share = 4;

/// Whether the columns from `first` to before `last` return nothing, but for strays, from the floor up to this row.
bool is_blank(std::size_t first, std::size_t last, std::size_t top, const Ground& ground) {
  const std::size_t lowest = ground.picture.height() - 1, step = ground.near.row_step();
  const std::size_t rows_of_band = std::max<std::size_t>(1, ground.picture.height() / step / bands);
  std::size_t rows = 0, filled = 0;
  for (std::size_t row = lowest; row >= top && row <= lowest; row -= step) {
    for (std::size_t i = first; i < last; ++i)
      filled += returned(ground.picture.at(row, ground.near.picture_column(i)));
    if (++rows < rows_of_band && row >= top + step) continue;
    if (stray_share * filled > rows * (last - first)) return false;
    rows = filled = 0;
  }
  return true;
}

/// Whether something hides the floor, which was seen there before, and all up to this row.
bool is_hidden(std::size_t first, std::size_t last, std::size_t top, const Ground& ground) {
  for (std::size_t i = first; i < last; ++i)
    if (!ground.floor.is_expected(i)) return false;
  return is_blank(first, last, top, ground);
}

bool is_edge(const Thing& thing, const Ground& ground) {
  const std::size_t columns = ground.near.columns(), first = ground.near.column_at(thing.feet.front().column),
                    last = ground.near.column_at(thing.feet.back().column) + 1,
                    post = std::max<std::size_t>(2, columns / post_share_of_width);
  if (last - first > most_columns) return false;
  std::size_t top = ground.picture.height();
  for (const Spot& spot : thing.spots) top = std::min<std::size_t>(top, spot.row);
  for (const std::size_t between : {0u, 1u}) {
    if (last + between + post <= columns && is_hidden(last + between, last + between + post, top, ground)) return true;
    if (first >= between + post && is_hidden(first - between - post, first - between, top, ground)) return true;
  }
  return false;
}

}  // namespace

void note_edges(std::vector<Thing>& things, const Ground& ground, float near) {
  const auto is_near = [near](const Foot& foot) { return foot.ahead < near; };
  for (Thing& thing : things) {
    thing.is_edge =
        !thing.feet.empty() && std::all_of(thing.feet.begin(), thing.feet.end(), is_near) && is_edge(thing, ground);
  }
}

}  // namespace safety_control_cloud
