// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/extents.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

NearReturn at(double ahead, double left, float height) { return {{ahead, left}, height, 1.0}; }

TEST(Extents, AreFromTheLowestToTheHighestInAColumnOrBesideThat) {
  const NearReturn foot = at(1.0, 0.0, 0.1f), head = at(1.02, -0.02, 0.4f), other = at(1.1, 0.0, 0.7f);
  Extents extents({foot, head, other});
  for (const NearReturn& one : {foot, head}) {
    EXPECT_EQ(extents.around(one).bottom, 0.1f);
    EXPECT_EQ(extents.around(one).top, 0.4f);
  }
  EXPECT_EQ(extents.around(other).bottom, 0.7f);
  EXPECT_EQ(extents.around(other).top, 0.7f);
}

TEST(Extents, AreTheSameForAllInAColumn) {
  const NearReturn low = at(-1.0, 0.5, 0.0f), high = at(-1.0, 0.5, 0.3f);
  Extents extents({high, low});
  for (const NearReturn& one : {low, high}) {
    EXPECT_EQ(extents.around(one).bottom, 0.0f);
    EXPECT_EQ(extents.around(one).top, 0.3f);
  }
}

}  // namespace
}  // namespace safety_control_cloud
