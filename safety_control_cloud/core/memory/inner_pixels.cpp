// SPDX-License-Identifier: BSD-3-Clause
#include "inner_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "kernel/lines.hpp"

namespace safety_control_cloud {
namespace {

using Index = NearPixels::Index;

constexpr std::size_t thin_run = 4;  // successive pixels of a line: fewer are the corner of something, or noise

/// Lists what is chosen of a thing, in the pixels' order.
class Choice {
 public:
  Choice(const NearPixels& found, const Connected& connected, const Stretches& all)
      : found_(found), touched_(connected.touched().data()), jump_(connected.jump()) {
    std::size_t slots = 0, longest = 0;
    for (const Stretch& some : all) slots += size_of(some), longest = std::max(longest, size_of(some));
    listed_.reset(new Index[slots]);
    inner_.resize(lines::words_for(longest));
    for (const Stretch& some : all) add(some);
  }

  std::vector<Index> all() const {
    return any_inner_ ? std::vector<Index>(listed_.get(), listed_.get() + size_) : std::vector<Index>();
  }

 private:
  /// The inner pixels, and what lies between one and the next.
  void add(const Stretch& some) {
    lines::mark_inner(touched_ + some.begin, size_of(some), inner_.data());
    Index next = some.begin;
    for (std::size_t word = 0; word < lines::words_for(size_of(some)); ++word) {
      const auto first = some.begin + static_cast<Index>(word * lines::in_word);
      for (std::uint64_t marks = inner_[word]; marks != 0; marks &= marks - 1) {
        const Index inner = first + static_cast<Index>(__builtin_ctzll(marks));
        if (inner - next >= thin_run) add_thin(next, inner);
        listed_[size_++] = inner;
        next = inner + 1;
      }
    }
    any_inner_ = any_inner_ || next > some.begin;
    if (some.end - next >= thin_run) add_thin(next, some.end);
  }

  /// Of slots of a line, none of whose pixels is inner; most have too few to be looked around.
  void add_thin(Index begin, Index end) {
    std::size_t pixels = 0;
    for (Index i = begin; i < end; ++i) pixels += found_.has_pixel(i);
    if (pixels >= thin_run) add_far_from_inner(begin, end);
  }

  /// Those that do not border on inner ones either, where enough follow one another.
  void add_far_from_inner(Index begin, Index end) {
    const auto slots = static_cast<Index>(found_.slots);
    const std::size_t line = found_.line_of(begin);
    const Index first = static_cast<Index>(line) * slots, last = first + slots - 1;
    const Index up = line > 0 ? slots : 0, down = line + 1 < found_.rows.size() ? slots : 0;
    std::size_t run = 0;
    const auto end_run = [&] {
      if (run < thin_run) size_ -= run;
      run = 0;
    };
    for (Index i = begin; i < end; ++i) {
      if (!found_.has_pixel(i)) continue;
      if (is_beside_inner(i, i > first ? 1 : 0, i < last ? 1 : 0, up, down)) {
        end_run();
      } else {
        listed_[size_++] = i;
        ++run;
      }
    }
    end_run();
  }

  /// To the left, to the right, up and down it is so far to the next slot; 0 where there is none. Straight up and down
  /// are asked first: beside the uppermost and the lowest pixels of a thing, which are the most, inner ones lie there.
  bool is_beside_inner(Index i, Index left, Index right, Index up, Index down) const {
    const float ahead = found_.ahead[i];
    const auto is_one = [&](Index other) {
      return touched_[other] == lines::AllSides && std::abs(found_.ahead[other] - ahead) <= jump_;
    };
    return is_one(i - up) || is_one(i + down) || is_one(i - left) || is_one(i + right) || is_one(i - up - left) ||
           is_one(i - up + right) || is_one(i + down - left) || is_one(i + down + right);
  }

  const NearPixels& found_;
  const std::uint8_t* const touched_;
  const float jump_;
  std::vector<std::uint64_t> inner_;  ///< of the slots of one stretch
  std::unique_ptr<Index[]> listed_;
  std::size_t size_ = 0;
  bool any_inner_ = false;
};

}  // namespace

std::vector<Index> pixels_of(const NearPixels& found, const Stretches& all) {
  std::vector<Index> pixels;
  for (const Stretch& some : all)
    for (Index i = some.begin; i < some.end; ++i)
      if (found.has_pixel(i)) pixels.push_back(i);
  return pixels;
}

std::vector<Index> inner_and_thin(const NearPixels& found, const Connected& connected, const Stretches& all) {
  return Choice(found, connected, all).all();
}

}  // namespace safety_control_cloud
