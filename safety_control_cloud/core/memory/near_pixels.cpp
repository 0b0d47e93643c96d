// SPDX-License-Identifier: BSD-3-Clause
#include "near_pixels.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// So many columns, and of many near rows so many, show every thing that is not thin.
constexpr std::size_t most_slots = 160;
constexpr std::size_t enough_rows = 24;
/// Where the nearest lies so much nearer than what was looked at, there is something else.
constexpr float same = 0.93f;

class Lines {
 public:
  explicit Lines(const NearSearch& search) : search_(search), camera_(search.outlook.camera()) {
    found_.column_step = std::max<std::size_t>(1, search.picture.width() / most_slots);
    found_.slots = (search.picture.width() + found_.column_step - 1) / found_.column_step;
  }

  NearPixels all() {
    found_.pixels.reserve(enough_rows * most_slots);
    const auto& nearest = search_.nearest_in_row;
    const std::size_t near_rows = static_cast<std::size_t>(
        std::count_if(nearest.begin(), nearest.end(), [this](float z) { return is_near(z - camera_.z); }));
    found_.row_step = std::max<std::size_t>(1, near_rows / enough_rows);
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

  void take(std::size_t row) {
    const std::size_t begin = found_.pixels.size();
    const float seen = look(row, found_.column_step);
    if (seen * same > search_.nearest_in_row[row] - camera_.z) {
      found_.pixels.resize(begin);
      look(row, 1);
    }
    if (found_.pixels.size() > begin) found_.rows.push_back(row);
  }

  /// Of a slot's pixels the nearest; the nearest of all.
  float look(std::size_t row, std::size_t step) {
    search_.picture.read(row, step, search_.outlook, places_);
    const std::size_t hits = list_hits(), begin = found_.pixels.size();
    NearPixel pixel;
    pixel.row = static_cast<std::uint16_t>(row);
    pixel.line = static_cast<std::uint16_t>(found_.rows.size());
    float nearest = std::numeric_limits<float>::infinity();
    found_.pixels.resize(begin + hits);
    NearPixel* const first = found_.pixels.data() + begin;
    NearPixel* end = first;
    for (std::size_t i = 0; i < hits; ++i) {
      const std::size_t place = hits_[i], column = place * step;
      pixel.column = static_cast<std::uint16_t>(column);
      pixel.slot = static_cast<std::uint16_t>(step > 1 ? place : column / found_.column_step);
      pixel.x = places_.x[place], pixel.y = places_.y[place], pixel.ahead = places_.z[place] - camera_.z;
      nearest = std::min(nearest, pixel.ahead);
      const bool is_new = step > 1 || end == first || end[-1].slot != pixel.slot;
      if (!is_new && !(pixel.ahead < end[-1].ahead)) continue;
      if (is_new) ++end;
      end[-1] = pixel;
    }
    found_.pixels.resize(begin + static_cast<std::size_t>(end - first));
    return nearest;
  }

  /// Which of the places are near, in the corridor: as many. No branch, since which pixels return is as good as random.
  std::size_t list_hits() {
    const std::size_t size = places_.z.size();
    near_.resize(size), hits_.resize(size);
    const float *const x = places_.x.data(), *const y = places_.y.data(), *const z = places_.z.data();
    int* const near = near_.data();
    const Corridor corridor = search_.outlook.corridor;
    const float from = camera_.z, farthest = search_.distance;
    for (std::size_t i = 0; i < size; ++i) {
      const float ahead = z[i] - from;
      near[i] = (ahead > 0.0f) & (ahead < farthest) & (z[i] > 0.0f) & (x[i] >= corridor.x_min) &
                (x[i] <= corridor.x_max) & (y[i] >= corridor.y_min) & (y[i] <= corridor.y_max);
    }
    std::uint32_t* const hits = hits_.data();
    std::size_t count = 0;
    for (std::size_t i = 0; i < size; ++i) {
      hits[count] = static_cast<std::uint32_t>(i);
      count += static_cast<std::size_t>(near[i]);
    }
    return count;
  }

  const NearSearch& search_;
  const Point camera_;
  PixelRow places_;                  ///< of one row
  std::vector<int> near_;            ///< of each, whether it is
  std::vector<std::uint32_t> hits_;  ///< those that are
  NearPixels found_;
};

}  // namespace

NearPixels near_pixels(const NearSearch& search) { return Lines(search).all(); }

}  // namespace safety_control_cloud
