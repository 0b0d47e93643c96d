# SPDX-License-Identifier: BSD-3-Clause
"""What the guard lets through, on the floor: the footprint, and what it sweeps until the robot stands. base_frame [m]."""
from __future__ import annotations

import json
from math import cos, hypot, pi, sin
from typing import TYPE_CHECKING, List

import numpy as np

from safety_control_cloud import core
from safety_control_cloud.view.moment import Motion

if TYPE_CHECKING:
    from numpy.typing import NDArray

AROUND, OUTLINES = 36, 6  # corners of a circle; outlines of a swept path


def footprint_of(settings: core.Settings) -> NDArray[np.float32]:
    """(N, 3) closed: its corners, or a circle with its margin."""
    try:
        corners = [(float(x), float(y)) for x, y in json.loads(settings.footprint or "[]")]
    except (TypeError, ValueError):
        corners = []
    if not corners:
        radius = settings.radius + settings.margin
        corners = [(radius * cos(2 * pi * i / AROUND), radius * sin(2 * pi * i / AROUND)) for i in range(AROUND)]
    return np.array([(x, y, 0.0) for x, y in [*corners, corners[0]]], np.float32)


def swept(settings: core.Settings, motion: Motion) -> List[NDArray[np.float32]]:
    """The footprint's outlines on the way until it stands; none where it does."""
    if not any(motion):
        return []
    whole, lasts = footprint_of(settings), stopping_time(settings, motion)
    return [_moved(whole, motion, lasts * i / OUTLINES) for i in range(1, OUTLINES + 1)]


def stopping_time(settings: core.Settings, motion: Motion) -> float:
    """[s] of the motion that it lasts until the robot stands, as in ros/output/guard_markers.cpp."""
    braking = max(hypot(*motion[:2]) / settings.base_deceleration, abs(motion[2]) / settings.angular_deceleration)
    return settings.latency + settings.base_reaction + 0.5 * braking


def _moved(outline: NDArray[np.float32], motion: Motion, time: float) -> NDArray[np.float32]:
    """The robot moves over the ground as resting ground moves past one that goes the other way."""
    on_floor = core.moved(outline[:, :2], (-motion[0], -motion[1], -motion[2]), time)
    return np.column_stack([on_floor, outline[:, 2]]).astype(np.float32)
