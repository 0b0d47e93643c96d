// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/doubt/cause.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace safety_control_cloud {
namespace {

TEST(Cause, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int number = 0; number <= 20; ++number) names.insert(name_of(static_cast<Cause>(number)));
  EXPECT_EQ(names.size(), std::size_t{21});
  EXPECT_EQ(names.count("UNKNOWN"), std::size_t{0});
}

TEST(Cause, OneThatDoesNotExistIsSaidToBeUnknown) { EXPECT_STREQ(name_of(static_cast<Cause>(21)), "UNKNOWN"); }

/// As SafetyState.msg has them: bags keep the numbers.
TEST(Cause, NumbersStay) {
  EXPECT_STREQ(name_of(static_cast<Cause>(0)), "SEEN");
  EXPECT_STREQ(name_of(static_cast<Cause>(8)), "NEAR_LOSS");
  EXPECT_STREQ(name_of(static_cast<Cause>(17)), "BAD_COMMAND");
  EXPECT_STREQ(name_of(static_cast<Cause>(18)), "NO_ODOMETRY");
  EXPECT_STREQ(name_of(static_cast<Cause>(20)), "CLIFF");
}

}  // namespace
}  // namespace safety_control_cloud
