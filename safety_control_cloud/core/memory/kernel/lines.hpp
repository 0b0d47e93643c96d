// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "../../look/corridor.hpp"
#include "points.hpp"

/// What is asked of all pixels of a row at once, in the vectors of the best instruction set of the machine; the same in
/// all of them.
namespace safety_control_cloud::lines {

using points::PixelsOfRow;

/// Seen from here, in the corridor's axes.
struct Surrounding {
  Corridor corridor;
  Point camera;
  float distance;  ///< [m] ahead of the camera; what is nearer is near
};

/// How far ahead of the camera each of the pixels is [m], if it is near and in the corridor, or else NaN; the nearest
/// of all, or infinity.
float find_near(const PixelsOfRow& pixels, const Surrounding& around, float* ahead);

/// What a pixel shows of the near ground.
enum Ground : std::int16_t {
  ReturnsNothing = -3,
  ReturnsElsewhere = -2,  ///< from farther away or from beside the corridor
  ReturnsNear = -1,       ///< from something near, in the corridor
  LeastGround = 0,        ///< from here on, near ground as many [mm] below the camera
};

/// Of each of the pixels; the greatest. And how far ahead of the camera each of them is, whatever it is [m].
int find_ground(const PixelsOfRow& pixels, const Surrounding& around, std::int16_t* ground, float* ahead);

/// A pixel shows none: deeper than any near ground. And a column shows it in no row.
constexpr std::int16_t no_ground = std::numeric_limits<std::int16_t>::max();
constexpr std::int16_t no_row = no_ground;

/// Of each column, from the lowest row up.
struct StepsSoFar {
  std::int16_t* lowest;       ///< [mm] the lowest ground that two pixels show, side by side or one above the other
  std::int16_t* lowest_row;   ///< in which that is
  std::int16_t* above;        ///< pixels that show ground a step above that, or above what is kept
  std::int16_t* first_above;  ///< the lowest row with one of them
};

/// [mm]
struct StepLimits {
  std::int16_t same_ground;  ///< by which the heights of two pixels of the same ground may differ
  std::int16_t step;         ///< by which a step rises, or more
};

/// One more row of ground, and the one below it; both without anything to either side. `kept` as in StepColumns.
void note_steps(const std::int16_t* row, const std::int16_t* below, const std::int16_t* kept, std::size_t columns,
                std::int16_t number, const StepLimits& limits, const StepsSoFar& steps);

/// A line of slots, and two more to each side in which there is no pixel.
struct LineOfSlots {
  const float* ahead;        ///< [m] of each pixel; NaN where there is none
  const std::uint32_t* run;  ///< of each pixel, and of a slot without one any
};

/// On which sides a pixel touches another one of its thing.
enum Side : std::uint8_t { Left = 1, Right = 2, Above = 4, Below = 8, AllSides = 15 };

/// Where a run of pixels begins that go on from each other in a line.
enum Begin : std::uint8_t {
  Begins = 1,
  GoesOn = 2,  ///< but it is part of the run two slots back, with a pixel of another one between
};

/// Pixels go on from each other whose ranges differ by `jump` [m] at most: in a line each from the nearest to its left,
/// one or two slots away. Into begins[0 ... slots - 1] and touched[0 ... slots - 1]; `back` is what it needs on its
/// way, with two zeros behind the slots.
void go_on_along(const LineOfSlots& line, std::size_t slots, float jump, std::uint8_t* back, std::uint8_t* begins,
                 std::uint8_t* touched);

/// From what a pixel goes on above it, in the line above or else in the next: from what is straight above, or else from
/// what is beside that.
enum Up : std::uint8_t {
  RunAbove = 1,       ///< from the run that is straight above
  RunNext = 2,        ///< from that of the next line
  StraightAbove = 4,  ///< from that very pixel
  StraightNext = 8,
  OtherRun = 16,  ///< from another run, beside
  IsOther = 32,   ///< its run, or one of those straight above, is another than in the slot before
};

/// Of each slot of some lines, on which sides it is.
struct Touched {
  std::uint8_t *line, *above, *next;
};

/// Into up[0 ... slots - 1].
void go_on_up(const LineOfSlots& line, const LineOfSlots& above, const LineOfSlots& next, std::size_t slots, float jump,
              std::uint8_t* up, const Touched& touched);

/// Some slots of a line.
struct SomeSlots {
  const float *ahead, *x, *y;  ///< [m] of their pixels; NaN ahead where there is none
  std::size_t size;
};

/// Of their pixels.
struct InSlots {
  std::size_t pixels = 0;
  float nearest = std::numeric_limits<float>::infinity();  ///< [m] ahead
  double squares = 0.0;                                    ///< [m2] the sum of those of how far they are ahead
  bool beside = false;  ///< any is less far within the corridor than `border` [m] to the left, the right or the top
};

InSlots in_slots(const SomeSlots& some, const Corridor& corridor, float border);

/// Where there is a pixel, its slot is the lowest so far; the first of these is `first`.
void note_lowest(const SomeSlots& some, std::uint32_t first, std::uint32_t* lowest);

/// As many slots as are told of in one word.
constexpr std::size_t in_word = 64;
inline std::size_t words_for(std::size_t slots) { return (slots + in_word - 1) / in_word; }

/// Which slots are touched on all sides: of slot i, bit i % in_word of inner[i / in_word]. Reads whole words of slots,
/// though of those from `size` on it says nothing.
void mark_inner(const std::uint8_t* touched, std::size_t size, std::uint64_t* inner);

}  // namespace safety_control_cloud::lines
