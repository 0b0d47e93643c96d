// SPDX-License-Identifier: BSD-3-Clause
#include "near_things.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "near_pixels.hpp"

namespace safety_control_cloud {
namespace {

/// Pixels that return nothing, or are mixed of two ranges, do not part a thing: as many slots and lines.
constexpr std::size_t gap = 2;
/// A surface's range changes by less from one pixel to the next that is looked at, and that of another thing by more.
constexpr float jump = 0.06f;  // [m]
/// The picture is asked about at most so many spots of a thing, or nearly so.
constexpr std::size_t most_spots = 120;
constexpr std::size_t few_pixels = 9;   // three by three
constexpr std::size_t few_of = 500;     // of a picture, one in so many are few too
constexpr float border = 0.03f;         // [m] within the corridor's sides
constexpr double sparse_weight = 0.25;  // [m2] as of a pixel half a metre away

using Index = std::uint32_t;  ///< of a pixel among those found

/// Which of some numbers are connected.
class Union {
 public:
  Index add() {
    parent_.push_back(static_cast<Index>(parent_.size()));
    return parent_.back();
  }
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    const Index one = root(a), other = root(b);
    parent_[std::max(one, other)] = std::min(one, other);
  }
  std::size_t size() const { return parent_.size(); }

 private:
  std::vector<Index> parent_;
};

/// Some of the pixels, in their order.
using Members = std::vector<Index>;

class Finding {
 public:
  explicit Finding(const NearSearch& search)
      : search_(search),
        found_(near_pixels(search)),
        few_(std::max(few_pixels, search.picture.width() * search.picture.height() / few_of)) {}

  std::vector<Thing> things() {
    connect();
    std::vector<Thing> things;
    for (const Members& some : connected()) {
      if (is_enough(some)) things.push_back(thing_of(some));
    }
    return things;
  }

 private:
  static constexpr Index none = std::numeric_limits<Index>::max();

  /// Sides on which a pixel touches another one of its thing.
  enum Side : std::uint8_t { Left = 1, Right = 2, Above = 4, Below = 8, All = 15 };

  /// One of the rows that were looked at: of each slot, and of one beside them, the pixel.
  struct Line {
    std::size_t row = 0;
    Members at = {};
  };

  /// With what lies to the left of each pixel, and above it.
  void connect() {
    const std::size_t size = found_.pixels.size();
    touched_.assign(size, 0);
    run_.resize(size);
    ahead_.resize(size);
    for (Index i = 0; i < size; ++i) ahead_[i] = found_.pixels[i].ahead;
    std::array<Line, gap + 1> lines;  // the latest first
    for (Line& line : lines) line.at.assign(found_.slots + 2, none);
    Index end = 0;
    for (Index begin = 0; begin < size; begin = end) {
      std::rotate(lines.begin(), lines.end() - 1, lines.end());
      while (end < size && found_.pixels[end].line == found_.pixels[begin].line) ++end;
      lines[0].row = found_.rows[found_.pixels[begin].line];
      std::fill(lines[0].at.begin(), lines[0].at.end(), none);
      for (Index i = begin; i < end; ++i) connect_left(i, begin);
      for (Index i = begin; i < end; ++i) {
        lines[0].at[found_.pixels[i].slot + std::size_t{1}] = i;
        for (std::size_t up = 1; up <= gap && !connect_up(i, lines[0], lines[up]); ++up) {
        }
      }
    }
  }

  /// What is connected along a line, from `begin` on, is one run, so that runs are joined and not every pixel.
  void connect_left(Index i, Index begin) {
    const auto& pixels = found_.pixels;
    for (Index j = i; j-- > begin && pixels[j].slot + gap >= pixels[i].slot;) {
      if (!go_on(i, j)) continue;
      touched_[i] |= Left, touched_[j] |= Right;
      run_[i] = run_[j];
      return;
    }
    run_[i] = runs_.add();
  }

  /// Whether something in a line above that of a pixel is the same thing.
  bool connect_up(Index i, const Line& own, const Line& line) {
    if (own.row - line.row > gap * found_.row_step) return false;
    const Index* const over = line.at.data() + found_.pixels[i].slot + 1;
    if (try_join(i, over[0])) {
      touched_[i] |= Above, touched_[over[0]] |= Below;
      return true;
    }
    const bool left = try_join(i, over[-1]), right = try_join(i, over[1]);
    return left || right;
  }

  bool go_on(Index i, Index j) const { return std::abs(ahead_[i] - ahead_[j]) <= jump; }

  bool try_join(Index i, Index j) {
    if (j == none || !go_on(i, j)) return false;
    const std::pair<Index, Index> both{run_[i], run_[j]};
    if (both != joined_) runs_.join(both.first, both.second);
    joined_ = both;
    return true;
  }

