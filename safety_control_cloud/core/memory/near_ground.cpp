// SPDX-License-Identifier: BSD-3-Clause
#include "near_ground.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "evidence.hpp"

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

/// Whether it shows any near ground.
bool NearGround::read_row(const Pixels& picture, const Outlook& outlook, float distance, std::size_t number,
                          Columns which) {
  picture.read(picture_row(number), (which == Columns::All ? 1 : probe) * column_step_, outlook, read_);
  const std::size_t size = read_.z.size();
  codes_read_.resize(size);
  Code* const read = codes_read_.data();
  const int highest = lines::find_ground(read_.pixels(), {outlook.corridor, outlook.camera(), distance}, read);
  Code* const codes = row(number);
  if (which == Columns::All) {
    std::copy(read, read + size, codes);
  } else {
    for (std::size_t i = 0; i < columns_; ++i) codes[i] = read[i / probe];
  }
  shows_[number] = highest >= lines::LeastGround;
  return shows_[number];
}

void NearGround::look_at(const Pixels& picture, const Outlook& outlook, float distance) {
  height_ = picture.height();
  distance_ = distance;
  row_step_ = std::max<std::size_t>(1, height_ / most_rows);
  column_step_ = column_step_of(picture.width());
  columns_ = (picture.width() + column_step_ - 1) / column_step_;
  middle_column_ = picture.framing().middle_column / static_cast<double>(column_step_);
  near_.assign(columns_, false);
  const std::size_t all = (height_ + row_step_ - 1) / row_step_;
  codes_.resize(all * columns_);
  shows_.assign(all, false);
  bool begun = false;
  std::size_t gap = 0;
  for (rows_ = 0; rows_ < all && gap < longest_gap; ++rows_) {
    const bool sure = begun && gap == 0;
    if (!begun && rows_ % probe > 0) {  // as the row before, unless one behind it shows ground
      std::copy_n(row(rows_ - 1), columns_, row(rows_));
      continue;
    }
    const bool shown = read_row(picture, outlook, distance, rows_, sure ? Columns::All : Columns::Probes);
    for (std::size_t i = begun ? rows_ : rows_ - std::min(rows_, probe - 1); shown && !sure && i <= rows_; ++i) {
      read_row(picture, outlook, distance, i, Columns::All);
    }
    begun = begun || shown;
    gap = begun && !shown ? gap + 1 : 0;
  }
}

/// How a thing with its foot here stands on the floor. One that ends with the picture does, though it be so thin that
/// the column which is read shows the floor beside it.
NearGround::Stand NearGround::stand_of(const Foot& foot, const Pixels& picture, const Outlook& outlook) const {
  const std::size_t lowest_row = foot.row + 2 * row_step_ + height_ / blank_share;
  if (lowest_row >= height_) return Stand::Stands;
  const std::size_t column = column_at(foot.column), most = std::max<std::size_t>(1, height_ / row_step_ / blank_share);
  const auto is_farther = [&](std::size_t i) {
    const Point below = placed(picture.at(picture_row(i), picture_column(column)), outlook);
    return !(below.z - outlook.camera().z <= foot.ahead + noise_at(foot.ahead));
  };
  std::size_t blank = 0;
  bool gap = false;
  std::optional<std::size_t> ground;  // the farthest
  for (std::size_t i = 0; i < rows_; ++i) {
    const Code code = row(i)[column];
    if (code == elsewhere) return is_farther(i) ? Stand::Hangs : Stand::Unseen;
    if (code == near) {
      // Lower than its foot, what reaches the floor is another thing.
      if (picture_row(i) > lowest_row) return Stand::Hangs;
      if (!gap) return Stand::Stands;
      break;
    }
    if (code >= 0) ground = i;
    blank = code == nothing ? blank + 1 : 0;
    gap = gap || blank > most;
  }
  return gap && !(ground && is_farther(*ground)) ? Stand::Unseen : Stand::Hangs;
}

void NearGround::place(std::vector<Thing>& things, const Pixels& picture, const Outlook& outlook) {
  for (Thing& thing : things) {
    std::vector<char> stands(columns_, false), unseen(columns_, false);
    const std::size_t edge = std::max<std::size_t>(1, columns_ / edge_share);
    std::size_t standing = 0, hanging = 0;
    for (const Foot& foot : thing.feet) {
      const std::size_t column = column_at(foot.column);
      if (foot.ahead < distance_) near_[column] = true;
      const Stand stand = stand_of(foot, picture, outlook);
      standing += stand == Stand::Stands;
      hanging += stand == Stand::Hangs;
      for (std::size_t i = column - std::min(edge, column); i <= std::min(column + edge, columns_ - 1); ++i) {
        stands[i] = stands[i] || stand == Stand::Stands;
        unseen[i] = unseen[i] || stand == Stand::Unseen;
      }
    }
    thing.stands = 2 * standing >= thing.feet.size();
    thing.hangs = 2 * hanging > thing.feet.size();
    for (Spot& spot : thing.spots) {
      const std::size_t column = column_at(spot.column);
      spot.stands = stands[column];
      spot.foot_unseen = unseen[column];
    }
  }
}

}  // namespace safety_control_cloud
