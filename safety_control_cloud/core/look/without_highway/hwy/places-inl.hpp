// SPDX-License-Identifier: BSD-3-Clause
// What moves lanes to other places; part of highway.h.
#if defined(SAFETY_CONTROL_CLOUD_PLACES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_PLACES_INL
#undef SAFETY_CONTROL_CLOUD_PLACES_INL
#else
#define SAFETY_CONTROL_CLOUD_PLACES_INL
#endif

#include <cstddef>
#include <cstdint>
#include <utility>
#ifdef __aarch64__
#include <arm_neon.h>
#endif

#include "lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud::without_highway {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2
template <class Tag>
HWY_INLINE Vec<Tag> Combine(Tag, Vec<Half<Tag>> upper, Vec<Half<Tag>> lower) {
  return (Vec<Tag>)_mm256_insertf128_ps(_mm256_castps128_ps256((__m128)lower), (__m128)upper, 1);
}
#else  // no vector is longer than a block
template <class Tag>
Vec<Tag> Combine(Tag, Vec<Half<Tag>> upper, Vec<Half<Tag>> lower);
#endif

/// The lane of two vectors, one behind the other, that `chosen` (0 to 3: of the first, 4 to 7: of the second) is in the
/// block of lane i.
constexpr int of_block(std::size_t i, std::size_t lanes, int chosen) {
  return static_cast<int>(i / 4 * 4) + chosen % 4 + (chosen < 4 ? 0 : static_cast<int>(lanes));
}

template <int... Chosen, class V, std::size_t... I>
HWY_INLINE V shuffled_lanes(V a, V b, std::index_sequence<I...>) {
  constexpr int chosen[] = {Chosen...};
#ifdef __clang__
  return __builtin_shufflevector(a, b, of_block(I, sizeof...(I), chosen[I % 4])...);
#else
  return __builtin_shuffle(a, b, MaskOf<V>{of_block(I, sizeof...(I), chosen[I % 4])...});
#endif
}

/// Four lanes of each block of two vectors.
template <int First, int Second, int Third, int Fourth, class V>
HWY_INLINE V shuffled(V a, V b) {
  return shuffled_lanes<First, Second, Third, Fourth>(a, b, std::make_index_sequence<sizeof(V) / sizeof(a[0])>());
}
template <class Tag>
HWY_INLINE Vec<Tag> InterleaveLower(Tag, Vec<Tag> a, Vec<Tag> b) {
  return shuffled<0, 4, 1, 5>(a, b);
}
template <class Tag>
HWY_INLINE Vec<Tag> InterleaveUpper(Tag, Vec<Tag> a, Vec<Tag> b) {
  return shuffled<2, 6, 3, 7>(a, b);
}

/// A block from every `step` bytes.
template <class Tag>
HWY_INLINE Vec<Tag> blocks_at(Tag tag, const std::uint8_t* from, [[maybe_unused]] std::size_t step) {
  if constexpr (sizeof(Vec<Tag>) == 16) {
    return LoadU(tag, from);
  } else {
    const Half<Tag> half;
    return Combine(tag, LoadU(half, from + step), LoadU(half, from));
  }
}
template <class Tag>
HWY_INLINE Vec<Tag> LoadDup128(Tag tag, const LaneOf<Tag>* from) {
  return blocks_at(tag, reinterpret_cast<const std::uint8_t*>(from), 0);
}
template <class Tag>
HWY_INLINE void LoadInterleaved3([[maybe_unused]] Tag tag, const float* from, Vec<Tag>& x, Vec<Tag>& y, Vec<Tag>& z) {
#ifdef __aarch64__
  const float32x4x3_t loaded = vld3q_f32(from);
  x = (Vec<Tag>)loaded.val[0];
  y = (Vec<Tag>)loaded.val[1];
  z = (Vec<Tag>)loaded.val[2];
#else  // x y z x  y z x y  z x y z
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(from);
  const Vec<Tag> a = blocks_at(tag, bytes, 48), b = blocks_at(tag, bytes + 16, 48), c = blocks_at(tag, bytes + 32, 48);
  x = shuffled<0, 3, 4, 6>(a, shuffled<2, 2, 5, 5>(b, c));
  y = shuffled<0, 2, 4, 6>(shuffled<1, 1, 4, 4>(a, b), shuffled<3, 3, 6, 6>(b, c));
  z = shuffled<0, 2, 4, 7>(shuffled<2, 2, 5, 5>(a, b), c);
#endif
}

/// Each byte is that of its block whose place `order` has.
template <class V>
HWY_INLINE V TableLookupBytes(V bytes, V order) {
#if HWY_TARGET == HWY_AVX2
  return (V)_mm256_shuffle_epi8((__m256i)bytes, (__m256i)order);
#elif HWY_TARGET == HWY_SSE4
  return (V)_mm_shuffle_epi8((__m128i)bytes, (__m128i)order);
#elif defined(__aarch64__)
  return (V)vqtbl1q_u8((uint8x16_t)bytes, (uint8x16_t)order);
#else
  V looked_up{};
  for (std::size_t i = 0; i < sizeof(V); ++i) looked_up[i] = bytes[order[i]];
  return looked_up;
#endif
}

/// uint16 to int32, as many as fill a register.
template <class Tag>
HWY_INLINE Vec<Tag> PromoteTo(Tag, Vec<Rebind<std::uint16_t, Tag>> halves) {
#if HWY_TARGET == HWY_AVX2
  return (Vec<Tag>)_mm256_cvtepu16_epi32((__m128i)halves);
#elif HWY_TARGET == HWY_SSE4
  return (Vec<Tag>)_mm_cvtepu16_epi32((__m128i)halves);
#elif defined(__aarch64__)
  return (Vec<Tag>)vmovl_u16(vget_low_u16((uint16x8_t)halves));
#else
  Vec<Tag> promoted{};
  for (std::size_t i = 0; i < Tag::lanes; ++i) promoted[i] = halves[i];
  return promoted;
#endif
}

/// The lanes whose mask is set one behind the other, and behind them whatever.
template <class V, class M>
HWY_INLINE V Compress(V v, M mask) {
  constexpr std::size_t lanes = sizeof(V) / sizeof(v[0]);
  V listed{};
  for (std::size_t i = 0, size = 0; i < lanes; ++i) {
    listed[size] = v[i];
    size += mask[i] != 0;
  }
  return listed;
}

template <class Tag, class M>
HWY_INLINE std::size_t CountTrue(Tag, M mask) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < Tag::lanes; ++i) size += mask[i] != 0;
  return size;
}

}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud::without_highway
HWY_AFTER_NAMESPACE();

#endif
