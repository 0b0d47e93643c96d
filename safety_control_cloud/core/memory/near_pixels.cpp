// SPDX-License-Identifier: BSD-3-Clause
#include "near_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/lines.hpp"

namespace safety_control_cloud {
namespace {

/// So many columns, and of many near rows so many, show every thing that is not thin.
constexpr std::size_t most_slots = 160;
constexpr std::size_t enough_rows = 24;
/// Where the nearest lies so much nearer than what was looked at, there is something else.
constexpr float same = 0.93f;
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

class Lines {
 public:
  explicit Lines(const NearSearch& search) : search_(search), camera_(search.outlook.camera()) {
    found_.column_step = std::max<std::size_t>(1, search.picture.width() / most_slots);
    found_.slots = (search.picture.width() + found_.column_step - 1) / found_.column_step;
    columns_.resize(found_.slots);
    for (std::size_t i = 0; i < found_.slots; ++i) columns_[i] = static_cast<std::uint16_t>(i * found_.column_step);
  }

  NearPixels all() {
    const auto& nearest = search_.nearest_in_row;
    const std::size_t near_rows = count_near(nearest);
    if (near_rows == 0) return std::move(found_);
    found_.row_step = std::max<std::size_t>(1, near_rows / enough_rows);
    reserve(std::min(near_rows, 2 * enough_rows));
    std::size_t since = found_.row_step;
    float last = 0.0f;
    for (std::size_t row = 0; row < nearest.size(); ++row, ++since) {
      if (!is_near(nearest[row] - camera_.z)) continue;
      const bool same_as_before = nearest[row] > same * last && last > same * nearest[row];
      if (since < found_.row_step && same_as_before) continue;
      since = 0;
      last = nearest[row];
      take(row);
    }
    return std::move(found_);
  }

 private:
  bool is_near(float ahead) const { return (ahead > 0.0f) & (ahead < search_.distance); }

  /// In numbers as wide as what they count, of which a vector holds as many.
  std::size_t count_near(const std::vector<float>& rows) const {
    std::uint32_t count = 0;
    for (const float z : rows) count += is_near(z - camera_.z) ? 1u : 0u;
    return count;
  }

  void take(std::size_t row) {
    const std::size_t line = found_.ahead.size();
    resize(line + found_.slots);
    std::copy(columns_.begin(), columns_.end(), found_.column.begin() + static_cast<std::ptrdiff_t>(line));
    float nearest = look(row, found_.column_step, found_.ahead.data() + line);
    if (row + found_.row_step < search_.picture.height())
      search_.picture.fetch_row(row + found_.row_step, found_.column_step);  // most likely the next one
    std::copy(places_.x.begin(), places_.x.end(), found_.x.begin() + static_cast<std::ptrdiff_t>(line));
    std::copy(places_.y.begin(), places_.y.end(), found_.y.begin() + static_cast<std::ptrdiff_t>(line));
    if (nearest * same > search_.nearest_in_row[row] - camera_.z) nearest = take_whole(row, line);
    if (nearest < std::numeric_limits<float>::infinity()) {
      found_.rows.push_back(row);
    } else {
      resize(line);
    }
  }

  void reserve(std::size_t rows) {
    for (auto* values : {&found_.ahead, &found_.x, &found_.y}) values->reserve(rows * found_.slots);
    found_.column.reserve(rows * found_.slots);
    found_.rows.reserve(rows);
  }

  void resize(std::size_t size) {
    for (auto* values : {&found_.ahead, &found_.x, &found_.y}) values->resize(size);
    found_.column.resize(size);
  }

  /// Of a slot's pixels the nearest; of all too.
  float take_whole(std::size_t row, std::size_t line) {
    ahead_.resize(search_.picture.width());
    const float nearest = look(row, 1, ahead_.data());
    std::fill_n(found_.ahead.begin() + static_cast<std::ptrdiff_t>(line), found_.slots, nothing);
    for (std::size_t column = 0; column < ahead_.size(); ++column) {
      const std::size_t i = line + column / found_.column_step;
      if (!(ahead_[column] < found_.ahead[i]) && !(std::isnan(found_.ahead[i]) && !std::isnan(ahead_[column])))
        continue;
      found_.ahead[i] = ahead_[column];
      found_.column[i] = static_cast<std::uint16_t>(column);
      found_.x[i] = places_.x[column], found_.y[i] = places_.y[column];
    }
    return nearest;
  }

  /// How far ahead every `step`-th pixel of a row is, if it is near and in the corridor; the nearest.
  float look(std::size_t row, std::size_t step, float* ahead) {
    search_.picture.read(row, step, search_.outlook, places_);
    return lines::find_near(places_.pixels(), {search_.outlook.corridor, camera_, search_.distance}, ahead);
  }

  const NearSearch& search_;
  const Point camera_;
  PixelRow places_;                     ///< of one row
  std::vector<float> ahead_;            ///< of a whole one
  std::vector<std::uint16_t> columns_;  ///< of the slots of a line
  NearPixels found_;
};

}  // namespace

NearPixels near_pixels(const NearSearch& search) { return Lines(search).all(); }

}  // namespace safety_control_cloud
