// SPDX-License-Identifier: BSD-3-Clause
#include "hidden_floor.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "forgiving.hpp"
#include "turned.hpp"

namespace safety_control_cloud {
namespace {

/// Of a picture as wide as this each column is asked; of one with more, so many.
constexpr std::size_t columns_asked = 80;

/// [rad] What lies so near the border of a picture is not asked for: one that looks a little elsewhere may not show it.
constexpr double border = 1.5 * least_off;

/// Of the picture's width: a thing is remembered in pixels that lie within it.
constexpr double at_its_edge = 0.02;

/// How many of the 3 x 3 pixels around a spot returned, nobody knows: it is seen past where half of them do.
constexpr std::uint8_t half_of_all = 5;

/// What hides the floor may be right before the camera's blind range or much nearer: seen from elsewhere, that is not
/// the same direction. Of two columns one is asked for each.
constexpr float much_nearer = 0.6f;
constexpr int steps = 20;

/// On the ray of a pixel the farthest place, from `near` [m] ahead of the camera on, where what hides the floor is in
/// the robot's way; none if it is nowhere.
std::optional<Point> farthest_in_corridor(double right, double down, const Outlook& outlook, float near) {
  for (int step = steps; step > 0; --step) {
    const float z = near * static_cast<float>(step) / steps;
    const Point seen(static_cast<float>(right) * z, static_cast<float>(down) * z, z);
    if (outlook.corridor.holds(outlook.placed(seen.x, seen.y, seen.z))) return seen;
  }
  return std::nullopt;
}

/// Two of the rows, counted from the lowest up, that do not lie at the border of the picture, if there are any: at a
/// third and at two thirds of them, for at its upper edge a thing is not known to a degree.
std::vector<std::size_t> asked_of(const std::vector<std::size_t>& rows, std::size_t height, double slope) {
  const auto is_inside = [&](std::size_t row) { return static_cast<double>(height - 1 - row) * slope >= border; };
  const auto inside = static_cast<std::size_t>(std::find_if(rows.begin(), rows.end(), is_inside) - rows.begin());
  const std::size_t first = inside < rows.size() ? inside : 0, count = rows.size() - first;
  std::vector<std::size_t> asked{rows[first + count / 3], rows[first + 2 * count / 3]};
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  return asked;
}

std::size_t step_of(std::size_t width) { return std::max<std::size_t>(1, width / columns_asked); }

/// Of the pixels in these columns and in some of the rows, those on whose rays nothing returns.
std::vector<Spot> spots_on_rays(const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns,
                                const Pixels& picture, const Gaze& gaze, float near) {
  std::vector<Spot> spots;
  const RayLine &across = *gaze.rays.across, &down = *gaze.rays.down;
  const auto asked = asked_of(rows, picture.height(), std::abs(down.slope));
  const double high = static_cast<double>(rows.size()) / static_cast<double>(asked.size());  // [px] of each
  const double angle = static_cast<double>(step_of(picture.width())) * high * std::abs(across.slope * down.slope);
  for (const std::size_t row : asked) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::size_t column = columns[i];
      if (returned(picture.at(row, column))) continue;
      const auto at =
          farthest_in_corridor(across.slant(static_cast<double>(column)), down.slant(static_cast<double>(row)),
                               gaze.outlook, i % 2 == 0 ? much_nearer * near : near);
      if (!at) continue;
      Spot spot;
      spot.row = static_cast<std::uint16_t>(row), spot.column = static_cast<std::uint16_t>(column);
      spot.point = *at;
      spot.share = static_cast<float>(angle * double{at->z} * double{at->z});
      spot.company = half_of_all;
      spot.foot_unseen = spot.only_hides = true;
      spot.camera = gaze.camera;
      spots.push_back(spot);
    }
  }
  return spots;
}

bool is_in_any(const std::vector<Span>& spans, double at) {
  return std::any_of(spans.begin(), spans.end(), [at](const Span& span) { return span.from <= at && at <= span.to; });
}

}  // namespace

std::vector<Span> hidden_by(const std::vector<Remembered>& things, const Pixels& picture, const CameraPose& camera) {
  std::vector<Span> spans;
  const double middle = picture.framing().middle_column, width = static_cast<double>(picture.width());
  for (const Remembered& thing : things) {
    Span span{1.0, 0.0};
    for (const Spot& spot : thing.lost) {
      if (!spot.stands || !show_the_same(spot.camera, camera)) continue;
      const double nearer = spot.column + growth * (spot.column - middle);
      span.from = std::min({span.from, spot.column / width, nearer / width});
      span.to = std::max({span.to, (spot.column + 1.0) / width, (nearer + 1.0) / width});
    }
    if (span.from < span.to) spans.push_back({span.from - at_its_edge, span.to + at_its_edge});
  }
  return spans;
}

std::vector<Spot> HiddenFloor::take() {
  auto spots = std::exchange(spots_, {});
  spots.insert(spots.end(), spots_before_.begin(), spots_before_.end());
  spots_before_.clear();
  return spots;
}

std::vector<Spot> HiddenFloor::left_behind(const CameraPose& camera) {
  return !looked_since_ || show_the_same(*looked_since_, camera) ? std::vector<Spot>{} : take();
}

void HiddenFloor::note_shown(const FloorStrip& floor) {
  shown_.resize(floor.columns(), false);
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const auto [shown, hidden] = floor.column(i);
    if (shown > hidden) shown_[i] = true;
  }
}

void HiddenFloor::note(const FloorStrip& floor, const std::vector<Span>& covered, const std::vector<Remembered>& things,
                       const Pixels& picture, const Gaze& gaze, float near) {
  const bool rests = latest_ && turning_between(*latest_, gaze.camera) <= still;
  has_turned_ = has_turned_ || (latest_ && !rests);
  latest_ = gaze.camera;
  if (!rests) return;
  if (!looked_since_ || !show_the_same(*looked_since_, gaze.camera)) {
    has_looked_elsewhere_ = looked_since_.has_value();
    looked_since_ = gaze.camera;
    shown_.clear();
  }
  if (has_looked_elsewhere_) note_shown(floor);
  clouds_gone_ = covered.empty() ? clouds_gone_ + 1 : 0;
  if (covered.empty() && clouds_gone_ < clouds_to_go) return;
  spots_before_ = std::exchange(spots_, {});
  if (covered.empty()) spots_before_.clear();
  if (covered.empty() || floor.rows().empty() || !gaze.rays.across || !gaze.rays.down) return;
  const auto explained = hidden_by(things, picture, gaze.camera);
  const std::size_t width = picture.width(), of_strip = NearGround::column_step_of(width);
  const auto counts = [&](std::size_t column) {
    const double at = (static_cast<double>(column) + 0.5) / static_cast<double>(width);
    const bool may_be_dark = has_looked_elsewhere_ && !shown_[column / of_strip];
    return is_in_any(covered, at) && !is_in_any(explained, at) && !may_be_dark;
  };
  const auto aside = static_cast<std::size_t>(std::ceil(border / std::abs(gaze.rays.across->slope)));
  std::vector<std::size_t> columns;
  for (std::size_t column = aside; column + aside < width; column += step_of(width))
    if (counts(column)) columns.push_back(column);
  spots_ = spots_on_rays(floor.rows(), columns, picture, gaze, near);
}

}  // namespace safety_control_cloud
