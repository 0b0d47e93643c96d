// SPDX-License-Identifier: BSD-3-Clause
// What is done with each lane by itself, and over all lanes; part of highway.h.
#if defined(SAFETY_CONTROL_CLOUD_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_LANES_INL
#undef SAFETY_CONTROL_CLOUD_LANES_INL
#else
#define SAFETY_CONTROL_CLOUD_LANES_INL
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "tags-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud::without_highway {
namespace HWY_NAMESPACE {

template <class Tag, class V>
HWY_INLINE Vec<Tag> BitCast(Tag, V v) {
  return (Vec<Tag>)v;
}
template <class Tag, class V>
HWY_INLINE Vec<Tag> ConvertTo(Tag, V v) {
  return __builtin_convertvector(v, Vec<Tag>);
}

template <class V>
HWY_INLINE V Add(V a, V b) {
  return a + b;
}
template <class V>
HWY_INLINE V Sub(V a, V b) {
  return a - b;
}
template <class V>
HWY_INLINE V Mul(V a, V b) {
  return a * b;
}
template <class V>
HWY_INLINE V MulAdd(V a, V b, V c) {
#if HWY_TARGET == HWY_AVX2
  return (V)_mm256_fmadd_ps((__m256)a, (__m256)b, (__m256)c);
#else
  return a * b + c;
#endif
}

template <class V>
using MaskOf = decltype(V{} < V{});
template <class V>
HWY_INLINE MaskOf<V> Eq(V a, V b) {
  return a == b;
}
template <class V>
HWY_INLINE MaskOf<V> Lt(V a, V b) {
  return a < b;
}
template <class V>
HWY_INLINE MaskOf<V> Le(V a, V b) {
  return a <= b;
}
template <class V>
HWY_INLINE MaskOf<V> Gt(V a, V b) {
  return a > b;
}
template <class V>
HWY_INLINE MaskOf<V> Ge(V a, V b) {
  return a >= b;
}
template <class V>
HWY_INLINE MaskOf<V> IsFinite(V v) {
  return v - v == V{};
}

template <class V>
HWY_INLINE V And(V a, V b) {
  return a & b;
}
template <class V>
HWY_INLINE V Or(V a, V b) {
  return a | b;
}
template <class V>
HWY_INLINE V Not(V v) {
  return ~v;
}
template <class M, class V>
HWY_INLINE V IfThenElse(M mask, V yes, V no) {
  return mask ? yes : no;
}
template <class V>
HWY_INLINE V Min(V a, V b) {
  return a < b ? a : b;
}

template <class Tag, class M>
HWY_INLINE Mask<Tag> RebindMask(Tag, M mask) {
  return mask;
}
template <class Tag, class M>
HWY_INLINE bool AllFalse(Tag, M mask) {
  std::uint64_t words[sizeof(M) / sizeof(std::uint64_t)], any = 0;
  std::memcpy(words, &mask, sizeof(M));
  for (const std::uint64_t word : words) any |= word;
  return any == 0;
}
template <class Tag, class M>
HWY_INLINE Vec<Tag> VecFromMask(Tag, M mask) {
  return (Vec<Tag>)mask;
}

template <class V>
HWY_INLINE auto GetLane(V v) {
  return v[0];
}
/// One value of all lanes, in every lane.
template <class Tag, class Join>
HWY_INLINE Vec<Tag> joined(Tag tag, Vec<Tag> v, Join join) {
  LaneOf<Tag> all = v[0];
  for (std::size_t i = 1; i < Tag::lanes; ++i) all = join(all, v[i]);
  return Set(tag, all);
}
template <class Tag>
HWY_INLINE Vec<Tag> SumOfLanes(Tag tag, Vec<Tag> v) {
  return joined(tag, v, [](auto a, auto b) HWY_ATTR { return a + b; });
}
template <class Tag>
HWY_INLINE Vec<Tag> MinOfLanes(Tag tag, Vec<Tag> v) {
  return joined(tag, v, [](auto a, auto b) HWY_ATTR { return a < b ? a : b; });
}
template <class Tag>
HWY_INLINE Vec<Tag> MaxOfLanes(Tag tag, Vec<Tag> v) {
  return joined(tag, v, [](auto a, auto b) HWY_ATTR { return a < b ? b : a; });
}

}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud::without_highway
HWY_AFTER_NAMESPACE();

#endif
