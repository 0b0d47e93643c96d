// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace safety_control_cloud {

/// Only reads the bytes, as fast as the machine can: the OR of all of them, eight at a time.
std::uint64_t read_bytes(const std::uint8_t* bytes, std::size_t size);

}  // namespace safety_control_cloud
