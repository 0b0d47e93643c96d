// SPDX-License-Identifier: BSD-3-Clause
#include "stand.hpp"

#include <algorithm>

#include "column_below.hpp"

namespace safety_control_cloud {
namespace {

/// The edge of what stands upright leans in the picture, as the robot pitches, by at most this share of its width: what
/// a column shows near the edge reaches the floor in another one.
constexpr std::size_t edge_share = 128;

/// From one column to another, of those that are read.
struct Columns {
  std::size_t first, last;
};

Columns around(std::size_t column, std::size_t edge, const NearGround& ground) {
  return {column - std::min(edge, column), std::min(column + edge, ground.columns() - 1)};
}

/// So many pixels to one side of a foot, `most` at most, show what has it too. `step`: 1 to the right, -1 to the left.
long run(const Foot& foot, long step, long most, const GroundPicture& shown) {
  const auto width = static_cast<long>(shown.picture.width());
  long pixels = 0;
  for (long column = foot.column + step; pixels < most && column >= 0 && column < width; column += step, ++pixels)
    if (!may_be_of(foot, shown.ahead(shown.placed_at(foot.row, static_cast<std::size_t>(column))))) break;
  return pixels;
}

/// Whether the picture shows no more of it at this foot than the edge of something that is itself too near to return.
bool is_edge_at(const Foot& foot, std::size_t edge, const GroundPicture& shown) {
  const auto most = static_cast<long>(shown.ground.picture_column(edge));
  return 1 + run(foot, -1, most, shown) + run(foot, 1, most, shown) <= most;
}

/// By its own column, and of an edge by those beside it.
Stand stand_at(const Foot& foot, std::size_t edge, const GroundPicture& shown) {
  const std::size_t column = shown.ground.column_at(foot.column);
  const Stand own = ColumnBelow(foot, column, shown).stand();
  if (own != Stand::Hangs || !is_edge_at(foot, edge, shown)) return own;
  const Columns beside = around(column, edge, shown.ground);
  for (std::size_t i = beside.first; i <= beside.last; ++i)
    if (ColumnBelow(foot, i, shown).is_hidden()) return Stand::Unseen;
  return own;
}

}  // namespace

void place_on_ground(std::vector<Thing>& things, NearGround& ground, const Pixels& picture, const Outlook& outlook) {
  const std::size_t columns = ground.columns(), edge = std::max<std::size_t>(1, columns / edge_share);
  const std::size_t height = picture.height();
  const GroundPicture shown{ground, picture, outlook};
  // What ends with the picture stands, though it be so thin that the column which is read shows the floor beside it.
  const std::size_t at_the_end = 2 * ground.row_step() + height / blank_share;
  for (Thing& thing : things) {
    std::vector<char> stands(columns, false), unseen(columns, false);
    std::size_t standing = 0, hanging = 0;
    thing.is_edge = !thing.feet.empty();
    for (const Foot& foot : thing.feet) {
      const std::size_t column = ground.column_at(foot.column);
      if (foot.ahead < ground.distance()) ground.note_near(column);
      const Stand stand = foot.row + at_the_end >= height ? Stand::Stands : stand_at(foot, edge, shown);
      thing.is_edge = thing.is_edge && stand != Stand::Hangs && is_edge_at(foot, edge, shown);
      standing += stand == Stand::Stands;
      hanging += stand == Stand::Hangs;
      const Columns beside = around(column, edge, ground);
      for (std::size_t i = beside.first; i <= beside.last; ++i) {
        stands[i] = stands[i] || stand == Stand::Stands;
        unseen[i] = unseen[i] || stand == Stand::Unseen;
      }
    }
    thing.stands = 2 * standing >= thing.feet.size();
    thing.hangs = 2 * hanging > thing.feet.size();
    for (Spot& spot : thing.spots) {
      const std::size_t column = ground.column_at(spot.column);
      const bool juts_out = spot.overhang >= clear_overhang;
      spot.stands = stands[column] && !juts_out;
      spot.foot_unseen = unseen[column] && !juts_out;
    }
  }
}

}  // namespace safety_control_cloud
