// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "near_returns.hpp"

namespace safety_control_cloud {

/// How high the near returns of a look reach: what stands somewhere is one thing, from its lowest return to its
/// highest.
class Tops {
 public:
  explicit Tops(const std::vector<NearReturn>& all);

  /// [m] above base_frame of one of them, in its column and the eight around that: asked for once for each column.
  float around(const NearReturn& one);

 private:
  float highest_around(const Point2& place) const;

  std::unordered_map<std::uint64_t, float> of_column_, around_;
};

}  // namespace safety_control_cloud
