// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace safety_control_cloud {

/// What a sensor sends. From the same picture, clouds and depth images give the same Sight.
enum class InputKind : std::uint8_t {
  Cloud,  ///< points
  Depth,  ///< depth images
  Scan,   ///< turns of a planar range finder
};

const char* name_of(InputKind input);  ///< "cloud", "depth" or "scan"
std::optional<InputKind> input_named(const std::string& name);

}  // namespace safety_control_cloud
