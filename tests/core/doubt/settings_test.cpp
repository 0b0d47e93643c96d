// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/doubt/settings.hpp"

#include <gtest/gtest.h>

#include "../sentences.hpp"

namespace safety_control_cloud {
namespace {

TEST(DoubtSettings, DefaultsAreFit) { EXPECT_TRUE(problems_of_defaults<DoubtSettings>().empty()); }

TEST(DoubtSettings, EveryContradictionIsNamed) {
  EXPECT_EQ(untold<DoubtSettings>({
                {"source_timeout must", [](DoubtSettings& s) { s.source_timeout = 0.0; }},
                {"min_valid_ratio must", [](DoubtSettings& s) { s.min_valid_ratio = 1.1; }},
                {"min_returns must", [](DoubtSettings& s) { s.min_returns = 0; }},
                {"stamp_tolerance must", [](DoubtSettings& s) { s.stamp_tolerance = -1.0; }},
                {"frozen_clouds must", [](DoubtSettings& s) { s.frozen_clouds = 1; }},
            }),
            std::vector<std::string>{});
}

}  // namespace
}  // namespace safety_control_cloud
