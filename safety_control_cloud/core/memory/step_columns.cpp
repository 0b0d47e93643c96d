// SPDX-License-Identifier: BSD-3-Clause
#include "step_columns.hpp"

#include <utility>

namespace safety_control_cloud {
namespace {

/// By which the heights of two pixels of the same ground may differ [mm].
constexpr std::int16_t same_ground = 15;

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
  Millimetres* const row = row_.data() + 1;
  const std::size_t width = lowest_.size();
  for (std::size_t i = 0; i < width; ++i) row[i] = ground_now(codes[i]);
  lines::note_steps(row, row_below_.data() + 1, kept, width, number, {same_ground, step_height},
                    {lowest_.data(), lowest_row_.data(), above_.data(), first_above_.data()});
}

}  // namespace safety_control_cloud