  /// Those that are one, by the first of each.
  std::vector<Members> connected() {
    std::vector<Index> thing(runs_.size());  // of each run; the first run of a thing is the first to be met
    Index things = 0;
    for (Index run = 0; run < thing.size(); ++run) {
      const Index root = runs_.root(run);
      thing[run] = root == run ? things++ : thing[root];
    }
    std::vector<Index> size(things, 0);
    for (const Index run : run_) ++size[thing[run]];
    std::vector<Members> all(things);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].reserve(size[i]);
    for (Index i = 0; i < run_.size(); ++i) all[thing[run_[i]]].push_back(i);
    return all;
  }

  /// A few pixels are told from noise by those around them, of which the search has left some out.
  bool is_enough(const Members& some) const {
    std::size_t pixels = some.size();
    if (pixels >= search_.least_pixels) return true;
    for (const Index i : some) pixels = std::max<std::size_t>(pixels, around(found_.pixels[i], jump));
    return pixels >= search_.least_pixels;
  }

  /// How many of the 3 x 3 pixels around one return, at a range that differs by less than this [m].
  std::uint8_t around(const NearPixel& pixel, float difference) const {
    std::uint8_t count = 0;
    for (const float z : search_.picture.around(pixel.row, pixel.column)) {
      count = static_cast<std::uint8_t>(count + (std::abs(z - pixel.point.z) <= difference));
    }
    return count;
  }

  Thing thing_of(const Members& some) const {
    Thing thing;
    thing.nearest = std::numeric_limits<float>::infinity();
    Members lowest(found_.slots, none);
    const std::size_t pixels_each = found_.row_step * found_.column_step;
    thing.pixels = some.size() * pixels_each;
    thing.is_slight = search_.least_pixels > 1 && thing.pixels < few_;
    for (const Index i : some) {
      const NearPixel& pixel = found_.pixels[i];
      thing.nearest = std::min(thing.nearest, pixel.ahead);
      thing.size += search_.sparse ? sparse_weight : double{pixel.ahead} * pixel.ahead;
      thing.at_border = thing.at_border || is_at_border(pixel);
      lowest[pixel.slot] = i;  // they come row by row
    }
    for (const Index i : lowest) {
      if (i != none) thing.feet.push_back({found_.pixels[i].row, found_.pixels[i].column, found_.pixels[i].ahead});
    }
    const auto width = static_cast<double>(search_.picture.width());
    thing.size *=
        static_cast<double>(pixels_each) / (width * width);  // but for the camera's angle, which is always the same
    Members chosen;
    chosen.reserve(some.size());
    std::copy_if(some.begin(), some.end(), std::back_inserter(chosen), [this](Index i) { return touched_[i] == All; });
    if (chosen.empty()) chosen = some;
    const std::size_t step = 1 + chosen.size() / most_spots;
    thing.spots.reserve(chosen.size() / step + 1);
    for (std::size_t i = step / 2; i < chosen.size(); i += step)
      thing.spots.push_back(spot_at(found_.pixels[chosen[i]]));
    for (Spot& spot : thing.spots)
      spot.share = static_cast<float>(thing.size / static_cast<double>(thing.spots.size()));
    return thing;
  }

  Spot spot_at(const NearPixel& pixel) const {
    Spot spot;
    spot.row = pixel.row, spot.column = pixel.column;
    spot.point = pixel.point;
    spot.place = placed(pixel.point, search_.outlook);
    spot.company = around(pixel, std::numeric_limits<float>::infinity());
    return spot;
  }

  bool is_at_border(const NearPixel& pixel) const {
    const Corridor& corridor = search_.outlook.corridor;
    const Point place = placed(pixel.point, search_.outlook);
    const bool of_picture = pixel.row <= found_.row_step || pixel.slot == 0 ||
                            pixel.slot + std::size_t{1} == found_.slots ||
                            pixel.row + found_.row_step + 1 >= search_.picture.height();
    return of_picture || place.x < corridor.x_min + border || place.x > corridor.x_max - border ||
           place.y < corridor.y_min + border;
  }

  const NearSearch& search_;
  const NearPixels found_;
  const std::size_t few_;
  std::vector<float> ahead_;  ///< of each pixel
  Union runs_;
  std::vector<Index> run_;                         ///< of each pixel
  std::pair<Index, Index> joined_ = {none, none};  ///< runs, latest
  std::vector<std::uint8_t> touched_;              ///< on which sides
};

}  // namespace

std::vector<Thing> near_things(const NearSearch& search) { return Finding(search).things(); }

}  // namespace safety_control_cloud
