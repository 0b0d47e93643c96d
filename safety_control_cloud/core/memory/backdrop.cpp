// SPDX-License-Identifier: BSD-3-Clause
#include "backdrop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

constexpr std::size_t most_columns = 64, least_step = 3;
/// A picture tells of one in so many rows of the lattice.
constexpr std::size_t rows_apart = 8;
/// Of the 3 x 3 pixels around a place: a hole, strays in it or not.
constexpr std::size_t few = 2;
/// What a place is known for by its latest pictures: each return adds one, each that is missing takes one. Who passes
/// is not taken for what is behind, nor one stray for a return.
constexpr std::int8_t surely = 3, known = 2;
/// So many pictures more, for who comes to stand where nothing has returned is not what is behind.
constexpr std::int8_t surely_blank = -12;
/// Pictures that show something nearer until that is what is behind.
constexpr std::uint8_t nearer_for_good = 3;
/// [m] By so much more or less, and by this share of its range, a return is where it was in the picture before; what
/// changes by more moves, as somebody who walks up does, and is not what is behind.
constexpr float robots_way = 0.08f, noise_share = 0.02f;
/// What goes on beside a hole, a wall that leans or the floor, differs by at most this share.
constexpr float agreement = 0.2f;
/// So many places at the edge of a hole may be neither.
constexpr std::ptrdiff_t edge = 2;

enum Mark : std::uint8_t { InBackdrop = 1, BesideOther = 2 };

bool agree(float range, float behind) { return std::abs(range - behind) <= agreement * behind; }

}  // namespace

/// What a picture shows at a place.
struct Backdrop::Shown {
  std::size_t returns = 0;
  float range = std::numeric_limits<float>::quiet_NaN();  ///< [m] the median

  bool is_hole() const { return returns <= few; }
  bool is_full() const { return returns >= dense; }
};

bool Backdrop::Part::holds(std::size_t row, std::size_t column) const {
  const double at_row = static_cast<double>(row), at_column = static_cast<double>(column);
  return at_row >= first_row && at_row <= last_row && at_column >= first_column && at_column <= last_column;
}

bool Backdrop::Cell::is_known() const { return returns >= known; }

Backdrop::Place Backdrop::place_of(std::size_t cell) const {
  const Point& behind = cells_[cell].behind;
  return {middle(cell / columns_), middle(cell % columns_), behind.x / behind.z, behind.y / behind.z};
}

bool Backdrop::is_seen_from(const CameraPose& camera) const { return show_the_same(camera, camera_); }

Backdrop::Shown Backdrop::shown_at(const Pixels& picture, std::size_t cell) const {
  auto ranges = picture.around(middle(cell / columns_), middle(cell % columns_));
  const auto end = std::remove_if(ranges.begin(), ranges.end(), [](float z) { return std::isnan(z); });
  Shown shown{static_cast<std::size_t>(end - ranges.begin())};
  if (!shown.is_full()) return shown;
  const auto middle = ranges.begin() + static_cast<std::ptrdiff_t>(shown.returns / 2);
  std::nth_element(ranges.begin(), middle, end);
  shown.range = *middle;
  return shown;
}

void Backdrop::note(const Pixels& picture, const CameraPose& camera, const std::vector<Part>& lost) {
  if (!lost.empty() && !is_seen_from(camera)) return;
  const std::size_t step = std::max(least_step, (picture.width() + most_columns - 1) / most_columns);
  const std::size_t columns = picture.width() / step, cells = columns * (picture.height() / step);
  if (cells == 0) return;
  if (step != step_ || columns != columns_ || cells != cells_.size() || !is_seen_from(camera)) {
    step_ = step, columns_ = columns, camera_ = camera;
    cells_.assign(cells, Cell{});
  }
  next_row_ = (next_row_ + 1) % rows_apart;
  const std::size_t rows = cells_.size() / columns_;
  for (std::size_t row = next_row_; row < rows; row += rows_apart) {
    Cell* const cell = &cells_[row * columns_];
    if (row + rows_apart < rows) picture.fetch_row(middle(row + rows_apart), step_, middle(0));
    const std::size_t at_row = middle(row);
    for (std::size_t at = middle(0), i = 0; i < columns_; ++i, at += step_) {
      const auto holds_it = [=](const Part& part) { return part.holds(at_row, at); };
      const bool rests = !lost.empty() && std::any_of(lost.begin(), lost.end(), holds_it);
      note_at(cell[i], picture.at(at_row, at), rests);
    }
  }
}

