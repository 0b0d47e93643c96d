// SPDX-License-Identifier: BSD-3-Clause
#include "layout.hpp"

#include <algorithm>
#include <optional>
#include <variant>

#include "../text/words.hpp"
#include "extent.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

std::size_t size_of(const Field& field) { return field.datatype == Field::FLOAT64 ? sizeof(double) : sizeof(float); }

bool overlap(const Field& a, const Field& b) {
  const std::uint64_t a_begin = a.offset, b_begin = b.offset;
  return a_begin < b_begin + size_of(b) && b_begin < a_begin + size_of(a);
}

std::optional<std::string> problem_with(const Field& field, const Layout& layout) {
  if (field.datatype != Field::FLOAT32 && field.datatype != Field::FLOAT64) {
    return words("field ", field.name, " has datatype ", int{field.datatype}, ", not FLOAT32 (7) or FLOAT64 (8)");
  }
  if (field.count != 1) return words("field ", field.name, " has count ", field.count, ", not 1");
  if (std::uint64_t{field.offset} + size_of(field) > layout.point_step) {
    return words("field ", field.name, " at offset ", field.offset, " ends beyond point_step ", layout.point_step);
  }
  return std::nullopt;
}

/// x, y and z, or why there is no such three.
std::variant<std::array<Field, 3>, Unreadable> coordinates_in(const Layout& layout) {
  std::array<Field, 3> found;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto named = [&](const Field& field) { return field.name == axes[i]; };
    const auto field = std::find_if(layout.fields.begin(), layout.fields.end(), named);
    if (field == layout.fields.end()) return Unreadable{words("no field ", axes[i])};
    if (std::any_of(field + 1, layout.fields.end(), named)) return Unreadable{words("more than one field ", axes[i])};
    if (const auto problem = problem_with(*field, layout)) return Unreadable{*problem};
    found[i] = *field;
  }
  const auto& [x, y, z] = found;
  if (x.datatype != y.datatype || y.datatype != z.datatype) return Unreadable{"x, y and z differ in datatype"};
  if (overlap(x, y) || overlap(y, z) || overlap(x, z)) return Unreadable{"x, y and z overlap"};
  return found;
}

Extent extent_of(const Layout& layout) {
  return {layout.height, layout.width, {"point_step", layout.point_step}, {"row_step", layout.row_step}};
}

}  // namespace

Reading view_of(const Layout& layout, const std::uint8_t* bytes, std::size_t size) {
  const auto coordinates = coordinates_in(layout);
  if (const auto* unreadable = std::get_if<Unreadable>(&coordinates)) return *unreadable;
  const Extent extent = extent_of(layout);
  if (const auto problem = problem_with(extent, size)) return Unreadable{*problem};

  const auto& [x, y, z] = std::get<std::array<Field, 3>>(coordinates);
  CloudView view;
  view.bytes = bytes;
  view.width = layout.width;
  view.height = rows_in(extent);
  view.point_step = layout.point_step;
  view.row_step = layout.row_step;
  view.offset = {x.offset, y.offset, z.offset};
  view.scalar = x.datatype == Field::FLOAT64 ? Scalar::Float64 : Scalar::Float32;
  view.swapped = is_foreign(layout.is_bigendian);
  return view;
}

}  // namespace safety_control_cloud
