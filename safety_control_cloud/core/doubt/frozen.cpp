// SPDX-License-Identifier: BSD-3-Clause
#include "frozen.hpp"

#include <cstring>

#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::uint64_t odd[] = {0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9};  // any with many bits set

template <class Word>
std::uint64_t word_at(const std::uint8_t* from) {
  Word word;
  std::memcpy(&word, from, sizeof word);
  return word;
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * odd[0];
  return hash ^ (hash >> 29);
}

/// Of x, y and z alone, as bits.
template <class Word>
std::uint64_t hash_of_points(const CloudView& cloud) {
  std::uint64_t hash = cloud.size();
  for (std::size_t row = 0; row < (cloud.width == 0 ? 0 : cloud.height); ++row) {
    const std::uint8_t* point = cloud.bytes + row * cloud.row_step;
    for (std::size_t column = 0; column < cloud.width; ++column, point += cloud.point_step) {
      const auto axis = [&](std::size_t i) { return word_at<Word>(point + cloud.offset[i]) * odd[i]; };
      hash = mixed(hash, axis(0) + axis(1) + axis(2));
    }
  }
  return hash;
}

std::uint64_t hash_of(const CloudView& cloud) {
  return cloud.scalar == Scalar::Float64 ? hash_of_points<std::uint64_t>(cloud) : hash_of_points<std::uint32_t>(cloud);
}

/// What pads a row may hold anything.
std::uint64_t hash_of(const DepthView& image) {
  std::uint64_t hash = image.size();
  const std::size_t size = image.width * image.pixel_step(), whole = size / sizeof hash * sizeof hash;
  for (std::size_t row = 0; row < (size == 0 ? 0 : image.height); ++row) {
    const std::uint8_t* bytes = image.bytes + row * image.row_step;
    for (std::size_t i = 0; i < whole; i += sizeof hash) hash = mixed(hash, word_at<std::uint64_t>(bytes + i));
    for (std::size_t i = whole; i < size; ++i) hash = mixed(hash, bytes[i]);
  }
  return hash;
}

}  // namespace

std::optional<Doubt> FrozenWatch::note(const View& view, double stamp, std::size_t most) {
  repeats_ = false;
  if (most == 0) return std::nullopt;
  const std::uint64_t content = std::visit([](const auto& points) { return hash_of(points); }, view);
  repeats_ = same_ > 0 && content == content_;
  if (!repeats_) same_ = 0;
  const bool again = repeats_ && stamp == stamp_;
  if (!again || twice_) ++same_;
  twice_ = again;
  content_ = content;
  stamp_ = stamp;
  if (same_ < most) return std::nullopt;
  return Doubt{Cause::Frozen, words(same_, " successive clouds have the same content")};
}

}  // namespace safety_control_cloud
