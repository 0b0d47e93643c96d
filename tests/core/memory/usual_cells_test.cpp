// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/memory/usual_cells.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace safety_control_cloud {
namespace {

using Cells = std::vector<std::array<float, 3>>;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Of 2 x 3 cells, in which the second and the last return.
Cells picture() {
  Cells cells(6, {nan, nan, nan});
  cells[1] = cells[5] = {0.0f, 0.0f, 1.0f};
  return cells;
}

void note(UsualCells& usual, const Cells& cells, int times, bool anything_near = false) {
  for (int i = 0; i < times; ++i) usual.note(cells, 3, anything_near);
}

TEST(UsualCells, AreAllOnesUntilEnoughFreePicturesHaveCome) {
  UsualCells usual;
  note(usual, picture(), 500, true);
  EXPECT_TRUE(usual.learns());
  EXPECT_FALSE(usual.never_returns(0)) << "something near may hide it";
  note(usual, picture(), 63);
  EXPECT_FALSE(usual.never_returns(0));
  note(usual, picture(), 1);
  EXPECT_FALSE(usual.learns());
  for (const std::size_t cell : {0, 1, 2, 3, 4, 5})
    EXPECT_EQ(usual.never_returns(cell), cell != 1 && cell != 5) << cell;
}

TEST(UsualCells, StayThatWhateverHidesThemLaterAndBecomeItWheneverTheyReturn) {
  UsualCells usual;
  note(usual, picture(), 64);
  note(usual, Cells(6, {nan, nan, nan}), 500);
  EXPECT_FALSE(usual.never_returns(1));
  note(usual, Cells(6, {0.0f, 0.0f, 2.0f}), 16, true);
  EXPECT_FALSE(usual.never_returns(0));
}

TEST(UsualCells, AreNotMadeByStrayReturns) {
  UsualCells usual;
  Cells stray = picture();
  stray[0] = {0.0f, 0.0f, 2.0f};
  for (int i = 0; i < 64; ++i) note(usual, i % 4 == 0 ? stray : picture(), 1);
  EXPECT_TRUE(usual.never_returns(0));
}

TEST(UsualCells, StayWhereTheyAreInALargerGridWhoseNewCellsAreNotKnown) {
  UsualCells usual;
  note(usual, picture(), 64);
  usual.grow({1, 2, 4, 6});
  EXPECT_TRUE(usual.learns());
  EXPECT_TRUE(usual.never_returns(1 * 6 + 2));
  EXPECT_FALSE(usual.never_returns(1 * 6 + 3));
  EXPECT_TRUE(usual.never_returns(2 * 6 + 3));
  EXPECT_FALSE(usual.never_returns(2 * 6 + 4));
  for (const std::size_t cell : {0, 5, 6, 7, 11, 18, 23}) EXPECT_FALSE(usual.never_returns(cell)) << cell;
}

}  // namespace
}  // namespace safety_control_cloud
