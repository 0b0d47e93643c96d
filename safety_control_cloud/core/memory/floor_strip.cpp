// SPDX-License-Identifier: BSD-3-Clause
#include "floor_strip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

/// A post of 2 cm at 0.4 m, where an Xtion goes blind, takes 1/24 of its 60 degrees.
constexpr std::size_t post_share_of_width = 24;

/// Cameras leave a border of their pictures empty: at most this share, where no floor was ever seen in it.
constexpr std::size_t border_share_of_width = 8;

/// Stereo cameras have the widest borders, of 4 to 6 % at 0.7 m, and wider ones the nearer all is: in a border as
/// narrow as this share, one look at the floor does not mean that it can always be seen there.
constexpr std::size_t stereo_share_of_width = 16;
constexpr std::uint8_t certain = 3;  ///< clouds that have shown the floor

/// Where the floor is hidden, three pixels in four and more are blank, whatever stray ranges the others return.
constexpr std::size_t enough_pixels = 12;

/// A row's floor rises by this in a cloud in which none is seen as low [mm]: after a bump it is back in a second.
constexpr NearGround::Code forgotten = 1;

/// A border of rows that never return is at most so high.
constexpr std::size_t border_share_of_height = 8;

constexpr float as_high = 0.01f;  ///< [m] for a camera that bumps along with its robot
constexpr int highest = std::numeric_limits<NearGround::Code>::max() - 1;

/// The least code that is still floor in a row; those from it on are the floor, or elsewhere. The floor moves by 2 %
/// when the robot pitches by half a degree; a foot stands out by more than this.
NearGround::Code least_floor(NearGround::Code lowest) { return static_cast<NearGround::Code>((lowest * 19 + 19) / 20); }

std::size_t post_of(std::size_t columns) { return std::max<std::size_t>(2, columns / post_share_of_width); }

}  // namespace

void FloorStrip::move_to(float camera_height) {
  if (!camera_height_) {
    camera_height_ = camera_height;
    std::fill(seen_from_.begin(), seen_from_.end(), camera_height);
  }
  const float up = camera_height - *camera_height_;
  if (std::abs(up) < as_high) return;
  if (!covered().empty())
    for (float& height : seen_from_) height = std::min(height, camera_height);
  camera_height_ = camera_height;
  const auto down = static_cast<int>(std::lround(1000.0f * up));  // [mm] of the floor
  for (Code& lowest : lowest_)
    if (lowest > 0) lowest = static_cast<Code>(std::clamp(lowest + down, 1, highest));
}

void FloorStrip::survey(const NearGround& ground, const Patience& patience) {
  lowest_.resize(std::max(lowest_.size(), ground.rows()), 0);
  seen_from_.resize(lowest_.size(), camera_height_.value_or(0.0f));
  for (auto* counts : {&shown_, &foot_, &blank_}) counts->assign(ground.columns(), 0);
  if (expected_.size() != ground.columns()) {
    expected_.assign(ground.columns(), 0);
    blank_since_.assign(ground.columns(), patience.now);
    blank_lately_.assign(ground.columns(), 0);
    blank_shares_.clear();
    std::fill(lowest_.begin(), lowest_.end(), Code{0});
    std::fill(seen_from_.begin(), seen_from_.end(), camera_height_.value_or(0.0f));
  }
  rows_.clear();
  middle_ = ground.middle_column();
  above_border_ = false;
  Code floor = 0;  // the lowest of all rows so far
  for (std::size_t row = 0; row < ground.rows(); ++row) {
    const Code lowest = learned(ground, row);
    const bool border = floor == 0 && lowest == 0 && row < NearGround::most_rows / border_share_of_height;
    above_border_ = above_border_ || border;
    if (border) continue;
    floor = std::max(floor, lowest);
    if (lowest == 0 || lowest < least_floor(floor)) break;
    count_row(ground, row);
    rows_.push_back(ground.picture_row(row));
  }
  blank_shares_.note(blank_, rows_.size(), post_of(blank_.size()));
  expect(patience);
  note_blank();
}

std::size_t FloorStrip::rows_to_read() const {
  const auto shows_any = [](Code lowest) { return lowest > 0; };
  return static_cast<std::size_t>(std::find_if(lowest_.rbegin(), lowest_.rend(), shows_any).base() - lowest_.begin());
}

/// Of a few columns together, no wider than a post: of fewer pixels, chance blanks too many.
void FloorStrip::note_blank() {
  for (std::uint8_t& clouds : blank_lately_) clouds = static_cast<std::uint8_t>(clouds - (clouds > 0));
  const std::size_t rows = rows_.size(), wide = rows == 0 ? blank_.size() : (enough_pixels + rows - 1) / rows;
  if (wide > post_of(blank_.size())) return;
  std::size_t blank = 0;
  for (std::size_t i = 0; i < blank_.size(); ++i) {
    blank += blank_[i];
    if (i + 1 < wide) continue;
    if (4 * blank >= 3 * wide * rows)
      std::fill_n(blank_lately_.begin() + static_cast<std::ptrdiff_t>(i + 1 - wide), wide, lately);
    blank -= blank_[i + 1 - wide];
  }
}

