# SPDX-License-Identifier: BSD-3-Clause
"""What the Xtion of a TurtleBot sees, as sensor_msgs/PointCloud2: organised, 160 x 120, with the floor in view.

Optical frame (x right, y down, z forward) [m]. The camera returns nothing at or below 0.4 m and at or beyond 5 m.
"""
from __future__ import annotations

from typing import Any, List, Sequence, Tuple

import numpy as np
from sensor_msgs.msg import PointCloud2, PointField

FRAME = "camera_depth_optical_frame"
WIDTH, HEIGHT = 160, 120
FOCAL = 138.56  # [pixel] 60 degrees wide
FLOOR = 0.2972  # [m] below the camera
POINT_STEP = 16

Board = Tuple[float, float, float, float, float]  # z, x_min, x_max, y_min, y_max [m]: upright, facing the camera
View = List[PointCloud2]  # what a camera sends in turn, as long as nothing changes before it


def wall(distance: float) -> Board:
    return distance, -9.0, 9.0, -9.0, FLOOR


def post(distance: float, x: float = 0.0, width: float = 0.1) -> Board:
    return distance, x - width / 2, x + width / 2, -1.0, FLOOR


def kerb(distance: float, height: float = 0.07) -> Board:
    return distance, -0.2, 0.2, FLOOR - height, FLOOR


def points_of(*boards: Board, width: int = WIDTH, height: int = HEIGHT) -> np.ndarray:
    """(height, width, 3) float32; NaN where nothing returns."""
    zoom = width / WIDTH
    x = (np.arange(width) - (width - 1) / 2) / (FOCAL * zoom)
    y = ((np.arange(height) - (height - 1) / 2) / (FOCAL * zoom))[:, None]
    with np.errstate(divide="ignore"):
        z = np.where(y > 0, FLOOR / y, np.inf) * np.ones(width)
    for distance, left, right, top, bottom in boards:
        hit = (x * distance >= left) & (x * distance <= right) & (y * distance >= top) & (y * distance <= bottom)
        z = np.where(hit, np.minimum(z, distance), z)
    z[(z <= 0.4) | (z >= 5.0)] = np.nan
    return np.stack([x * z, y * z, z], axis=2).astype(np.float32)


def cloud_of(points: np.ndarray, frame: str = FRAME, **claims: Any) -> PointCloud2:
    """A cloud of these points, (N, 3) or (height, width, 3); `claims` contradict them, as a broken driver does."""
    height, width = (1, *points.shape[:1]) if points.ndim == 2 else points.shape[:2]
    bytes_of = np.zeros((height * width, POINT_STEP // 4), np.float32)
    bytes_of[:, :3] = points.reshape(-1, 3)
    cloud = PointCloud2(
        height=height, width=width, fields=xyz(), is_bigendian=False, point_step=POINT_STEP,
        row_step=POINT_STEP * width, data=bytes_of.tobytes(), is_dense=False)
    cloud.header.frame_id = frame
    for name, value in claims.items():
        setattr(cloud, name, value)
    return cloud


def xyz(**changes: PointField) -> List[PointField]:
    """The fields x, y, z; `changes` puts others in their places."""
    fields = {name: PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate("xyz")}
    return list({**fields, **changes}.values())


def view_of(points: np.ndarray, frame: str = FRAME) -> View:
    """The points with a millimetre of noise, without which no two clouds of a real camera are."""
    random = np.random.default_rng(1)
    takes = [points * (1 + random.normal(0.0, 5e-4, points.shape[:-1] + (1,))) for _ in range(5)]
    return [cloud_of(take.astype(np.float32), frame) for take in takes]


def hall(*boards: Board, frame: str = FRAME) -> View:
    """A hall deeper than the camera's range, with these boards in it."""
    return view_of(points_of(*boards), frame)


def hall_with(z: float, pixels: Any, *boards: Board) -> View:
    """The hall, where these pixels (an index or a mask) report z [m] and nothing else of their points."""
    def altered(cloud: np.ndarray) -> np.ndarray:
        cloud[pixels] = (np.nan, np.nan, z)
        return cloud

    return view_of(altered(points_of(*boards)))


def pixels_of(board: Board) -> np.ndarray:
    """Where the board is seen: a mask of (height, width)."""
    return points_of(board)[..., 2] == np.float32(board[0])


def always(cloud: PointCloud2) -> Sequence[PointCloud2]:
    return [cloud]
