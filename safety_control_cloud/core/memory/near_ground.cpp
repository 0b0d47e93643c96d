// SPDX-License-Identifier: BSD-3-Clause
#include "near_ground.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// Behind as many rows without near ground is none: a step is not higher, even if its front does not return.
constexpr std::size_t longest_gap = NearGround::most_rows / 6;
/// Where no near ground is seen, every so-many-th column, and row, shows whether there is any: no post is thinner.
constexpr std::size_t probe = 4;
/// As much of the picture's height may return nothing between a thing and the floor that it stands on: 1/share.
constexpr std::size_t blank_share = 24;
/// The edge of what stands upright leans in the picture, as the robot pitches, by at most this share of its width: what
/// a column shows near the edge reaches the floor in another one.
constexpr std::size_t edge_share = 128;

}  // namespace

NearGround::Code NearGround::code_of(const Point& point, const Outlook& outlook, const Point& camera,
                                     float distance) const {
  if (!returned(point)) return nothing;
  const Point place = placed(point, outlook);
  const float ahead = place.z - camera.z;
  const Corridor& corridor = outlook.corridor;
  if (!(ahead < distance) || !(place.z > 0.0f) || !corridor.spans(place.x) || !(place.y >= corridor.y_min))
    return elsewhere;
  if (place.y <= corridor.y_max) return near;
  return static_cast<Code>(0.5f + 1000.0f * std::clamp(place.y - camera.y, 0.0f, 30.0f));
}

/// Whether it shows any near ground.
bool NearGround::read_row(const Pixels& picture, const Outlook& outlook, float distance, std::size_t number,
                          std::size_t every) {
  const Point camera = outlook.camera();
  const std::size_t row = picture_row(number);
  Code* codes = this->row(number);
  bool any = false;
  picture.along(row, every * column_step_, [&](std::size_t column, const Point& point) {
    const std::size_t i = column / column_step_;
    const Code code = code_of(point, outlook, camera, distance);
    any = any || code >= 0;
    std::fill(codes + i, codes + std::min(columns_, i + every), code);
  });
  return any;
}

void NearGround::look_at(const Pixels& picture, const Outlook& outlook, float distance) {
  height_ = picture.height();
  distance_ = distance;
  row_step_ = std::max<std::size_t>(1, height_ / most_rows);
  column_step_ = std::max<std::size_t>(1, picture.width() / most_columns);
  columns_ = (picture.width() + column_step_ - 1) / column_step_;
  near_.assign(columns_, false);
  const std::size_t all = (height_ + row_step_ - 1) / row_step_;
  codes_.resize(all * columns_);
  bool begun = false;
  std::size_t gap = 0;
  for (rows_ = 0; rows_ < all && gap < longest_gap; ++rows_) {
    const bool sure = begun && gap == 0;
    if (!begun && rows_ % probe > 0) {  // as the row before, unless one behind it shows ground
      std::copy_n(row(rows_ - 1), columns_, row(rows_));
      continue;
    }
    const bool shown = read_row(picture, outlook, distance, rows_, sure ? 1 : probe);
    for (std::size_t i = begun ? rows_ : rows_ - std::min(rows_, probe - 1); shown && !sure && i <= rows_; ++i) {
      read_row(picture, outlook, distance, i, 1);
    }
    begun = begun || shown;
    gap = begun && !shown ? gap + 1 : 0;
  }
}

/// How a thing with its foot here stands on the floor.
NearGround::Stand NearGround::stand_of(const Foot& foot) const {
  const std::size_t column = column_at(foot.column), most = std::max<std::size_t>(1, height_ / row_step_ / blank_share);
  std::size_t blank = 0;
  bool gap = false;
  for (std::size_t i = 0; i < rows_; ++i) {
    const Code code = row(i)[column];
    if (code == elsewhere) return Stand::Hangs;
    if (code == near) {
      // Lower than its foot, what reaches the floor is another thing.
      if (picture_row(i) > foot.row + 2 * row_step_ + height_ / blank_share) return Stand::Hangs;
      return gap ? Stand::Unseen : Stand::Stands;
    }
    blank = code == nothing ? blank + 1 : 0;
    gap = gap || blank > most;
  }
  return gap ? Stand::Unseen : Stand::Hangs;
}

void NearGround::place(std::vector<Thing>& things) {
  for (Thing& thing : things) {
    std::vector<char> stands(columns_, false), unseen(columns_, false);
    const std::size_t edge = std::max<std::size_t>(1, columns_ / edge_share);
    std::size_t standing = 0;
    for (const Foot& foot : thing.feet) {
      const std::size_t column = column_at(foot.column);
      if (foot.ahead < distance_) near_[column] = true;
      const Stand stand = stand_of(foot);
      standing += stand == Stand::Stands;
      for (std::size_t i = column - std::min(edge, column); i <= std::min(column + edge, columns_ - 1); ++i) {
        stands[i] = stands[i] || stand == Stand::Stands;
        unseen[i] = unseen[i] || stand == Stand::Unseen;
      }
    }
    thing.stands = 2 * standing >= thing.feet.size();
    for (Spot& spot : thing.spots) {
      const std::size_t column = column_at(spot.column);
      spot.stands = stands[column];
      spot.foot_unseen = unseen[column];
    }
  }
}

}  // namespace safety_control_cloud
