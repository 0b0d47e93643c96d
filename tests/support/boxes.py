# SPDX-License-Identifier: BSD-3-Clause
"""What a camera of 60 degrees sees of boxes and of the floor, by plain geometry: 160 x 120 pixels, from 0.4 to 5 m."""
from __future__ import annotations

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


def picture(camera: np.ndarray, boxes: Sequence[Box], random: np.random.Generator) -> np.ndarray:
    """(height, width, 3) [m] of boxes that stand in the frame in which the camera is placed, and of its floor."""
    focal = WIDTH / 2 / np.tan(HALF_VIEW)
    columns, rows = np.meshgrid(np.arange(WIDTH) - (WIDTH - 1) / 2, np.arange(HEIGHT) - (HEIGHT - 1) / 2)
    rays = np.stack([columns / focal, rows / focal, np.ones_like(rows)], axis=-1)
    ways = rays @ camera[:, :3].T
    with np.errstate(divide="ignore", invalid="ignore"):
        depth = np.where(ways[..., 2] < 0, -camera[2, 3] / ways[..., 2], np.inf)
        for box in boxes:
            sides = (np.reshape(box, (3, 2)) - camera[:, 3:])[None, None] / ways[..., None]
            enters, leaves = sides.min(axis=-1).max(axis=-1), sides.max(axis=-1).min(axis=-1)
            depth = np.where((enters <= leaves) & (enters > 0), np.minimum(depth, enters), depth)
    depth *= 1 + random.normal(0, 5e-4, depth.shape)
    depth[(depth <= RANGE[0]) | (depth >= RANGE[1])] = np.nan
    return (rays * depth[..., None]).astype(np.float32)
