// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "horizon.hpp"
#include "near_returns.hpp"

namespace safety_control_cloud {

/// From where to where the near returns of a look reach: what stands or hangs somewhere is one thing, from its lowest
/// return to its highest.
class Extents {
 public:
  explicit Extents(const std::vector<NearReturn>& all);

  /// Of one of them, in its column and the eight around that: asked for once for each column.
  Heights around(const NearReturn& one);

 private:
  Heights all_around(const NearReturn& one) const;

  std::unordered_map<std::uint64_t, Heights> of_column_, around_;
};

}  // namespace safety_control_cloud
