# SPDX-License-Identifier: BSD-3-Clause
"""Recorded clouds and depth images as arrays, to be looked at by people."""
from __future__ import annotations

from typing import Optional

import numpy as np

from safety_control_cloud.pinhole import Pinhole
from safety_control_cloud.replay.eyes import Sighting
from safety_control_cloud.replay.wire import Image, Points

FLOATS = {7: "f4", 8: "f8"}  # by sensor_msgs/PointField's codes


def points_of(sighting: Sighting) -> Optional[np.ndarray]:
    """(height, width, 3) float32 [m], optical frame; None where the core too cannot read them."""
    if sighting.cloud.unreadable is not None:
        return None
    if isinstance(sighting.content, Points):
        return xyz_of(sighting.content)
    assert sighting.camera
    return _projected(metres_of(sighting.content), sighting.camera)


def metres_of(image: Image) -> np.ndarray:
    """(height, width) float32; NaN: no return."""
    kind = "u2" if image.encoding == "16UC1" else "f4"
    order = ">" if image.is_bigendian else "<"
    pixels = np.ndarray((image.height, image.width), order + kind, image.data, 0, (image.step, int(kind[1])))
    if kind == "f4":
        return pixels.astype(np.float32)
    return np.where(pixels == 0, np.nan, pixels / 1000.0).astype(np.float32)


def xyz_of(points: Points) -> np.ndarray:
    """(height, width, 3) float32 [m]. Raises KeyError or ValueError where the layout contradicts itself."""
    order, by_name = ">" if points.is_bigendian else "<", {field[0]: field for field in points.fields}
    columns = []
    for name in "xyz":
        _, offset, code, _ = by_name[name]
        columns.append(np.ndarray(
            (points.height, points.width), order + FLOATS[code], points.data, offset, (points.row_step, points.point_step)))
    return np.stack(columns, axis=-1).astype(np.float32)


def _projected(z: np.ndarray, camera: Pinhole) -> np.ndarray:
    v, u = np.indices(z.shape, np.float32)
    return np.stack([(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z], axis=-1).astype(np.float32)