void Backdrop::note_at(Cell& cell, const Point& point, bool rests) {
  if (rests && cell.returns < 0) return;  // it returned nothing before, and is no hole in anything
  if (!returned(point)) {
    const int least = rests ? 0 : surely_blank;
    if (!rests || !cell.is_known()) cell.returns = static_cast<std::int8_t>(std::max(cell.returns - 1, least));
    return;
  }
  const bool is_nearer = cell.is_known() && point.z < (1.0f - agreement) * cell.behind.z;
  if (is_nearer && (rests || ++cell.nearer_for < nearer_for_good)) return;
  const bool moves = std::abs(point.z - cell.behind.z) > robots_way + noise_share * point.z;
  cell.behind = point;
  if (moves) cell.returns = std::min<std::int8_t>(cell.returns, 0);
  cell.returns = static_cast<std::int8_t>(std::min<int>(cell.returns + 1, surely));
  cell.nearer_for = 0;
}

/// What is seen outward of one end of a hole, against what was behind there, or else behind its `last` known place.
Backdrop::End Backdrop::end_of(const std::vector<Shown>& shown, const Line& line, std::ptrdiff_t at,
                               std::ptrdiff_t outward, std::size_t last) const {
  for (std::ptrdiff_t i = 0; i <= edge; ++i, at += outward) {
    if (at < 0 || at >= static_cast<std::ptrdiff_t>(line.size)) break;
    const std::size_t beside = line[static_cast<std::size_t>(at)];
    if (!shown[beside].is_full()) continue;
    return agree(shown[beside].range, cells_[cells_[beside].is_known() ? beside : last].behind.z) ? End::GoesOn
                                                                                                  : End::Differs;
  }
  return End::Open;
}

void Backdrop::mark_holes(const std::vector<Shown>& shown, const Line& line, std::vector<std::uint8_t>& marks) const {
  for (std::size_t begin = 0, end = 0; begin < line.size; begin = end + 1) {
    std::size_t first = line.size, last = 0;  // that are known
    for (end = begin; end < line.size && shown[line[end]].is_hole(); ++end)
      if (cells_[line[end]].is_known()) first = std::min(first, end), last = end;
    if (first == line.size) continue;
    const End before = end_of(shown, line, static_cast<std::ptrdiff_t>(begin) - 1, -1, line[first]);
    const End after = end_of(shown, line, static_cast<std::ptrdiff_t>(end), 1, line[last]);
    if (before == End::Open && after == End::Open) continue;
    const Mark mark = before == End::Differs || after == End::Differs ? BesideOther : InBackdrop;
    for (std::size_t i = first; i <= last; ++i) marks[line[i]] = static_cast<std::uint8_t>(marks[line[i]] | mark);
  }
}

std::vector<Backdrop::Place> Backdrop::hidden_in(const Pixels& picture) const {
  std::vector<Place> hidden;
  if (cells_.empty()) return hidden;
  std::vector<Shown> shown;
  shown.reserve(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) shown.push_back(shown_at(picture, i));
  std::vector<std::uint8_t> marks(cells_.size(), 0);
  const std::size_t rows = cells_.size() / columns_;
  for (std::size_t row = 0; row < rows; ++row) mark_holes(shown, {row * columns_, 1, columns_}, marks);
  for (std::size_t column = 0; column < columns_; ++column) mark_holes(shown, {column, columns_, rows}, marks);
  const auto is_hole = [&](std::size_t row, std::size_t column) {
    return row < rows && column < columns_ && marks[row * columns_ + column] != 0 &&
           cells_[row * columns_ + column].is_known();
  };
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (marks[i] != InBackdrop || !cells_[i].is_known()) continue;
    const std::size_t row = i / columns_, column = i % columns_;
    // The edge of what never returns, which has moved a little, is thinner.
    const bool is_wide = (is_hole(row, column - 1) || is_hole(row, column + 1)) &&
                         (is_hole(row - 1, column) || is_hole(row + 1, column));
    if (is_wide) hidden.push_back(place_of(i));
  }
  return hidden;
}

}  // namespace safety_control_cloud
