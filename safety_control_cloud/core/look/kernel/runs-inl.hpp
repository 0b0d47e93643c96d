// SPDX-License-Identifier: BSD-3-Clause
// Whichever form a run's points have; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_RUNS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_RUNS_INL
#undef SAFETY_CONTROL_CLOUD_RUNS_INL
#else
#define SAFETY_CONTROL_CLOUD_RUNS_INL
#endif

#include "clouds-inl.hpp"
#include "depths-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

/// Lets the visitor take the points of a run in their order.
template <class Visitor>
void visit_run(const Run& run, Visitor& visitor) {
  if (const auto* cloud = std::get_if<CloudView>(&run.points)) return visit(*cloud, run.followed, visitor);
  visit(std::get<DepthView>(run.points), run.followed, visitor);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
