# SPDX-License-Identifier: BSD-3-Clause
"""Which way a thing lies from the camera, whatever stands between them."""
from __future__ import annotations

from math import tan
from typing import TYPE_CHECKING

import numpy as np

from ..simulation.base import Pose
from .scenario import XTION
from .things import Thing

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

BORDER = 1 / 8  # of the picture's width: real cameras return nothing there, near their picture's edges
_ROUND = np.linspace(0, 2 * np.pi, 64, endpoint=False)
_SIDE = np.linspace(-0.5, 0.5, 401)


def is_in_view(thing: Thing, time: float, robot: Pose) -> bool:
    """Whether all of it, or more than the border, lies in the picture at `time` [s]; from left to right."""
    ahead, left = _from_camera(_outline(thing, time), robot)
    half = tan(XTION.horizontal_view / 2) * ahead
    inside = (ahead > 0) & (np.abs(left) <= half)
    if inside.all() or not inside.any():
        return bool(inside.all())
    return bool(np.ptp(left[inside] / half[inside]) / 2 > BORDER)


def _outline(thing: Thing, time: float) -> NDArray[np.float64]:
    """(2, n) x and y [m] in the world."""
    length, width, _ = thing.size
    if thing.round:
        around = np.array([np.cos(_ROUND), np.sin(_ROUND)]) * length / 2
    else:
        end = np.full_like(_SIDE, 0.5)
        around = np.hstack([[_SIDE, end], [_SIDE, -end], [end, _SIDE], [-end, _SIDE]]) * [[length], [width]]
    return _turned(around, thing.at.yaw) + np.array([thing.place(time)]).T


def _from_camera(points: NDArray[np.float64], robot: Pose) -> NDArray[np.float64]:
    """(2, n) [m] ahead and to the left."""
    x, y, _ = XTION.mount
    return _turned(points - [[robot.x], [robot.y]], -robot.yaw) - [[x], [y]]


def _turned(points: NDArray[np.float64], yaw: float) -> NDArray[np.float64]:
    cos, sin = np.cos(yaw), np.sin(yaw)
    return np.array([[cos, -sin], [sin, cos]]) @ points
