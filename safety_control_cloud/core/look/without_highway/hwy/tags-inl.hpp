// SPDX-License-Identifier: BSD-3-Clause
// How long vectors are, and how they come to be; part of highway.h.
#if defined(SAFETY_CONTROL_CLOUD_TAGS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_TAGS_INL
#undef SAFETY_CONTROL_CLOUD_TAGS_INL
#else
#define SAFETY_CONTROL_CLOUD_TAGS_INL
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "targets.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud::without_highway {
namespace HWY_NAMESPACE {

constexpr std::size_t register_size = HWY_TARGET == HWY_AVX2 ? 32 : 16;  // [byte]

/// A tag: so many lanes of a type.
template <class T, std::size_t N>
struct Simd {
  using Lane = T;
  static constexpr std::size_t lanes = N;
};

template <class T, std::size_t N>
using FixedTag = Simd<T, N>;
template <class T>
using ScalableTag = Simd<T, register_size / sizeof(T)>;
template <class Tag>
using LaneOf = typename Tag::Lane;
template <class Tag>
using Half = Simd<LaneOf<Tag>, Tag::lanes / 2>;
template <class T, class Tag>
using Rebind = Simd<T, Tag::lanes>;
template <class T, class Tag>
using Repartition = Simd<T, Tag::lanes * sizeof(LaneOf<Tag>) / sizeof(T)>;
template <class Tag>
using RebindToSigned = Rebind<std::int32_t, Tag>;
template <class Tag>
using RebindToUnsigned = Rebind<std::uint32_t, Tag>;

/// What is shorter than 16 bytes lies in a vector that is not: of one with eight, older compilers make MMX's.
template <class T, std::size_t N>
struct Register {
  static constexpr std::size_t size = N * sizeof(T) < 16 ? 16 : N * sizeof(T);
  typedef T Type __attribute__((vector_size(size)));
};
template <class Tag>
using Vec = typename Register<LaneOf<Tag>, Tag::lanes>::Type;
template <class Tag>
using Mask = Vec<RebindToSigned<Tag>>;  ///< all ones or zero, in each lane

template <class Tag>
constexpr std::size_t MaxLanes(Tag) {
  return Tag::lanes;
}
template <class Tag>
constexpr std::size_t Lanes(Tag) {
  return Tag::lanes;
}

template <class V, class T, std::size_t... I>
HWY_INLINE V repeated(T value, std::index_sequence<I...>) {
  return V{(static_cast<void>(I), value)...};
}
template <class Tag>
HWY_INLINE Vec<Tag> Set(Tag, LaneOf<Tag> value) {
  return repeated<Vec<Tag>>(value, std::make_index_sequence<Tag::lanes>());
}
template <class Tag>
HWY_INLINE Vec<Tag> Zero(Tag) {
  return Vec<Tag>{};
}
template <class V, class T, std::size_t... I>
HWY_INLINE V counted(std::index_sequence<I...>) {
  return V{static_cast<T>(I)...};
}
template <class Tag>
HWY_INLINE Vec<Tag> Iota(Tag tag, LaneOf<Tag> first) {
  return Set(tag, first) + counted<Vec<Tag>, LaneOf<Tag>>(std::make_index_sequence<Tag::lanes>());
}

/// From anywhere.
template <class Tag>
HWY_INLINE Vec<Tag> LoadU(Tag, const void* from) {
  if constexpr (sizeof(LaneOf<Tag>) * Tag::lanes == sizeof(std::uint64_t)) {
    typedef std::uint64_t Words __attribute__((vector_size(16)));
    std::uint64_t word;
    std::memcpy(&word, from, sizeof(word));
    return (Vec<Tag>)Words{word, 0};
  } else {
    Vec<Tag> loaded;
    static_assert(sizeof(loaded) == sizeof(LaneOf<Tag>) * Tag::lanes);
    std::memcpy(&loaded, from, sizeof(loaded));
    return loaded;
  }
}
template <class Tag>
HWY_INLINE void StoreU(Vec<Tag> v, Tag, LaneOf<Tag>* to) {
  std::memcpy(to, &v, sizeof(v));
}
template <class Tag>
HWY_INLINE Vec<Tag> Load(Tag tag, const LaneOf<Tag>* from) {
  return LoadU(tag, from);
}

}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud::without_highway
HWY_AFTER_NAMESPACE();

#endif
