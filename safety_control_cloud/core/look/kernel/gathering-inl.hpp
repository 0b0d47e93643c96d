// SPDX-License-Identifier: BSD-3-Clause
// Where returns lie, and in which cells; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_GATHERING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_GATHERING_INL
#undef SAFETY_CONTROL_CLOUD_GATHERING_INL
#else
#define SAFETY_CONTROL_CLOUD_GATHERING_INL
#endif

#include <cstddef>
#include <vector>

#include "found-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

/// Lists where the returns in a region lie.
template <class Placing>
struct Gathering {
  Walls walls;
  Bounds bounds;
  Placing place;
  Places* found;
  std::size_t size = 0;

  HWY_INLINE Gathering(const Outlook& outlook, const Region& region, Places& places)
      : walls(outlook.corridor), bounds(region), place(outlook), found(&places) {}

  HWY_INLINE void go_on_from(const Gathering& other) { size = other.size; }

  template <class Source>
  HWY_INLINE void take(const Source& points, std::size_t column, std::size_t) {
    note(points.at(column));
  }

  HWY_INLINE void note(const Points& points) { note_placed(place(points), is_return(points, walls)); }
  HWY_INLINE void note_placed(const Points& placed, Mask returning) {
    const Mask within = hn::And(returning, bounds.hold(placed));
    if (hn::AllFalse(Floats(), within)) return;
    const Chosen chosen(within);
    chosen.write(placed.x, found->x.data() + size);
    chosen.write(placed.y, found->y.data() + size);
    chosen.write(placed.z, found->z.data() + size);
    size += chosen.size();
  }
};

/// Counts and gathers the same points, which are loaded once.
template <class Count, class Gather>
struct Both {
  Count counting;
  Gather gathering;

  HWY_INLINE Both(const Count& count, const Gather& gather) : counting(count), gathering(gather) {}

  HWY_INLINE void go_on_from(const Both& other) {
    counting.go_on_from(other.counting);
    gathering.go_on_from(other.gathering);
  }

  template <class Source>
  HWY_INLINE void take(const Source& source, std::size_t column, std::size_t) {
    const Points points = source.at(column);
    counting.note(points);
    gathering.note(points);
  }
};

/// And places them once.
template <class Count, class Gather>
struct BothAlike : Both<Count, Gather> {
  /// Not inherited: such a one would not be compiled for the instruction set.
  HWY_INLINE BothAlike(const Count& count, const Gather& gather) : Both<Count, Gather>(count, gather) {}

  template <class Source>
  HWY_INLINE void take(const Source& source, std::size_t column, std::size_t) {
    const auto found = this->counting.note(source.at(column));
    this->gathering.note_placed(found.placed, found.returning);
  }
};

/// A grid in every lane.
struct Columns {
  Float extent, per_metre;

  explicit HWY_INLINE Columns(const CellGrid& grid) : extent(all(grid.extent)), per_metre(all(grid.per_metre)) {}

  HWY_INLINE Mask hold(Float along) const {
    return hn::And(hn::Gt(along, hn::Sub(hn::Zero(Floats()), extent)), hn::Lt(along, extent));
  }
  /// A whole number, as a float.
  HWY_INLINE Float at(Float along, Mask held) const {
    const Float inside = hn::IfThenElse(held, hn::Add(along, extent), hn::Zero(Floats()));
    return hn::ConvertTo(Floats(), hn::ConvertTo(Signed(), hn::Mul(inside, per_metre)));
  }
};

/// The largest grid first, so that a smaller one has the last word. Floats hold the numbers of cells: not every machine
/// multiplies vectors of integers.
void find_cells(const Places& places, const std::vector<CellGrid>& grids, CellNumbers& cells) {
  for (std::size_t i = 0; i < places.size; i += lanes) {
    const Float x = hn::LoadU(Floats(), places.z.data() + i);
    const Float y = hn::Sub(hn::Zero(Floats()), hn::LoadU(Floats(), places.x.data() + i));
    auto cell = hn::Zero(Signed());
    for (auto grid = grids.rbegin(); grid != grids.rend(); ++grid) {
      const Columns columns(*grid);
      const Mask held = hn::And(columns.hold(x), columns.hold(y));
      if (hn::AllFalse(Floats(), held)) break;
      const Float rows = hn::Mul(columns.at(y, held), all(static_cast<float>(grid->side)));
      const auto in_grid = hn::ConvertTo(Signed(), hn::Add(rows, columns.at(x, held)));
      const auto number = hn::Add(in_grid, hn::Set(Signed(), grid->first));
      cell = hn::IfThenElse(hn::RebindMask(Signed(), held), number, cell);
    }
    hn::StoreU(cell, Signed(), cells.data() + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
