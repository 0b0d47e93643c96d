# SPDX-License-Identifier: BSD-3-Clause
"""Which parts of a scene returned something, and when: by what the camera measured, put where the robot truly was."""
from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...simulation.base import Pose
from ...simulation.sensor import rays
from ..scenario import XTION
from ..things import Thing
from .truth import LOWEST

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

CELL = 0.05  # [m]; a place returned if its cell, or one beside it, did
MEMORY_TIME, MEMORY_DISTANCE = 30.0, 1.5  # [s], [m] from base_footprint: what a guard is to remember
HIGHEST = 0.55  # [m] above the floor, the guard's band
_FARTHEST = 4.0  # [m]
_EACH = (4, 2)  # row, column: a post of 2 cm is still seen, and this is done for every picture
_SIDE = 10_000  # cells; a number that no row of them comes to


@dataclass(frozen=True)
class _Picture:
    time: float
    pose: Pose
    cells: NDArray[np.int64]  # sorted


@dataclass(frozen=True)
class Sighting:
    time: float  # [s]
    distance: float  # [m] from the robot then


class Sightings:
    """Of one drive."""

    def __init__(self) -> None:
        self._pictures: deque[_Picture] = deque()

    def note(self, depth: NDArray[np.float32], pose: Pose, now: float) -> None:
        cells, counts = np.unique(_cells_of(_returns(depth, pose)), return_counts=True)
        self._pictures.append(_Picture(now, pose, cells[counts > 1]))  # one alone may be a stray
        while self._pictures[0].time < now - 2 * MEMORY_TIME:
            self._pictures.popleft()

    def of(self, thing: Thing, point: tuple[float, float], now: float) -> list[Sighting]:
        """When the part of a thing returned that is at `point` [m] at `now` [s]; it moves with the thing."""
        at = thing.place(now)
        found = []
        for picture in self._pictures:
            then = thing.place(picture.time)
            place = np.array([point[0] + then[0] - at[0], point[1] + then[1] - at[1]])
            if np.isin(_cells_of(place + _AROUND), picture.cells).any():
                found.append(Sighting(picture.time, float(np.hypot(*(place - (picture.pose.x, picture.pose.y))))))
        return found


_AROUND = CELL * np.array([(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)])


def _cells_of(places: NDArray[np.float64]) -> NDArray[np.int64]:
    cells = np.floor(places / CELL).astype(np.int64)
    return cells[:, 0] * _SIDE + cells[:, 1]


def _returns(depth: NDArray[np.float32], pose: Pose) -> NDArray[np.float64]:
    """(n, 2) x, y [m] in the world, of the returns in the guard's band."""
    rows, columns = _EACH
    across, down = rays(XTION)
    z = depth[::rows, ::columns]
    x, y, height = XTION.mount
    up = height - z * down[::rows, None]
    kept = (up >= LOWEST) & (up <= HIGHEST) & (z < _FARTHEST)
    ahead, left = z[kept] + x, y - (z * across[::columns])[kept]
    c, s = np.cos(pose.yaw), np.sin(pose.yaw)
    return np.column_stack([pose.x + c * ahead - s * left, pose.y + s * ahead + c * left]).astype(np.float64)
