// SPDX-License-Identifier: BSD-3-Clause
#include "near_things.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "connected.hpp"
#include "inner_pixels.hpp"
#include "kernel/lines.hpp"
#include "near_pixels.hpp"
#include "overhang.hpp"

namespace safety_control_cloud {
namespace {

/// A surface's range changes by less from one pixel to the next that is looked at, and that of another thing by more.
constexpr float jump = 0.06f;  // [m]
/// The picture is asked about at most so many spots of a thing, or nearly so.
constexpr std::size_t most_spots = 120;
/// What is nearest of a thing goes out of sight first: it has as many places of its own, however small it is.
constexpr std::size_t foremost_spots = 12;
constexpr float foremost = 0.02f;       // [m] behind the nearest
constexpr std::size_t few_pixels = 9;   // three by three
constexpr std::size_t few_of = 500;     // of a picture, one in so many are few too
constexpr float border = 0.03f;         // [m] within the corridor's sides
constexpr double sparse_weight = 0.25;  // [m2] as of a pixel half a metre away

std::size_t few_in(const Pixels& picture) { return std::max(few_pixels, picture.width() * picture.height() / few_of); }

using Index = NearPixels::Index;

class Finding {
 public:
  explicit Finding(const NearSearch& search)
      : search_(search),
        camera_(camera_pose_of(search.outlook)),
        found_(near_pixels(search)),
        connected_(found_, jump) {}

  std::vector<Thing> things() const {
    std::vector<Thing> things;
    for (const Stretches& some : connected_.things()) {
      const lines::InSlots all = all_in(some);
      if (is_enough(some, all.pixels)) things.push_back(thing_of(some, all));
    }
    return things;
  }

 private:
  lines::SomeSlots slots_of(const Stretch& some) const {
    return {found_.ahead.data() + some.begin, found_.x.data() + some.begin, found_.y.data() + some.begin,
            size_of(some)};
  }

  lines::InSlots all_in(const Stretches& stretches) const {
    lines::InSlots all;
    for (const Stretch& stretch : stretches) {
      const lines::InSlots some = lines::in_slots(slots_of(stretch), search_.outlook.corridor, border);
      all.pixels += some.pixels;
      all.nearest = std::min(all.nearest, some.nearest);
      all.squares += some.squares;
      all.beside = all.beside || some.beside;
    }
    return all;
  }

  /// A few pixels are told from noise by those around them, of which the search has left some out.
  bool is_enough(const Stretches& all, std::size_t pixels) const {
    if (pixels >= search_.least_pixels) return true;
    for (const Index i : pixels_of(found_, all)) pixels = std::max<std::size_t>(pixels, around(i, jump));
    return pixels >= search_.least_pixels;
  }

  /// How many of the 3 x 3 pixels around one return, at a range that differs by less than this [m].
  std::uint8_t around(Index i, float difference) const {
    const auto ranges = search_.picture.around(found_.row_of(i), found_.column[i]);
    const float range = ranges[ranges.size() / 2];
    std::uint8_t count = 0;
    for (const float z : ranges) count = static_cast<std::uint8_t>(count + (std::abs(z - range) <= difference));
    return count;
  }

  Thing thing_of(const Stretches& some, const lines::InSlots& all) const {
    Thing thing;
    const std::size_t pixels_each = found_.row_step * found_.column_step;
    thing.nearest = all.nearest;
    thing.pixels = all.pixels * pixels_each;
    thing.is_slight = search_.least_pixels > 1 && thing.pixels < few_in(search_.picture);
    thing.at_border = all.beside || std::any_of(some.begin(), some.end(), [this](const Stretch& stretch) {
                        return is_at_border_of_picture(stretch);
                      });
    const auto lowest = lowest_of(some);
    thing.feet = feet_of(lowest);
    const auto width = static_cast<double>(search_.picture.width());
    thing.size = search_.sparse ? sparse_weight * static_cast<double>(all.pixels) : all.squares;
    thing.size *=
        static_cast<double>(pixels_each) / (width * width);  // but for the camera's angle, which is always the same
    thing.spots = spots_of(some, thing, lowest);
    return thing;
  }

