// SPDX-License-Identifier: BSD-3-Clause
#include "connected.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace safety_control_cloud {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
constexpr NearPixels::Index no_run = std::numeric_limits<NearPixels::Index>::max();

/// Marks of slots are passed over by the word: most say nothing.
using Word = std::uint64_t;
constexpr std::size_t in_word = sizeof(Word);
constexpr Word in_each(std::uint8_t mark) { return mark * Word{0x0101010101010101}; }

Word word_at(const std::uint8_t* from) {
  Word word;
  std::memcpy(&word, from, sizeof word);
  return word;
}

std::size_t whole_words(std::size_t slots) { return (slots + in_word - 1) / in_word * in_word; }

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the first mark is the least of its word");

/// The first so many marks of a word.
constexpr Word first_of(std::size_t marks) { return (Word{1} << (8 * marks)) - 1; }

/// Which of a word's marks are set.
template <class Do>
void for_each_mark_in(Word marks, const Do& does) {
  while (marks != 0) {
    const auto which = static_cast<std::size_t>(__builtin_ctzll(marks)) / 8;
    marks &= ~(Word{0xff} << (8 * which));
    does(which);
  }
}

}  // namespace

Connected::Connected(const NearPixels& found, float jump)
    : found_(found),
      jump_(jump),
      touched_(found.ahead.size() + lines::in_word, 0),
      back_(found.slots + gap, 0),
      begins_(whole_words(found.slots), 0),
      up_(whole_words(found.slots), 0) {
  connect();
  gather_things();
}

Connected::Line::Line(std::size_t slots) : ahead(slots + 2 * gap, nothing), run(slots + 2 * gap, no_run) {}

void Connected::connect() {
  const std::size_t slots = found_.slots;
  std::array<Line, gap + 1> lines{Line(slots), Line(slots), Line(slots)};  // the latest first
  Line none(slots);
  std::vector<std::uint8_t> untouched(slots);
  none.touched = untouched.data();
  for (std::size_t i = 0; i < found_.rows.size(); ++i) {
    std::rotate(lines.begin(), lines.end() - 1, lines.end());
    const auto begin = static_cast<Index>(i * slots);
    Line& line = lines[0];
    line.row = found_.rows[i];
    line.touched = touched_.data() + begin;
    std::copy_n(found_.ahead.data() + begin, slots, line.ahead.data() + gap);
    connect_along(line, begin);
    const auto is_near = [&](std::size_t up) { return i >= up && line.row - lines[up].row <= gap * found_.row_step; };
    if (is_near(1)) connect_up(line, lines[1], is_near(2) ? lines[2] : none);
  }
}

void Connected::connect_along(Line& line, Index begin) {
  const std::size_t slots = found_.slots;
  lines::go_on_along(line.slots(), slots, jump_, back_.data(), begins_.data(), line.touched);
  Index* const run = line.run.data() + gap;
  std::size_t since = 0;
  Index latest = no_run;
  for (std::size_t first = 0; first < slots; first += in_word) {
    for_each_mark_in(word_at(begins_.data() + first), [&](std::size_t which) {
      const std::size_t i = first + which;
      std::fill(run + since, run + i, latest);
      latest = runs_.add();
      since = i;
      if (begins_[i] & lines::GoesOn) runs_.join(latest, run[i - 2]);
      const Index here = begin + static_cast<Index>(i);
      if (!stretches_.empty()) stretches_.back().end = std::min(stretches_.back().end, here);
      stretches_.push_back({here, begin + static_cast<Index>(slots)});
    });
  }
  std::fill(run + since, run + slots, latest);
}

void Connected::connect_up(Line& line, Line& above, Line& next) {
  lines::go_on_up(line.slots(), above.slots(), next.slots(), found_.slots, jump_, up_.data(),
                  {line.touched, above.touched, next.touched});
  Index run = no_run, run_above = no_run, run_next = no_run;
  Word ups = 0;  // of slots with these
  const auto join = [&] {
    if (ups & in_each(lines::RunAbove)) runs_.join(run, run_above);
    if (ups & in_each(lines::RunNext)) runs_.join(run, run_next);
    ups = 0;
  };
  for (std::size_t first = 0; first < up_.size(); first += in_word) {
    Word some = word_at(up_.data() + first);
    for_each_mark_in(some & in_each(lines::IsOther | lines::OtherRun), [&](std::size_t which) {
      const Word before = some & first_of(which);
      ups |= before;
      some ^= before;
      join();
      const std::size_t at = gap + first + which;
      run = line.run[at], run_above = above.run[at], run_next = next.run[at];
      if (up_[first + which] & lines::OtherRun && !join_aside(line, above, at)) join_aside(line, next, at);
    });
    ups |= some;
  }
  join();
}

/// Whether there was anything to join.
bool Connected::join_aside(const Line& line, const Line& above, std::size_t at) {
  bool any = false;
  for (const std::size_t beside : {at - 1, at + 1}) {
    const bool goes_on = std::abs(line.ahead[at] - above.ahead[beside]) <= jump_;
    if (goes_on) runs_.join(line.run[at], above.run[beside]);
    any = any || goes_on;
  }
  return any;
}

/// Those that are one, by the first run of each, which is the first to be met. Each run is a stretch; those that follow
/// each other in a line are one.
void Connected::gather_things() {
  std::vector<Index> thing(runs_.size());  // of each run
  Index things = 0;
  for (Index run = 0; run < thing.size(); ++run) {
    const Index root = runs_.root(run);
    thing[run] = root == run ? things++ : thing[root];
  }
  things_.resize(things);
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    auto& all = things_[thing[i]];
    const bool goes_on = !all.empty() && all.back().end == stretches_[i].begin && found_.slot_of(all.back().end) > 0;
    if (goes_on) {
      all.back().end = stretches_[i].end;
    } else {
      all.push_back(stretches_[i]);
    }
  }
}

}  // namespace safety_control_cloud
