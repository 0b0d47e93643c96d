// SPDX-License-Identifier: BSD-3-Clause
#include "step_columns.hpp"

#include <cstdlib>
#include <utility>

namespace safety_control_cloud {
namespace {

/// By which the heights of two pixels of the same ground may differ [mm].
constexpr std::int16_t same_ground = 15;

bool is_same_ground(StepColumns::Millimetres one, StepColumns::Millimetres other) {
  return std::abs(one - other) <= same_ground;
}

}  // namespace

void StepColumns::look_at(const NearGround& ground, const std::vector<Millimetres>& kept) {
  const std::size_t columns = ground.columns();
  std::swap(lowest_, lowest_before_);
  std::swap(lowest_row_, lowest_row_before_);
  if (lowest_before_.size() != columns) {
    lowest_before_.assign(columns, none);
    lowest_row_before_.assign(columns, no_row);
  }
  lowest_.assign(columns, none);
  above_.assign(columns, 0);
  for (auto* rows : {&lowest_row_, &first_above_}) rows->assign(columns, no_row);
  for (auto* row : {&row_, &row_below_}) row->assign(columns + 2, none);
  for (std::size_t row = 0; row < ground.rows(); ++row) {
    if (!ground.shows_ground(row)) continue;  // it changes nothing
    look_at_row(static_cast<Row>(row), ground.row(row), kept.data());
  }
}

/// A step that is kept goes on as one while its foot leaves the picture: what is left of it need be no step by itself.
void StepColumns::look_at_row(Row number, const NearGround::Code* codes, const Millimetres* kept) {
  std::swap(row_, row_below_);
  Millimetres *lowest = lowest_.data(), *above = above_.data(), *row = row_.data();
  Row *lowest_row = lowest_row_.data(), *first_above = first_above_.data();
  const Millimetres* const below = row_below_.data();
  const std::size_t width = lowest_.size();
  for (std::size_t i = 0; i < width; ++i) row[i + 1] = ground_now(codes[i]);
  for (std::size_t i = 0; i < width; ++i) {
    const Millimetres ground = row[i + 1];
    const bool is_shown_twice =
        is_same_ground(ground, row[i]) || is_same_ground(ground, row[i + 2]) || is_same_ground(ground, below[i + 1]);
    const bool is_lowest = lowest[i] == none && is_shown_twice && ground != none;
    lowest[i] = is_lowest ? ground : lowest[i];
    lowest_row[i] = is_lowest ? number : lowest_row[i];
    const Millimetres floor = std::max(lowest[i] == none ? Millimetres{0} : lowest[i], kept[i]);
    const bool is_above = is_on_step(ground, floor);
    above[i] = static_cast<Millimetres>(above[i] + is_above);
    first_above[i] = is_above && first_above[i] == no_row ? number : first_above[i];
  }
}

}  // namespace safety_control_cloud
