# SPDX-License-Identifier: BSD-3-Clause
"""What a camera of 60 degrees sees of boxes and of the floor, by plain geometry: 160 x 120 pixels, from 0.4 to 5 m."""
from __future__ import annotations

from functools import lru_cache, reduce
from typing import Sequence, Tuple

import numpy as np

WIDTH, HEIGHT, HALF_VIEW = 160, 120, np.radians(30)
RANGE = (0.4, 5.0)  # [m]

Box = Tuple[float, float, float, float, float, float]  # x, x, y, y, z, z [m], from the lesser each


# A room of 6 x 6 m without a wall behind, around the frame's origin.
ROOM: Tuple[Box, ...] = (
    (3.0, 3.1, -3.0, 3.0, 0.0, 2.5), (-3.0, 3.0, 3.0, 3.1, 0.0, 2.5), (-3.0, 3.0, -3.1, -3.0, 0.0, 2.5))


def placing(place: Sequence[float], heading: float = 0.0, up: float = 0.0) -> np.ndarray:
    """(3, 4) of an optical frame that looks so far to the left and up [rad], in the frame in which it is there [m]."""
    c, s = np.cos(heading), np.sin(heading)
    level = np.array([[s, 0, c], [-c, 0, s], [0, -1, 0]])
    c, s = np.cos(up), np.sin(up)
    return np.column_stack([level @ [[1, 0, 0], [0, c, -s], [0, s, c]], place])


@lru_cache(maxsize=None)
def _rays() -> np.ndarray:
    """(3, height, width) in the camera's frame, as long as its depth; read only."""
    focal = WIDTH / 2 / np.tan(HALF_VIEW)
    columns, rows = np.meshgrid(np.arange(WIDTH) - (WIDTH - 1) / 2, np.arange(HEIGHT) - (HEIGHT - 1) / 2)
    rays = np.stack([columns / focal, rows / focal, np.ones_like(rows)])
    rays.setflags(write=False)
    return rays


def picture(camera: np.ndarray, boxes: Sequence[Box], random: np.random.Generator) -> np.ndarray:
    """(height, width, 3) [m] of boxes that stand in the frame in which the camera is placed, and of its floor.

    Axis by axis, over whole pictures: thousands of them are drawn.
    """
    rays = _rays()
    ways = np.tensordot(camera[:, :3], rays, axes=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        depth = np.where(ways[2] < 0, -camera[2, 3] / ways[2], np.inf)
        for box in boxes:
            sides = [(np.subtract(box[2 * axis:2 * axis + 2], camera[axis, 3])[:, None, None] / ways[axis]) for axis in range(3)]
            enters = reduce(np.maximum, [np.minimum(*two) for two in sides])
            leaves = reduce(np.minimum, [np.maximum(*two) for two in sides])
            depth = np.where((enters <= leaves) & (enters > 0), np.minimum(depth, enters), depth)
    depth *= 1 + random.normal(0, 5e-4, depth.shape)
    depth[(depth <= RANGE[0]) | (depth >= RANGE[1])] = np.nan
    return np.moveaxis(rays * depth, 0, -1).astype(np.float32, order="C")
