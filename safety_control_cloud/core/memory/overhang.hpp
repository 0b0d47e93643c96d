// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "near_pixels.hpp"

namespace safety_control_cloud {

/// So much a pixel is before what is seen right below it, anywhere down to `lowest`, the lowest of its thing in its
/// slot [m]; 0 if nothing below it recedes at once, or by no more than noise or a thing that leans. Where it is as much
/// as `clear_overhang`, how much more is not told.
float overhang(const NearPixels& found, NearPixels::Index i, NearPixels::Index lowest);

}  // namespace safety_control_cloud
