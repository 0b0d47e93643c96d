// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/input/layout.hpp"

#include <gtest/gtest.h>

#include "malformed_clouds.hpp"

namespace safety_control_cloud {
namespace {

class Malformed : public testing::TestWithParam<MalformedCloud> {};

TEST_P(Malformed, CloudIsUnreadableForAReason) {
  const auto [layout, size] = GetParam().cloud();
  const std::vector<std::uint8_t> bytes(size);  // exactly as long as declared here, so that ASan sees a read beyond

  const Reading reading = view_of(layout, bytes.data(), bytes.size());

  ASSERT_TRUE(std::holds_alternative<Unreadable>(reading));
  EXPECT_NE(std::get<Unreadable>(reading).reason.find(GetParam().reason), std::string::npos)
      << std::get<Unreadable>(reading).reason;
}

INSTANTIATE_TEST_SUITE_P(Every, Malformed, testing::ValuesIn(malformed_clouds()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Layout, WellFormedCloudIsReadWhereItsFieldsSay) {
  const auto [layout, size] = well_formed_cloud();
  const std::vector<std::uint8_t> bytes(size);

  const Reading reading = view_of(layout, bytes.data(), bytes.size());

  ASSERT_TRUE(std::holds_alternative<CloudView>(reading)) << std::get<Unreadable>(reading).reason;
  const auto& view = std::get<CloudView>(reading);
  EXPECT_EQ(view.bytes, bytes.data());
  EXPECT_EQ(view.size(), std::size_t{6});
  EXPECT_EQ(view.offset, (std::array<std::size_t, 3>{0, 4, 8}));
  EXPECT_FALSE(view.swapped);
}

TEST(Layout, CloudOfNoPointsIsReadable) {
  auto [layout, size] = well_formed_cloud();
  layout.width = 0;
  layout.row_step = 0;
  EXPECT_TRUE(std::holds_alternative<CloudView>(view_of(layout, nullptr, 0)));
}

TEST(Layout, FourBillionEmptyRowsAreNoRows) {
  auto [layout, size] = well_formed_cloud();
  layout.width = 0;
  layout.height = std::numeric_limits<std::uint32_t>::max();
  layout.row_step = 0;
  EXPECT_EQ(std::get<CloudView>(view_of(layout, nullptr, 0)).height, 0u);
}

TEST(Layout, ForeignFieldsOfAnyTypeDoNotMatter) {
  auto [layout, size] = well_formed_cloud();
  layout.fields.push_back({"intensity", 4000000000u, 77, 0});
  const std::vector<std::uint8_t> bytes(size);
  EXPECT_TRUE(std::holds_alternative<CloudView>(view_of(layout, bytes.data(), bytes.size())));
}

}  // namespace
}  // namespace safety_control_cloud
