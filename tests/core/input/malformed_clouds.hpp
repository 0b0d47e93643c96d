// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <ostream>
#include <vector>

#include "../../../safety_control_cloud/core/input/layout.hpp"

namespace safety_control_cloud {

struct ClaimedCloud {
  Layout layout;
  std::size_t size = 0;  ///< [byte] of its data
};

/// 2 rows of 3 points, x y z float32 and 4 bytes of something else.
inline ClaimedCloud well_formed_cloud() {
  Layout layout;
  layout.height = 2;
  layout.width = 3;
  layout.fields = {{"x", 0, Field::FLOAT32, 1}, {"y", 4, Field::FLOAT32, 1}, {"z", 8, Field::FLOAT32, 1}};
  layout.is_bigendian = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
  layout.point_step = 16;
  layout.row_step = 48;
  return {layout, 96};
}

struct MalformedCloud {
  const char* name;
  const char* reason;  ///< a part of the sentence the robot's owner must read
  std::function<void(Layout&, std::size_t&)> harm;

  ClaimedCloud cloud() const {
    ClaimedCloud claimed = well_formed_cloud();
    harm(claimed.layout, claimed.size);
    return claimed;
  }
};

inline void PrintTo(const MalformedCloud& cloud, std::ostream* out) { *out << cloud.name; }

/// Every way in which a PointCloud2 can contradict itself. The node must stop for each and crash for none.
inline std::vector<MalformedCloud> malformed_clouds() {
  constexpr std::uint32_t huge = std::numeric_limits<std::uint32_t>::max();
  constexpr std::uint8_t uint32_code = 6;
  using L = Layout;
  using S = std::size_t;
  return {
      {"NoFields", "no field x", [](L& l, S&) { l.fields.clear(); }},
      {"NoX", "no field x", [](L& l, S&) { l.fields[0].name = "X"; }},
      {"NoY", "no field y", [](L& l, S&) { l.fields[1].name = ""; }},
      {"NoZ", "no field z", [](L& l, S&) { l.fields.pop_back(); }},
      {"TwoX", "more than one field x", [](L& l, S&) { l.fields.push_back(l.fields[0]); }},
      {"DatatypeZero", "datatype 0", [](L& l, S&) { l.fields[0].datatype = 0; }},
      {"DatatypeUint32", "datatype 6", [](L& l, S&) { l.fields[2].datatype = uint32_code; }},
      {"DatatypeUnknown", "datatype 255", [](L& l, S&) { l.fields[1].datatype = 255; }},
      {"DatatypesDiffer", "differ in datatype", [](L& l, S&) { l.fields[2].datatype = Field::FLOAT64; }},
      {"Float64TooWide", "overlap",
       [](L& l, S&) {
         for (auto& field : l.fields) field.datatype = Field::FLOAT64;
       }},
      {"CountZero", "count 0", [](L& l, S&) { l.fields[0].count = 0; }},
      {"CountTwo", "count 2", [](L& l, S&) { l.fields[2].count = 2; }},
      {"CountHuge", "count 4294967295", [](L& l, S&) { l.fields[1].count = huge; }},
      {"SamePlace", "overlap", [](L& l, S&) { l.fields[1].offset = 0; }},
      {"HalfOverlap", "overlap", [](L& l, S&) { l.fields[1].offset = 2; }},
      {"OffsetBeyondPoint", "beyond point_step", [](L& l, S&) { l.fields[2].offset = 13; }},
      {"OffsetNearTwoToThe32", "beyond point_step", [](L& l, S&) { l.fields[0].offset = huge - 1; }},
      {"PointStepZero", "beyond point_step 0", [](L& l, S&) { l.point_step = 0; }},
      {"PointStepTooSmall", "beyond point_step 11", [](L& l, S&) { l.point_step = 11; }},
      {"PointStepHuge", "row_step", [](L& l, S&) { l.point_step = huge; }},
      {"RowStepZero", "row_step 0", [](L& l, S&) { l.row_step = 0; }},
      {"RowStepTooSmall", "row_step 47", [](L& l, S&) { l.row_step = 47; }},
      {"RowStepHuge", "data has 96 bytes", [](L& l, S&) { l.row_step = huge; }},
      {"DataShortByOne", "data has 95 bytes", [](L&, S& size) { size = 95; }},
      {"DataLongByOne", "data has 97 bytes", [](L&, S& size) { size = 97; }},
      {"NoData", "data has 0 bytes", [](L&, S& size) { size = 0; }},
      {"DataOfNoPoints", "data has 96 bytes", [](L& l, S&) { l.height = 0; }},
      {"WidthHuge", "row_step 48", [](L& l, S&) { l.width = huge; }},
      {"HeightHuge", "data has 96 bytes", [](L& l, S&) { l.height = huge; }},
      {"WidthTimesHeightWraps", "row_step", [](L& l, S&) { l.width = l.height = 65536; }},  // 2^32 points: 0 in 32 bits
      {"WidthTimesStepWraps", "row_step 0",
       [](L& l, S& size) { l.width = 1u << 28, l.height = 1, l.row_step = 0, size = 0; }},  // 2^28 x 16 = 2^32
      {"HeightTimesRowWraps", "data has 0 bytes",
       [](L& l, S& size) { l.width = 1, l.row_step = l.height = 65536, size = 0; }},
  };
}

}  // namespace safety_control_cloud
