# SPDX-License-Identifier: BSD-3-Clause
"""Clouds as the viewer takes them: a depth image has a quarter of the bytes of its points."""
from __future__ import annotations

from math import ceil, sqrt
from typing import TYPE_CHECKING, Optional

import numpy as np

from safety_control_cloud.pinhole import Pinhole
from safety_control_cloud.view.moment import Depth, Picture, Points

if TYPE_CHECKING:
    from numpy.typing import NDArray

FARTHEST = 65.535  # [m] that 16 bits hold
OFF = 0.5  # [px] by which the rays of a camera may miss their pixels
FEW = 100  # returns that do not tell a camera
SOME = 5000  # of the returns tell it as well as all


def picture_of(points: NDArray[np.float32], before: Optional[Picture] = None) -> Picture:
    """Of points (height, width, 3) [m]: a depth image where their rays are those of a pinhole camera, else the points.

    One that returns too little to tell is of the same camera as the picture before.
    """
    camera = camera_of(points) if points.shape[0] > 1 and points.shape[1] > 1 else None
    if not camera and isinstance(before, Depth) and before.millimetres.shape == points.shape[:2] and _is_empty(points):
        camera = before.camera
    if camera:
        return depth_of(points[..., 2], camera)
    flat = points.reshape(-1, 3)
    return Points(np.ascontiguousarray(flat[np.isfinite(flat).all(axis=1)], np.float32))


def _is_empty(points: NDArray[np.float32]) -> bool:
    return int(np.isfinite(points).all(axis=2).sum()) < FEW


def depth_of(metres: NDArray[np.float32], camera: Pinhole) -> Depth:
    with np.errstate(invalid="ignore"):
        seen = (metres > 0) & (metres < FARTHEST)
        return Depth(np.where(seen, 1000.0 * metres + 0.5, 0.0).astype(np.uint16), camera)


def thinned(picture: Picture, most: int) -> Picture:
    """Every so manyth pixel or point, so that `most` are left."""
    if isinstance(picture, Points):
        return Points(picture.xyz[:: -(-len(picture.xyz) // most) or 1])
    step = ceil(sqrt(picture.millimetres.size / most))
    lens = picture.camera
    return Depth(np.ascontiguousarray(picture.millimetres[::step, ::step]),
                 Pinhole(lens.fx / step, lens.fy / step, lens.cx / step, lens.cy / step))


def camera_of(points: NDArray[np.float32]) -> Optional[Pinhole]:
    """Whose rays through its pixels these are; None if there is none."""
    v, u = np.nonzero(np.isfinite(points).all(axis=2) & (points[..., 2] > 0))
    if len(u) < FEW:
        return None
    step = max(len(u) // SOME, 1)
    v, u = v[::step], u[::step]
    x, y, z = points[v, u].astype(np.float64).T
    across, down = _line(x / z, u), _line(y / z, v)
    if across is None or down is None:
        return None
    return Pinhole(across[0], down[0], across[1], down[1])


def _line(slopes: NDArray[np.float64], pixels: NDArray[np.int64]) -> Optional[NDArray[np.float64]]:
    """Focal length and centre, if a line goes through all."""
    if np.ptp(pixels) < 2 or np.ptp(slopes) < 1e-3:
        return None
    fitted = np.polyfit(slopes, pixels, 1)
    off = np.abs(np.polyval(fitted, slopes) - pixels).max()
    return fitted if off < OFF and fitted[0] > 0 else None
