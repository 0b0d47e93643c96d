// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "../input/reading.hpp"
#include "../look/field_of_view.hpp"
#include "../memory/pixels.hpp"

namespace safety_control_cloud {

/// What a look shows where something is remembered; the more it says of that, the later.
enum class AtPlace : std::uint8_t {
  NotThere,  ///< it does not look there, or at something before it
  Nothing,   ///< it looks there, and nothing returns from it nor before it
  Behind,    ///< all that returns from around its direction lies behind it
  Shown,     ///< most of what returns from around its direction lies where it does
};

/// Asks one look about places, in the sensor's own frame.
class SeenAt {
 public:
  SeenAt(const Reading& reading, const View& view);

  /// A picture in rows and columns, or a scan: of others nothing can be told.
  bool can_tell() const { return picture_ || scan_; }

  /// `off` [m] by which it may lie elsewhere: what returns from no more than that before it or behind it may be it.
  /// `aside` [rad] by which a scan may show it in another direction, since the robot turned while it was being taken.
  AtPlace operator()(const Point& place, double off = 0.0, double aside = 0.0) const;

 private:
  AtPlace in_picture(const Point& place, double off) const;
  AtPlace in_scan(const Point& place, double off, double aside) const;

  Pixels pixels_;
  std::optional<FieldOfView> picture_;
  const ScanView* scan_;
};

}  // namespace safety_control_cloud
