// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scenes.hpp"

namespace safety_control_cloud {

/// "fresh": a cloud that is in no cache, as a camera's next cloud is; "cached": the same cloud again and again.
constexpr std::size_t more_than_any_cache = std::size_t{256} << 20;  // [byte]

/// Copies of a cloud, one after the other.
class Clouds {
 public:
  Clouds(const CameraPicture& picture, bool fresh)
      : picture_(picture), fresh_(fresh), count_(fresh ? more_than_any_cache / picture.size() + 2 : 1) {
    const auto bytes = bytes_of(picture);
    memory_.reserve(count_ * bytes.size());
    for (std::size_t i = 0; i < count_; ++i) memory_.insert(memory_.end(), bytes.begin(), bytes.end());
  }

  bool are(const CameraPicture& picture, bool fresh) const { return fresh == fresh_ && picture == picture_; }
  const std::uint8_t* next() { return memory_.data() + turn_++ % count_ * picture_.size(); }

 private:
  CameraPicture picture_;
  bool fresh_;
  std::size_t count_, turn_ = 0;
  std::vector<std::uint8_t> memory_;
};

}  // namespace safety_control_cloud
