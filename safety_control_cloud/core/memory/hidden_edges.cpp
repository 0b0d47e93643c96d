// SPDX-License-Identifier: BSD-3-Clause
#include "hidden_edges.hpp"

#include <algorithm>
#include <cstddef>

namespace safety_control_cloud {
namespace {

/// In one column of those that are read, or right beside it.
template <class Fulfils>
bool any_beside(std::size_t column, std::size_t columns, Fulfils fulfils) {
  const std::size_t end = std::min(column + 2, columns);
  for (std::size_t i = column - std::min<std::size_t>(1, column); i < end; ++i)
    if (fulfils(i)) return true;
  return false;
}

/// Whether a column returns nothing, but for strays, from the near floor, which has been seen in it, up to this row.
bool is_hidden(std::size_t column, std::size_t up_to, const Ground& ground) {
  if (!ground.floor.is_hidden(column)) return false;
  const std::size_t step = ground.near.row_step();
  std::size_t blank = 0, rows = 0;
  for (std::size_t row = ground.picture.height() - 1; row > up_to; row -= std::min(row, step), ++rows)
    blank += !returned(ground.picture.at(row, ground.near.picture_column(column)));
  return FloorStrip::is_mostly_blank(blank, rows);
}

void place(Thing& thing, const Ground& ground) {
  const NearGround& near = ground.near;
  const Framing& framing = ground.picture.framing();
  const std::size_t first = near.column_at(framing.left),
                    last = near.column_at(ground.picture.width() - 1 - framing.right);
  std::vector<char> unseen(near.columns(), false);
  std::size_t hidden = 0, outermost = 0;
  for (const Foot& foot : thing.feet) {
    const std::size_t column = near.column_at(foot.column);
    const bool is_edge =
        any_beside(column, near.columns(), [&](std::size_t i) { return is_hidden(i, foot.row, ground); });
    const bool leaves = !is_edge && (column <= first || column >= last);
    unseen[column] = is_edge || leaves;
    hidden += static_cast<std::size_t>(is_edge);
    outermost += static_cast<std::size_t>(leaves);
  }
  thing.is_edge = 2 * hidden > thing.feet.size();
  thing.hangs = thing.hangs && 2 * (hidden + outermost) <= thing.feet.size();
  for (Spot& spot : thing.spots) {
    spot.foot_unseen = spot.foot_unseen || any_beside(near.column_at(spot.column), near.columns(),
                                                      [&](std::size_t i) { return unseen[i] != 0; });
  }
}

}  // namespace

void place_hidden_edges(std::vector<Thing>& things, const Ground& ground) {
  for (Thing& thing : things) place(thing, ground);
}

}  // namespace safety_control_cloud