/// The lowest ground return of a row, as far as it is remembered.
NearGround::Code FloorStrip::learned(const NearGround& ground, std::size_t row) {
  const Code* codes = ground.row(row);
  Code now = 0;
  for (std::size_t i = 3; i < ground.columns(); ++i)  // fewer may be strays, where the floor is too near to return
    now = std::max(now, std::min({codes[i - 3], codes[i - 2], codes[i - 1], codes[i]}));
  Code& lowest = lowest_[row];
  const float height = camera_height_.value_or(0.0f);
  if (now > 0) {  // a blank row speaks against nothing
    seen_from_[row] = lowest > 0 ? std::min(seen_from_[row], height) : height;
    lowest = std::max(now, static_cast<Code>(lowest - forgotten));
  }
  return height > seen_from_[row] - as_high ? lowest : Code{0};
}

void FloorStrip::count_row(const NearGround& ground, std::size_t row) {
  const Code *codes = ground.row(row), floor = least_floor(lowest_[row]);
  for (std::size_t i = 0; i < ground.columns(); ++i) {
    const bool blank = codes[i] == NearGround::nothing;
    const bool seen_past = codes[i] >= floor || codes[i] == NearGround::elsewhere;
    shown_[i] = static_cast<Count>(shown_[i] + seen_past);
    blank_[i] = static_cast<Count>(blank_[i] + blank);
    foot_[i] = static_cast<Count>(foot_[i] + (!blank && !seen_past));
  }
}

bool FloorStrip::shows_floor(std::size_t i) const { return !rows_.empty() && 2 * shown_[i] >= rows_.size(); }

/// Whether columns at a side, of which this is the innermost, may be such as the camera never sees the floor in.
bool FloorStrip::is_border(std::size_t column, std::size_t size) const {
  const std::size_t width = expected_.size();
  if (expected_[column] >= certain || size > width / border_share_of_width) return false;
  return expected_[column] == 0 || size <= width / stereo_share_of_width;
}

/// A gap between floor and floor hides something, even if it was there from the start. So does a border wider than any
/// camera's, and one in which the floor has been seen.
void FloorStrip::expect(const Patience& patience) {
  const std::size_t columns = expected_.size();
  std::size_t left = 0, right = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    if (rows_.empty() || 2 * blank_[i] < rows_.size()) blank_since_[i] = patience.now;
    if (patience.ends(blank_since_[i])) expected_[i] = 0;
  }
  while (left < columns && !shows_floor(left)) ++left;
  while (right < columns - left && !shows_floor(columns - 1 - right)) ++right;
  first_ = 0, last_ = columns;
  bool border = left < columns;
  for (std::size_t i = 0; i < left && border; ++i) border = is_border(i, left);
  if (border) first_ = left;
  border = right < columns;
  for (std::size_t i = 0; i < right && border; ++i) border = is_border(columns - 1 - i, right);
  if (border) last_ = columns - right;
  for (std::size_t i = 0; i < columns; ++i) {
    if (shows_floor(i) && expected_[i] < certain) ++expected_[i];
  }
}

bool FloorStrip::is_seen_again(std::size_t column, bool among_strays) const {
  const auto again = [this](std::size_t i) {
    const auto [shown, hidden] = this->column(i);
    return shown > 0 && 8 * hidden <= shown;
  };
  if (!again(column)) return false;
  const double out = (static_cast<double>(column) - middle_) * 0.25;
  const double least = static_cast<double>(column) + std::min(out, 0.0) - 1.0;
  const double most = static_cast<double>(column) + std::max(out, 0.0) + 1.0;
  const auto begin = std::max(first_, static_cast<std::size_t>(std::max(0.0, std::floor(least))));
  const auto end = std::min(last_, static_cast<std::size_t>(std::ceil(most)) + 1);
  for (std::size_t i = begin; i < end; ++i) {
    if (blank_[i] == rows_.size() || (among_strays && blank_lately_[i] > 0)) return false;
  }
  return true;
}

std::vector<Span> FloorStrip::covered() const {
  std::vector<Span> covered;
  if (rows_.size() < 2) return covered;  // one alone may be a joint between tiles
  const auto columns = static_cast<double>(shown_.size());
  const std::size_t post = post_of(shown_.size());
  const auto blank_in = [this](std::size_t i) {
    return above_border_ && expected_[i] < certain ? 0.0 : blank_shares_[i];
  };
  // A stray return in one of the columns says nothing.
  const double two_rows = 2.0 / (static_cast<double>(rows_.size()) * blank_shares_.clouds());
  const double least = static_cast<double>(post) * std::max(mostly_blank, two_rows);
  double blank = 0.0;  // in as many columns
  for (std::size_t i = first_; i < last_; ++i) {
    blank += blank_in(i);
    if (i < first_ + post - 1) continue;
    if (blank >= least)
      covered.push_back({static_cast<double>(i + 1 - post) / columns, static_cast<double>(i + 1) / columns});
    blank -= blank_in(i + 1 - post);
  }
  return covered;
}

}  // namespace safety_control_cloud
