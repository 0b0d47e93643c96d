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
/// Strays return one by one, at any range; as many rows that are read in which one goes on show something.
constexpr std::size_t no_strays = 3;
constexpr float agreement = 0.15f;  ///< share by which the floor's range changes from one of them to the next

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

std::size_t NearGround::most_blank() const { return std::max<std::size_t>(1, height_ / row_step_ / blank_share); }

float NearGround::ahead_in(std::size_t i, std::size_t column, const Pixels& picture, const Outlook& outlook) const {
  return placed(picture.at(picture_row(i), picture_column(column)), outlook).z - outlook.camera().z;
}

/// Above the ground, only some of the columns have been read.
NearGround::Code NearGround::code_in(std::size_t i, std::size_t column, const Pixels& picture,
                                     const Outlook& outlook) const {
  if (shows_[i]) return row(i)[column];
  const Point place = placed(picture.at(picture_row(i), picture_column(column)), outlook);
  if (!returned(place)) return nothing;
  return outlook.corridor.holds(place) && place.z - outlook.camera().z < distance_ ? near : elsewhere;
}

/// Whether what is seen there may be the thing that has this foot.
bool NearGround::is_of(const Foot& foot, std::size_t i, std::size_t column, const Pixels& picture,
                       const Outlook& outlook) const {
  return std::abs(ahead_in(i, column, picture, outlook) - foot.ahead) <= noise_at(foot.ahead);
}

/// The lowest row in which a thing is seen that has a foot here. Its border, if it is about to be too near, returns
/// here and there alone.
std::size_t NearGround::lowest_of(const Foot& foot, std::size_t column, const Pixels& picture,
                                  const Outlook& outlook) const {
  std::size_t lowest = read_row_at(foot.row), others = 0;
  for (std::size_t i = lowest; i-- > 0 && lowest - i <= most_blank() + 1 && others < no_strays;) {
    const bool same = is_of(foot, i, column, picture, outlook);
    others = same || !returned(picture.at(picture_row(i), picture_column(column))) ? 0 : others + 1;
    if (same) lowest = i;
  }
  return lowest;
}

/// A row below `lowest` in which a column shows a surface, and no ground: rows that follow one another agree, unlike
/// strays.
std::optional<std::size_t> NearGround::surface_below(std::size_t lowest, std::size_t column, const Pixels& picture,
                                                     const Outlook& outlook) const {
  std::size_t adjacent = 0;
  for (std::size_t i = 0; i < std::min(lowest, rows_); ++i) {
    const Code code = row(i)[column];
    adjacent = code == elsewhere || code == near ? adjacent + 1 : 0;
    if (adjacent < no_strays) continue;
    const float ahead = ahead_in(i, column, picture, outlook), before = ahead_in(i - 1, column, picture, outlook);
    if (std::abs(ahead - before) <= agreement * std::min(ahead, before)) return i;
  }
  return std::nullopt;
}

/// Where nothing goes on, but much of what is below `lowest` returns something else than the ground, such a row.
std::optional<std::size_t> NearGround::others_below(std::size_t lowest, const Foot& foot, std::size_t column,
                                                    const Pixels& picture, const Outlook& outlook) const {
  std::size_t blank = 0, others = 0;
  std::optional<std::size_t> other;
  for (std::size_t i = 0; i < std::min(lowest, rows_); ++i) {
    const Code code = code_in(i, column, picture, outlook);
    blank += code == nothing;
    const bool is_other = code == elsewhere || (code == near && !is_of(foot, i, column, picture, outlook));
    others += is_other;
    if (is_other) other = i;
  }
  return 2 * others > blank ? other : std::nullopt;
}

/// How a thing with its foot here stands on the floor. One that ends with the picture does, though it be so thin that
/// the column which is read shows the floor beside it.
NearGround::Stand NearGround::stand_of(const Foot& foot, const Pixels& picture, const Outlook& outlook) const {
  const std::size_t lowest_row = foot.row + 2 * row_step_ + height_ / blank_share;
  if (lowest_row >= height_) return Stand::Stands;
  const std::size_t column = column_at(foot.column);
  const auto is_farther = [&](std::size_t i) {
    return !(ahead_in(i, column, picture, outlook) <= foot.ahead + noise_at(foot.ahead));
  };
  const auto is_near = [&](std::size_t i) { return code_in(i, column, picture, outlook) == near; };
  std::size_t lowest = read_row_at(foot.row);
  auto other = surface_below(lowest, column, picture, outlook);
  if (!other || is_near(*other)) {
    lowest = lowest_of(foot, column, picture, outlook);
    other = surface_below(lowest, column, picture, outlook);
  }
  if (!other) other = others_below(lowest, foot, column, picture, outlook);
  // What reaches the floor below its foot is another thing.
  if (other) return is_near(*other) || is_farther(*other) ? Stand::Hangs : Stand::Unseen;
  std::size_t blank = 0;
  bool gap = false;
  std::optional<std::size_t> ground;  // the farthest
  for (std::size_t i = 0; i < std::min(lowest, rows_); ++i) {
    const Code code = code_in(i, column, picture, outlook);
    if (code >= 0) ground = i;
    blank = code >= 0 || code == near ? 0 : blank + 1;
    gap = gap || blank > most_blank();
  }
  if (!gap && lowest < rows_) return Stand::Stands;
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