  /// Of each slot of a line, that of the thing's lowest pixel there, or `none`.
  std::vector<Index> lowest_of(const Stretches& all) const {
    std::vector<Index> lowest(found_.slots, none);
    for (const Stretch& some : all)  // they come line by line
      lines::note_lowest(slots_of(some), some.begin, lowest.data() + found_.slot_of(some.begin));
    return lowest;
  }

  std::vector<Foot> feet_of(const std::vector<Index>& lowest) const {
    std::vector<Foot> feet;
    for (const Index i : lowest) {
      if (i != none) feet.push_back({static_cast<std::uint16_t>(found_.row_of(i)), found_.column[i], found_.ahead[i]});
    }
    return feet;
  }

  /// Spread over its inner pixels, if it has any, and those of parts too thin to have any; and, if that leaves fewer to
  /// what is foremost, over that by itself. Each stands for as much of the thing as the pixels over which it is spread.
  std::vector<Spot> spots_of(const Stretches& all, const Thing& thing, const std::vector<Index>& lowest) const {
    auto chosen = inner_and_thin(found_, connected_, all);
    if (chosen.empty()) chosen = pixels_of(found_, all);
    const auto is_foremost = [&](Index i) { return found_.ahead[i] < thing.nearest + foremost; };
    std::vector<Index> places = spread(chosen, 1 + chosen.size() / most_spots), front;
    if (static_cast<std::size_t>(std::count_if(places.begin(), places.end(), is_foremost)) < foremost_spots) {
      std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(front), is_foremost);
      places.erase(std::remove_if(places.begin(), places.end(), is_foremost), places.end());
    }
    const double share = thing.size / static_cast<double>(chosen.size());
    std::vector<Spot> spots;
    spots.reserve(places.size() + 2 * foremost_spots);
    const auto add = [&](const std::vector<Index>& some, std::size_t pixels) {
      for (const Index i : some) search_.picture.fetch_around(found_.row_of(i), found_.column[i]);
      for (const Index i : some) {
        spots.push_back(spot_at(i));
        spots.back().overhang = overhang(found_, i, lowest[found_.slot_of(i)]);
        spots.back().share = static_cast<float>(share * static_cast<double>(pixels) / static_cast<double>(some.size()));
      }
    };
    add(spread(front, std::max<std::size_t>(1, front.size() / foremost_spots)), front.size());
    add(places, chosen.size() - front.size());
    return spots;
  }

  /// One of each `step` pixels.
  static std::vector<Index> spread(const std::vector<Index>& pixels, std::size_t step) {
    std::vector<Index> some;
    some.reserve(pixels.size() / step + 1);
    double golden = 0.5;  // of each step: at its middle every time, they might all lie in one column
    for (std::size_t i = 0; i < pixels.size(); i += step) {
      const std::size_t at = i + static_cast<std::size_t>(golden * static_cast<double>(step));
      if (at < pixels.size()) some.push_back(pixels[at]);
      golden += 0.618034;
      if (golden >= 1.0) golden -= 1.0;
    }
    return some;
  }

  Spot spot_at(Index i) const {
    Spot spot;
    spot.row = static_cast<std::uint16_t>(found_.row_of(i)), spot.column = found_.column[i];
    spot.point = search_.picture.at(spot.row, spot.column);
    spot.camera = camera_;
    spot.company = around(i, std::numeric_limits<float>::infinity());
    return spot;
  }

  bool is_at_border_of_picture(const Stretch& some) const {
    const std::size_t row = found_.row_of(some.begin), first = found_.slot_of(some.begin);
    const bool is_at_right = first + size_of(some) == found_.slots && found_.has_pixel(some.end - 1);
    return row <= found_.row_step || first == 0 || is_at_right || row + found_.row_step + 1 >= search_.picture.height();
  }

  static constexpr Index none = std::numeric_limits<Index>::max();

  const NearSearch& search_;
  const CameraPose camera_;
  const NearPixels found_;
  const Connected connected_;
};

}  // namespace

std::vector<Thing> near_things(const NearSearch& search) { return Finding(search).things(); }

}  // namespace safety_control_cloud
