// SPDX-License-Identifier: BSD-3-Clause
#include "near_things.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "connected.hpp"
#include "near_pixels.hpp"

namespace safety_control_cloud {
namespace {

/// A surface's range changes by less from one pixel to the next that is looked at, and that of another thing by more.
constexpr float jump = 0.06f;  // [m]
/// The picture is asked about at most so many spots of a thing, or nearly so.
constexpr std::size_t most_spots = 120;
constexpr std::size_t few_pixels = 9;   // three by three
constexpr std::size_t few_of = 500;     // of a picture, one in so many are few too
constexpr float border = 0.03f;         // [m] within the corridor's sides
constexpr double sparse_weight = 0.25;  // [m2] as of a pixel half a metre away

std::size_t few_in(const Pixels& picture) { return std::max(few_pixels, picture.width() * picture.height() / few_of); }

class Finding {
 public:
  explicit Finding(const NearSearch& search)
      : search_(search), axis_(axis_of(search.outlook)), found_(near_pixels(search)), connected_(found_, jump) {}

  std::vector<Thing> things() const {
    std::vector<Thing> things;
    for (const Members& some : connected_.things()) {
      if (is_enough(some)) things.push_back(thing_of(some));
    }
    return things;
  }

 private:
  /// A few pixels are told from noise by those around them, of which the search has left some out.
  bool is_enough(const Members& some) const {
    std::size_t pixels = some.size();
    if (pixels >= search_.least_pixels) return true;
    for (const Index i : some) pixels = std::max<std::size_t>(pixels, around(found_.pixels[i], jump));
    return pixels >= search_.least_pixels;
  }

  /// How many of the 3 x 3 pixels around one return, at a range that differs by less than this [m].
  std::uint8_t around(const NearPixel& pixel, float difference) const {
    const auto ranges = search_.picture.around(pixel.row, pixel.column);
    const float range = ranges[ranges.size() / 2];
    std::uint8_t count = 0;
    for (const float z : ranges) count = static_cast<std::uint8_t>(count + (std::abs(z - range) <= difference));
    return count;
  }

  Thing thing_of(const Members& some) const {
    Thing thing;
    thing.nearest = std::numeric_limits<float>::infinity();
    Members lowest(found_.slots, no_index);
    const std::size_t pixels_each = found_.row_step * found_.column_step;
    thing.pixels = some.size() * pixels_each;
    thing.is_slight = search_.least_pixels > 1 && thing.pixels < few_in(search_.picture);
    for (const Index i : some) {
      const NearPixel& pixel = found_.pixels[i];
      thing.nearest = std::min(thing.nearest, pixel.ahead);
      thing.size += search_.sparse ? sparse_weight : double{pixel.ahead} * pixel.ahead;
      thing.at_border = thing.at_border || is_at_border(pixel);
      lowest[pixel.slot] = i;  // they come row by row
    }
    for (const Index i : lowest) {
      if (i != no_index) thing.feet.push_back({found_.pixels[i].row, found_.pixels[i].column, found_.pixels[i].ahead});
    }
    const auto width = static_cast<double>(search_.picture.width());
    thing.size *=
        static_cast<double>(pixels_each) / (width * width);  // but for the camera's angle, which is always the same
    thing.spots = spots_of(some);
    for (Spot& spot : thing.spots)
      spot.share = static_cast<float>(thing.size / static_cast<double>(thing.spots.size()));
    return thing;
  }

  /// Spread over its inner pixels, if it has any.
  std::vector<Spot> spots_of(const Members& some) const {
    Members inner;
    inner.reserve(some.size());
    std::copy_if(some.begin(), some.end(), std::back_inserter(inner),
                 [this](Index i) { return connected_.is_inner(i); });
    const Members& chosen = inner.empty() ? some : inner;
    const std::size_t step = 1 + chosen.size() / most_spots;
    std::vector<Spot> spots;
    spots.reserve(chosen.size() / step + 1);
    double golden = 0.5;  // of each step: at its middle every time, they might all lie in one column
    for (std::size_t i = 0; i < chosen.size(); i += step, golden = std::fmod(golden + 0.618034, 1.0)) {
      const std::size_t at = i + static_cast<std::size_t>(golden * static_cast<double>(step));
      if (at < chosen.size()) spots.push_back(spot_at(found_.pixels[chosen[at]]));
    }
    return spots;
  }

  Spot spot_at(const NearPixel& pixel) const {
    Spot spot;
    spot.row = pixel.row, spot.column = pixel.column;
    spot.point = search_.picture.at(pixel.row, pixel.column);
    spot.place = placed(spot.point, search_.outlook);
    spot.axis = axis_;
    spot.company = around(pixel, std::numeric_limits<float>::infinity());
    return spot;
  }

  bool is_at_border(const NearPixel& pixel) const {
    const Corridor& corridor = search_.outlook.corridor;
    const bool of_picture = pixel.row <= found_.row_step || pixel.slot == 0 ||
                            pixel.slot + std::size_t{1} == found_.slots ||
                            pixel.row + found_.row_step + 1 >= search_.picture.height();
    return of_picture || pixel.x < corridor.x_min + border || pixel.x > corridor.x_max - border ||
           pixel.y < corridor.y_min + border;
  }

  const NearSearch& search_;
  const Axis axis_;
  const NearPixels found_;
  const Connected connected_;
};

}  // namespace

std::vector<Thing> near_things(const NearSearch& search) { return Finding(search).things(); }

}  // namespace safety_control_cloud
