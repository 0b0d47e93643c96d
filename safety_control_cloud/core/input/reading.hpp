// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>

#include "scan.hpp"
#include "view.hpp"

namespace safety_control_cloud {

/// Why what a camera sent cannot be read, in words for the robot's owner.
struct Unreadable {
  std::string reason;
};

using Reading = std::variant<CloudView, DepthView, ScanView, Unreadable>;

/// The view of a reading that is readable.
inline View view_in(const Reading& reading) {
  if (const auto* image = std::get_if<DepthView>(&reading)) return *image;
  if (const auto* scan = std::get_if<ScanView>(&reading)) return scan->points;
  return std::get<CloudView>(reading);
}

/// Whether bytes that claim this order must be swapped on this machine.
inline bool is_foreign(bool is_bigendian) { return is_bigendian != (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__); }

}  // namespace safety_control_cloud
