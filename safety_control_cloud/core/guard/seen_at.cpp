// SPDX-License-Identifier: BSD-3-Clause
#include "seen_at.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "../input/angle.hpp"

namespace safety_control_cloud {
namespace {

constexpr double nearest = 0.05;                     ///< [m] before a camera: nearer, directions mean nothing
constexpr double behind = 0.05, behind_rate = 0.03;  ///< [m] and share of the distance: more than noise
constexpr double in_plane = 0.01;                    ///< [m] beside a scan's plane that it still meets
constexpr int attempts = 3;                          ///< to find a pixel through a bent lens
constexpr std::size_t border_steps = 2;              ///< of those that are looked at, see in_picture
constexpr long deepest_border = 8;                   ///< of the picture's rows, that it leaves empty at most
constexpr double close_enough = 1.5;                 ///< [px]

/// Of several pixels around a direction, one after the other.
class Around {
 public:
  Around(double distance, double off)
      : distance_(distance), tolerance_(behind + behind_rate * distance + off), may_lie_beside_(off > 0.0) {}

  void add(bool returned, double seen) {
    ++pixels_;
    all_returned_ = all_returned_ && returned;
    none_before_ = none_before_ && !(returned && seen < distance_ - tolerance_);
    if (!(returned && is_there(seen))) return;
    ++there_;
    seen_there_ += seen;
  }
  /// A single stray return shows nothing.
  AtPlace answer() const {
    if (2 * there_ > pixels_) return AtPlace::Shown;
    if (!none_before_ || (there_ > 0 && !may_lie_beside_)) return AtPlace::NotThere;
    return all_returned_ ? AtPlace::Behind : AtPlace::Nothing;
  }
  /// How far what is there lies, in the mean, as a share of the distance that was asked about.
  double share() const { return seen_there_ / (there_ * distance_); }
  bool is_there(double seen) const { return std::abs(seen - distance_) <= tolerance_; }

