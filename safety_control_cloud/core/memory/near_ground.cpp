// SPDX-License-Identifier: BSD-3-Clause
#include "near_ground.hpp"

#include <algorithm>

namespace safety_control_cloud {
namespace {

/// Behind as many rows without near ground is none: a step is not higher, even if its front does not return.
constexpr std::size_t longest_gap = NearGround::most_rows / 6;
/// Where no near ground is seen, every so-many-th column, and row, shows whether there is any: no post is thinner.
constexpr std::size_t probe = 4;

/// Each of the probes over the columns from it to the next. There is one more than fit whole, if it counts or not.
void spread(const NearGround::Code* probes, std::size_t columns, NearGround::Code* to) {
  const std::size_t whole = columns / probe;
  for (std::size_t i = 0; i < whole; ++i)
    for (std::size_t j = 0; j < probe; ++j) to[i * probe + j] = probes[i];
  std::fill(to + whole * probe, to + columns, probes[whole]);
}

}  // namespace

/// Whether it shows any near ground.
bool NearGround::read_row(const Pixels& picture, const Outlook& outlook, float distance, std::size_t number,
                          Columns which) {
  const bool all = which == Columns::All;
  const std::size_t apart = all ? 1 : probe, step = apart * column_step_, next = number + apart;
  picture.read(picture_row(number), step, outlook, read_);
  if (next < shows_.size()) picture.fetch_row(picture_row(next), step);
  codes_read_.resize(columns_);
  Code* const read = all ? row(number) : codes_read_.data();
  const int highest = lines::find_ground(read_.pixels(), {outlook.corridor, outlook.camera(), distance}, read,
                                         ahead_.data() + number * columns_);
  if (!all) spread(read, columns_, row(number));
  whole_[number] = all;
  shows_[number] = highest >= lines::LeastGround;
  return shows_[number];
}

void NearGround::look_at(const Pixels& picture, const Outlook& outlook, float distance, std::size_t rows_to_read) {
  height_ = picture.height();
  distance_ = distance;
  row_step_ = std::max<std::size_t>(1, height_ / most_rows);
  column_step_ = column_step_of(picture.width());
  columns_ = (picture.width() + column_step_ - 1) / column_step_;
  middle_column_ = picture.framing().middle_column / static_cast<double>(column_step_);
  near_.assign(columns_, false);
  const std::size_t all = (height_ + row_step_ - 1) / row_step_;
  codes_.resize(all * columns_);
  ahead_.resize(all * columns_);
  shows_.assign(all, false);
  whole_.assign(all, false);
  bool begun = false;
  std::size_t gap = 0;
  for (rows_ = 0; rows_ < all && gap < longest_gap; ++rows_) {
    const bool whole = rows_ < rows_to_read || (begun && gap == 0);
    if (!whole && !begun && rows_ % probe > 0) {  // as the row before, unless one behind it shows ground
      std::copy_n(row(rows_ - 1), columns_, row(rows_));
      continue;
    }
    const bool shown = read_row(picture, outlook, distance, rows_, whole ? Columns::All : Columns::Probes);
    for (std::size_t i = begun ? rows_ : rows_ - std::min(rows_, probe - 1); shown && !whole && i <= rows_; ++i) {
      read_row(picture, outlook, distance, i, Columns::All);
    }
    begun = begun || shown;
    gap = begun && !shown ? gap + 1 : 0;
  }
}

}  // namespace safety_control_cloud
