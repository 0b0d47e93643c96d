// SPDX-License-Identifier: BSD-3-Clause
#include "../../safety_control_cloud/ros/parameters.hpp"

#include <gtest/gtest.h>

namespace safety_control_cloud {
namespace {

std::vector<std::string> said_of(const char* argument) {
  const char* const argv[] = {"safety_control_node", argument};
  return parameters_without_underscore(2, argv);
}

TEST(CommandLine, AParameterWithoutItsUnderscoreIsToldFromATopic) {
  const auto sentences = said_of("danger_distance:=0.7");
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("is set by _danger_distance:=0.7"), std::string::npos) << sentences[0];
}

TEST(CommandLine, AParameterWhoseValueWouldDoForATopicIsNoTopicEither) {
  EXPECT_EQ(said_of("input:=depth").size(), 1u);
}

TEST(CommandLine, WhatIsMeantAsItStandsIsLeftAlone) {
  for (const char* argument :
       {"_danger_distance:=0.7", "camera/depth/points:=/front", "output:=/near", "__name:=guard"}) {
    EXPECT_TRUE(said_of(argument).empty()) << argument;
  }
}

}  // namespace
}  // namespace safety_control_cloud