 private:
  double distance_, tolerance_;  ///< [m]
  bool may_lie_beside_;
  bool all_returned_ = true, none_before_ = true;
  int pixels_ = 0, there_ = 0;
  double seen_there_ = 0.0;  ///< [m] in sum
};

/// Whether what is there shows in a pixel too that is looked at: of those around this one, the nearest.
bool is_looked_at(const Pixels& pixels, const std::vector<std::size_t>& rows, std::size_t row, std::size_t column,
                  const Around& around) {
  const auto below = std::upper_bound(rows.begin(), rows.end(), row);
  const std::size_t apart = columns_apart(pixels.width()), left = column - column % apart;
  const auto shows = [&](std::size_t r, std::size_t c) {
    const Point seen = c < pixels.width() ? pixels.at(r, c) : Point(0.0f, 0.0f, NAN);
    return returned(seen) && around.is_there(seen.z);
  };
  const auto is_in = [&](std::size_t r) { return shows(r, left) || (left != column && shows(r, left + apart)); };
  return is_in(*(below - 1)) || (*(below - 1) != row && below != rows.end() && is_in(*below));
}

float range_min_of(const Reading& reading) {
  return std::holds_alternative<ScanView>(reading) ? std::numeric_limits<float>::lowest() : 0.0f;
}

std::optional<FieldOfView> picture_in(const Reading& reading, const View& view) {
  if (std::holds_alternative<ScanView>(reading) || width_of(view) < 2 || height_of(view) < 2) return std::nullopt;
  const auto field = field_of(view, Sense::Either);
  const auto* seen = std::get_if<FieldOfView>(&field);
  return seen ? std::optional(*seen) : std::nullopt;
}

Point scaled(const Point& point, double by) {
  const auto share = static_cast<float>(by);
  return Point(share * point.x, share * point.y, share * point.z);
}

/// [rad] from the first bearing on, in whichever turn that lies.
double bearing_in(const ScanView& scan, const Point& place) {
  const double beyond = std::fmod(std::atan2(place.y, place.x) - scan.first, full_turn);
  return scan.first + (beyond < 0.0 ? beyond + full_turn : beyond);
}

}  // namespace

SeenAt::SeenAt(const Look& look, const Vicinity& vicinity)
    : look_(look),
      vicinity_(vicinity),
      pixels_(look.view, range_min_of(look.reading)),
      picture_(picture_in(look.reading, look.view)),
      scan_(std::get_if<ScanView>(&look.reading)) {
  if (picture_) rows_ = rows_looked_at(pixels_.height(), look.number);
}

AtPlace SeenAt::operator()(const Point& place, double off, double aside) const {
  if (scan_) return in_scan(place, off, aside);
  return picture_ ? in_picture(place, off) : AtPlace::NotThere;
}

/// What a return that lies there, in the sensor's frame, tells of what is remembered there: what is not kept anew must
/// not be forgotten, and of what a part of the robot hides nobody knows. What returns a little above or below the
/// heights that count belongs to what returns between them.
AtPlace SeenAt::shown_at(const Point& place) const {
  const Point placed = look_.outlook.placed(place.x, place.y, place.z);
  const Point2 seen{placed.z, -placed.x};
  if (is_own(vicinity_.self, seen.x, seen.y, -placed.y)) return AtPlace::NotThere;
  return length_of(seen) > vicinity_.distance ? AtPlace::ShownOnly : AtPlace::Shown;
}

/// Through a lens that does not bend its rays.
SeenAt::Pixel SeenAt::pixel_of(double x, double y) const {
  const double across = (picture_->right - picture_->left) / static_cast<double>(pixels_.width());
  const double down = (picture_->bottom - picture_->top) / static_cast<double>(pixels_.height());
  return {(y - picture_->top) / down - 0.5, (x - picture_->left) / across - 0.5};
}

bool SeenAt::is_near(const Point& seen) const {
  const Point placed = look_.outlook.placed(seen.x, seen.y, seen.z);
  return vicinity_.holds({placed.z, -placed.x}, -placed.y);
}

/// Three columns beside each other: now and then, a stray return shows something in one. A camera may leave the border
/// of its picture empty.
bool SeenAt::goes_on_in_picture(const Point& place) const {
  if (!picture_ || !(place.z > nearest)) return false;
  const auto height = static_cast<long>(pixels_.height()), width = static_cast<long>(pixels_.width());
  const auto [row, column] = pixel_of(double{place.x} / place.z, double{place.y} / place.z);
  const auto border = static_cast<double>(border_steps * rows_apart(pixels_.height()));
  const bool is_above = row < border, is_below = row >= static_cast<double>(height) - border;
  if (is_above == is_below || !(column >= 1.0 && column < static_cast<double>(width) - 2.0)) return false;
  const auto shows_something = [&](long c) {
    for (long i = 0; i <= height / deepest_border; ++i) {
      const Point seen = pixels_.near(is_above ? i : height - 1 - i, c);
      if (returned(seen)) return is_near(seen);
    }
    return false;
  };
  const long c = std::lround(column);
  return shows_something(c - 1) && shows_something(c) && shows_something(c + 1);
}

/// The pixel that looks there, corrected by the rays of those that returned: a lens may bend them. At the border of the
/// picture what is shown there may as well be what follows upon it, of a thing that leaves the picture: so the end of a
/// pallet would be taken to go back before the robot.
AtPlace SeenAt::in_picture(const Point& place, double off) const {
  if (!(place.z > nearest) || !picture_->holds(place)) return AtPlace::NotThere;
  const double x = double{place.x} / place.z, y = double{place.y} / place.z;
  const double across = (picture_->right - picture_->left) / static_cast<double>(pixels_.width());
  const double down = (picture_->bottom - picture_->top) / static_cast<double>(pixels_.height());
  auto [row, column] = pixel_of(x, y);
  for (int i = 0; i < attempts; ++i) {
    const Point seen = pixels_.near(std::lround(row), std::lround(column));
    if (!returned(seen)) break;
    const double off_across = (x - double{seen.x} / seen.z) / across, off_down = (y - double{seen.y} / seen.z) / down;
    if (std::abs(off_across) <= close_enough && std::abs(off_down) <= close_enough) break;
    if (i + 1 == attempts) return AtPlace::NotThere;
    column += off_across, row += off_down;
  }
  const auto r = std::lround(row), c = std::lround(column);
  const auto tells = [](long at, std::size_t size, std::size_t apart) {
    const auto border = static_cast<long>(border_steps * apart);
    return at >= border && at < static_cast<long>(size) - border;
  };
  if (!tells(r, pixels_.height(), rows_apart(pixels_.height()))) return AtPlace::NotThere;
  if (!tells(c, pixels_.width(), columns_apart(pixels_.width()))) return AtPlace::NotThere;
  Around around(place.z, off);
  for (const float z : pixels_.around(static_cast<std::size_t>(r), static_cast<std::size_t>(c)))
    around.add(!std::isnan(z), z);
  const AtPlace answer = around.answer();
  if (answer != AtPlace::Shown) return answer;
  const AtPlace shown = shown_at(scaled(place, around.share()));
  const auto at_row = static_cast<std::size_t>(r), at_column = static_cast<std::size_t>(c);
  const bool is_kept = shown != AtPlace::Shown || is_looked_at(pixels_, rows_, at_row, at_column, around);
  return is_kept ? shown : AtPlace::ShownOnly;
}

AtPlace SeenAt::in_scan(const Point& place, double off, double aside) const {
  const double distance = std::hypot(place.x, place.y), bearing = bearing_in(*scan_, place);
  if (std::abs(place.z) > in_plane || pixels_.width() < 2) return AtPlace::NotThere;
  if (look_.bearings && !look_.bearings->measures_at(bearing)) return AtPlace::NotThere;  // nobody looks
  const auto last = static_cast<std::ptrdiff_t>(pixels_.width()) - 1;
  const double beams_each = static_cast<double>(last) / (scan_->last - scan_->first);        // [1/rad]
  const auto all_around = static_cast<std::ptrdiff_t>(std::lround(full_turn * beams_each));  // beams that a turn takes
  const bool has_seam = all_around > last + 1;  // or else the first beam follows the last
  if (has_seam && (bearing - aside < scan_->first || bearing + aside > scan_->last)) return AtPlace::NotThere;
  const auto at = static_cast<std::ptrdiff_t>(std::lround((bearing - scan_->first) * beams_each));
  const auto most = static_cast<std::ptrdiff_t>(std::ceil(1.0 + std::min(aside, pi) * beams_each));
  if (distance + off > scan_->range_max) return AtPlace::NotThere;  // where it sees nothing there may be anything
  const bool may_be_too_near = distance - off < scan_->range_min;   // some say +Inf of that
  Around around(distance, off);
  for (std::ptrdiff_t beside = -most; beside <= most; ++beside) {
    const std::ptrdiff_t beam = has_seam ? at + beside : (at + beside + 2 * all_around) % all_around;
    const Point seen = pixels_.near(0, scan_->descending ? last - beam : beam);
    const double range = std::hypot(seen.x, seen.y);
    around.add(returned(seen) && !(may_be_too_near && range > scan_->range_max), range);
  }
  const AtPlace answer = around.answer();
  return answer == AtPlace::Shown ? shown_at(scaled(place, around.share())) : answer;
}

}  // namespace safety_control_cloud
