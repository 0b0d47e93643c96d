# SPDX-License-Identifier: BSD-3-Clause
"""A guarded robot with odometry before what is lower than its camera: the end of that leaves the picture below."""
from __future__ import annotations

import numpy as np
import pytest

from safety_control_cloud import core
from safety_control_cloud.simulation.hull import BODY_RADIUS

WIDTH, HEIGHT = 120, 90
FOCAL = WIDTH / 2 / np.tan(np.radians(30))  # [px]
CAMERA_X, CAMERA_Z = -0.087, 0.2972  # [m] in base_footprint
CAMERA = np.array([[0, 0, 1, CAMERA_X], [-1, 0, 0, 0], [0, -1, 0, CAMERA_Z]], float)
PERIOD = 0.05  # [s]
RIGHT, DOWN = np.meshgrid((np.arange(WIDTH) - (WIDTH - 1) / 2) / FOCAL, (np.arange(HEIGHT) - (HEIGHT - 1) / 2) / FOCAL)


def picture(begins: float, height: float) -> np.ndarray:
    """(H, W, 3) [m] of the floor and of a thing on it, 30 cm wide and 1 m long, that begins so far before the camera."""
    with np.errstate(divide="ignore"):
        floor = np.where(DOWN > 0, CAMERA_Z / DOWN, np.inf)
        top = np.where(DOWN > 0, (CAMERA_Z - height) / DOWN, np.inf)
    side = 0.15 / np.maximum(np.abs(RIGHT), 1e-9)  # where a ray leaves the thing's width
    enters = np.where(DOWN * begins >= CAMERA_Z - height, begins, top)
    z = np.where((enters <= side) & (enters < np.minimum(floor, begins + 1.0)), enters, floor)
    z = np.where((z > 0.4) & (z < 5.0), z, np.nan)
    return np.stack([z * RIGHT, z * DOWN, z], -1).astype(np.float32)


@pytest.mark.parametrize("speed", [0.1, 0.2, 0.4])
@pytest.mark.parametrize("height", [0.09, 0.11, 0.12])
def test_the_end_of_a_low_thing_stays_where_it_was_below_the_picture(height, speed):
    control = core.GuardControl(core.Settings(mode="guard"))
    x, end = 0.0, 0.9 + BODY_RADIUS  # [m] of the robot, and of what stands there
    for i in range(300):
        now = i * PERIOD
        control.note_odometry(1000.0 + now, (x, 0.0, 0.0), (0.0, 0.0, 0.0))
        control.see(picture(end - x - CAMERA_X, height), now=now, stamp=1000.0 + now, ros_now=1000.0 + now, camera=CAMERA)
        control.want((speed if now > 1.0 else 0.0, 0.0, 0.0), (0.0, 0.0, 0.0), now=now, ros_now=1000.0 + now)
        x += PERIOD * control.answer(now=now, ros_now=1000.0 + now).given.linear[0]
    assert 0.03 < end - BODY_RADIUS - x < 0.4
