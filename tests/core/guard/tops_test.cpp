// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/guard/tops.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

NearReturn at(double ahead, double left, float height) { return {{ahead, left}, height, 1.0}; }

TEST(Tops, AreThoseOfTheHighestInItsColumnOrBesideThat) {
  const NearReturn foot = at(1.0, 0.0, 0.1f), head = at(1.02, -0.02, 0.4f), other = at(1.1, 0.0, 0.7f);
  Tops tops({foot, head, other});
  EXPECT_EQ(tops.around(foot), 0.4f);
  EXPECT_EQ(tops.around(head), 0.4f);
  EXPECT_EQ(tops.around(other), 0.7f);
}

TEST(Tops, AreTheSameForAllInAColumn) {
  const NearReturn low = at(-1.0, 0.5, 0.0f), high = at(-1.0, 0.5, 0.3f);
  Tops tops({high, low});
  EXPECT_EQ(tops.around(low), 0.3f);
  EXPECT_EQ(tops.around(high), 0.3f);
}

}  // namespace
}  // namespace safety_control_cloud
