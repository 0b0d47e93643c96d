// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <variant>
#include <vector>

#include "../../safety_control_cloud/core/input/reading.hpp"

namespace safety_control_cloud {

using Buffer = std::vector<std::uint8_t>;

template <class Message>
Buffer serialised(const Message& message) {
  Buffer bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

inline Buffer with_number_at(std::size_t place, std::uint32_t number, Buffer bytes) {
  std::memcpy(bytes.data() + place, &number, sizeof(number));
  return bytes;
}

/// As roscpp hands it over: in a buffer that ends where the message does, so that AddressSanitizer sees who reads on.
inline ros::serialization::IStream stream_of(Buffer& bytes) {
  bytes.shrink_to_fit();
  return {bytes.data(), static_cast<std::uint32_t>(bytes.size())};
}

inline std::string reason_in(const Reading& reading) {
  const auto* unreadable = std::get_if<Unreadable>(&reading);
  return unreadable ? unreadable->reason : "";
}

}  // namespace safety_control_cloud
