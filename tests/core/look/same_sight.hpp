// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "../../../safety_control_cloud/core/look/kernel/scan.hpp"
#include "random_case.hpp"

namespace safety_control_cloud {

/// Looks with each instruction set of this machine in turn, and with the best again afterwards.
class InstructionSet : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { use_instruction_set(GetParam()); }
  void TearDown() override { use_instruction_set(""); }
};

using WayToLook = Sight (*)(const View&, const Outlook&, Crop, Rows);

inline Sight seen_by(WayToLook method, const View& view, const RandomCase& shown, Crop crop = Crop::Keep) {
  return method(view, Outlook(shown.corridor, shown.placement), crop, shown.rows);
}

inline bool same_bits(const Point& a, const Point& b) { return std::memcmp(a.data, b.data, 3 * sizeof(float)) == 0; }

inline bool same(const Sight& a, const Sight& b) {
  if (a.inside != b.inside || a.too_close != b.too_close || a.returns != b.returns || a.total != b.total) return false;
  if (a.nearest_in_rows != b.nearest_in_rows) return false;
  if (a.nearest.has_value() != b.nearest.has_value()) return false;
  if (a.nearest && !same_bits(a.nearest->point, b.nearest->point)) return false;
  if ((a.crop == nullptr) != (b.crop == nullptr)) return false;
  return !a.crop || std::equal(a.crop->begin(), a.crop->end(), b.crop->begin(), b.crop->end(), same_bits);
}

inline std::string words(const Sight& sight) {
  return std::to_string(sight.inside) + " inside, " + std::to_string(sight.too_close) + " too close, " +
         std::to_string(sight.returns) + " returns of " + std::to_string(sight.total) + ", nearest " +
         (sight.nearest ? std::to_string(sight.nearest->distance()) : "none");
}

}  // namespace safety_control_cloud
