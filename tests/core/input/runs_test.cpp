// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/core/input/runs.hpp"

#include <gtest/gtest.h>

#include "cloud_builder.hpp"

namespace safety_control_cloud {
namespace {

CloudView view_in_rows(const std::vector<Xyz>& points, std::size_t height) {
  CloudView view = view_of(points);
  view.width = points.size() / height, view.height = height;
  view.row_step = view.width * sizeof(Xyz);
  return view;
}

std::size_t width_of(const Run& run) { return safety_control_cloud::width_of(run.points); }

/// Every point of the view is in one run, at its place.
void expect_all(const Runs& runs, const CloudView& view) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto run = runs[i];
    EXPECT_EQ(run.first, next);
    EXPECT_LE(width_of(run), Runs::longest);
    const std::size_t row = run.first / view.width, column = run.first % view.width;
    EXPECT_EQ(std::get<CloudView>(run.points).bytes, view.bytes + row * view.row_step + column * view.point_step);
    next += width_of(run);
  }
  EXPECT_EQ(next, view.size());
}

TEST(Runs, RowsWithoutAGapAreCutAsOneUnlessTheyAreToldApart) {
  const std::vector<Xyz> points(3 * 700);
  const CloudView view = view_in_rows(points, 3);
  const Runs joined(view), apart(view, Rows::Apart);
  EXPECT_EQ(joined.size(), std::size_t{3}) << "1024, 1024 and 52";
  EXPECT_EQ(apart.size(), std::size_t{3}) << "700 each";
  EXPECT_EQ(width_of(joined[2]), std::size_t{52});
  EXPECT_EQ(width_of(apart[2]), std::size_t{700});
  expect_all(joined, view);
  expect_all(apart, view);
}

TEST(Runs, RowsWithAGapAreNotJoined) {
  const std::vector<Xyz> points(2 * 1500);
  CloudView view = view_in_rows(points, 2);
  view.width = 1400;
  const Runs runs(view);
  EXPECT_EQ(runs.size(), std::size_t{4}) << "1024 and 376, twice";
  expect_all(runs, view);
}

/// What is read beyond a run's end must lie in the view.
TEST(Runs, OnlyTheLastRunIsNotFollowed) {
  const std::vector<Xyz> points(2 * 1500);
  CloudView view = view_in_rows(points, 2);
  for (const Rows rows : {Rows::Joined, Rows::Apart}) {
    const Runs runs(view, rows);
    for (std::size_t i = 0; i < runs.size(); ++i) EXPECT_EQ(runs[i].followed, i + 1 < runs.size()) << i;
  }
  view.row_step = 0;  // every row is the same one
  const Runs folded(view, Rows::Apart);
  EXPECT_FALSE(folded[1].followed);
}

TEST(Runs, PartOfARunIsFollowedByTheRestOfIt) {
  const std::vector<Xyz> points(10);
  const Runs runs(view_of(points));
  const auto middle = part_of(runs[0], 4, 3), end = part_of(runs[0], 7, 3);
  EXPECT_EQ(middle.first, std::size_t{4});
  EXPECT_TRUE(middle.followed);
  EXPECT_FALSE(end.followed);
}

TEST(Runs, PieceOfAnImageKnowsWhereInTheImageItLies) {
  const std::vector<float> depths(20);
  DepthView image;
  image.bytes = reinterpret_cast<const std::uint8_t*>(depths.data());
  image.width = 5, image.height = 4, image.row_step = 5 * sizeof(float);
  const DepthView piece = piece_of(piece_of(image, 2, 1, 3), 0, 1, 2);
  EXPECT_EQ(piece.first_row, std::size_t{2});
  EXPECT_EQ(piece.first_column, std::size_t{2});
  EXPECT_EQ(piece.bytes, image.bytes + 2 * image.row_step + 2 * sizeof(float));
  EXPECT_EQ(piece.width, std::size_t{2});
  EXPECT_EQ(piece.height, std::size_t{1});
}

TEST(Runs, EmptyViewHasNone) { EXPECT_EQ(Runs(View(CloudView{})).size(), std::size_t{0}); }

}  // namespace
}  // namespace safety_control_cloud
