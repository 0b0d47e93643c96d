// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "../input/reading.hpp"
#include "../look/field_of_view.hpp"
#include "../memory/pixels.hpp"
#include "near_returns.hpp"

namespace safety_control_cloud {

/// What a look shows where something is remembered; the more it says of that, the later.
enum class AtPlace : std::uint8_t {
  NotThere,   ///< it does not look there, or at something before it, or at a part of the robot
  Nothing,    ///< it looks there, and nothing returns from it nor before it
  Behind,     ///< all that returns from around its direction lies behind it
  ShownOnly,  ///< as Shown, but not kept anew: too far from the robot, or too thin for the rows that are looked at
  Shown,      ///< most of what returns from around its direction lies where it does, and is kept anew
};

/// Asks one look about places, in the sensor's own frame. Of what it shows, only returns in the vicinity are kept.
class SeenAt {
 public:
  SeenAt(const Look& look, const Vicinity& vicinity);

  /// A picture in rows and columns, or a scan: of others nothing can be told.
  bool can_tell() const { return picture_ || scan_; }

  /// `off` [m] by which it may lie elsewhere: what returns from no more than that before it or behind it may be it.
  /// `aside` [rad] by which a scan may show it in another direction, since the robot turned while it was being taken.
  AtPlace operator()(const Point& place, double off = 0.0, double aside = 0.0) const;

  /// Of a place above the picture or below it: whether that shows at its border, right there, what is in the vicinity,
  /// of which the place may be the end. What returns nothing there tells nothing.
  bool goes_on_in_picture(const Point& place) const;

 private:
  struct Pixel {
    double row, column;
  };

  Pixel pixel_of(double x, double y) const;
  bool is_near(const Point& seen) const;
  AtPlace in_picture(const Point& place, double off) const;
  AtPlace in_scan(const Point& place, double off, double aside) const;
  AtPlace shown_at(const Point& place) const;

  const Look& look_;
  const Vicinity& vicinity_;
  Pixels pixels_;
  std::optional<FieldOfView> picture_;
  const ScanView* scan_;
  std::vector<std::size_t> rows_;  ///< of the picture that are looked at
};

}  // namespace safety_control_cloud
