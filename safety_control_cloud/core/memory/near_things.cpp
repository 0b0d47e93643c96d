// SPDX-License-Identifier: BSD-3-Clause
#include "near_things.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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
constexpr float border = 0.03f;         // [m] within the corridor's sides
constexpr double sparse_weight = 0.25;  // [m2] as of a pixel half a metre away

/// Which of some pixels are connected.
class Union {
 public:
  explicit Union(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

 private:
  std::vector<std::size_t> parent_;
};

class Finding {
 public:
  explicit Finding(const NearSearch& search)
      : search_(search), found_(near_pixels(search)), connected_(found_.pixels.size()) {}

  std::vector<Thing> things() {
    connect();
    std::vector<std::size_t> number(found_.pixels.size(), none);
    std::vector<std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < number.size(); ++i) {
      const std::size_t root = connected_.root(i);
      if (number[root] == none) {
        number[root] = members.size();
        members.emplace_back();
      }
      members[number[root]].push_back(i);
    }
    std::vector<Thing> things;
    for (const auto& some : members) {
      if (!is_enough(some)) continue;
      things.push_back(thing_of(some));
    }
    return things;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// With what lies to the left of each pixel, and above it.
  void connect() {
    const auto& pixels = found_.pixels;
    left_.assign(pixels.size(), false), right_ = above_ = below_ = left_;
    std::array<std::vector<std::size_t>, gap + 1> lines;  // the latest
    lines.fill(std::vector<std::size_t>(found_.slots, none));
    std::size_t line = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (i == 0 || pixels[i].line != line) {
        line = pixels[i].line;
        std::fill(lines[line % lines.size()].begin(), lines[line % lines.size()].end(), none);
      }
      for (std::size_t j = i; j-- > 0 && pixels[j].line == line && pixels[j].slot + gap >= pixels[i].slot;) {
        if (!try_join(i, j)) continue;
        left_[i] = right_[j] = true;
        break;
      }
      lines[line % lines.size()][pixels[i].slot] = i;
      for (std::size_t up = 1; up <= std::min(gap, line); ++up) {
        if (connect_up(i, lines[(line - up) % lines.size()], line - up)) break;
      }
    }
  }

  /// Whether something in this line is the same thing.
  bool connect_up(std::size_t i, const std::vector<std::size_t>& line, std::size_t number) {
    const auto& pixel = found_.pixels[i];
    if (found_.rows[pixel.line] - found_.rows[number] > gap * found_.row_step) return false;
    const std::size_t j = line[pixel.slot];
    if (j != none && try_join(i, j)) {
      above_[i] = below_[j] = true;
      return true;
    }
    const auto joins = [&](std::size_t slot) { return line[slot] != none && try_join(i, line[slot]); };
    const bool left = pixel.slot > 0 && joins(pixel.slot - std::size_t{1});
    const bool right = pixel.slot + std::size_t{1} < line.size() && joins(pixel.slot + std::size_t{1});
    return left || right;
  }

  bool try_join(std::size_t i, std::size_t j) {
    if (std::abs(found_.pixels[i].ahead - found_.pixels[j].ahead) > jump) return false;
    connected_.join(i, j);
    return true;
  }

  /// A few pixels are told from noise by those around them, of which the search has left some out.
  bool is_enough(const std::vector<std::size_t>& some) const {
    std::size_t pixels = some.size();
    if (pixels >= search_.least_pixels) return true;
    for (const std::size_t i : some) pixels = std::max<std::size_t>(pixels, around(found_.pixels[i], jump));
    return pixels >= search_.least_pixels;
  }

  /// How many of the 3 x 3 pixels around one return, at a range that differs by less than this [m].
  std::uint8_t around(const NearPixel& pixel, float difference) const {
    std::uint8_t count = 0;
    for (std::ptrdiff_t i = -1; i <= 1; ++i) {
      for (std::ptrdiff_t j = -1; j <= 1; ++j) {
        const Point point = search_.picture.near(pixel.row + i, pixel.column + j);
        count = static_cast<std::uint8_t>(count + (std::abs(point.z - pixel.point.z) <= difference));
      }
    }
    return count;
  }

  bool is_inner(std::size_t i) const { return left_[i] && right_[i] && above_[i] && below_[i]; }

  Thing thing_of(const std::vector<std::size_t>& some) const {
    Thing thing;
    thing.nearest = std::numeric_limits<float>::infinity();
    std::vector<std::size_t> lowest(found_.slots, none);
    const std::size_t pixels_each = found_.row_step * found_.column_step;
    thing.pixels = some.size() * pixels_each;
    thing.is_slight = search_.least_pixels > 1 && thing.pixels < few_pixels;
    for (const std::size_t i : some) {
      const NearPixel& pixel = found_.pixels[i];
      thing.nearest = std::min(thing.nearest, pixel.ahead);
      thing.size += search_.sparse ? sparse_weight : double{pixel.ahead} * pixel.ahead;
      thing.at_border = thing.at_border || is_at_border(pixel);
      lowest[pixel.slot] = i;  // they come row by row
    }
    for (const std::size_t i : lowest) {
      if (i != none) thing.feet.push_back({found_.pixels[i].row, found_.pixels[i].column, found_.pixels[i].ahead});
    }
    const auto width = static_cast<double>(search_.picture.width());
    thing.size *=
        static_cast<double>(pixels_each) / (width * width);  // but for the camera's angle, which is always the same
    std::vector<std::size_t> chosen;
    std::copy_if(some.begin(), some.end(), std::back_inserter(chosen), [this](std::size_t i) { return is_inner(i); });
    if (chosen.empty()) chosen = some;
    const std::size_t step = 1 + chosen.size() / most_spots;
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
  Union connected_;
  std::vector<char> left_, right_, above_, below_;
};

}  // namespace

std::vector<Thing> near_things(const NearSearch& search) { return Finding(search).things(); }

}  // namespace safety_control_cloud
