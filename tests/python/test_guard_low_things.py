# SPDX-License-Identifier: BSD-3-Clause
"""A guarded robot before what is lower than its camera, or higher: the end of that leaves the picture."""
from __future__ import annotations

import numpy as np
import pytest

from safety_control_cloud import core
from safety_control_cloud.simulation.hull import BODY_RADIUS
from safety_control_cloud.simulation.sensor import Xtion

WIDTH, HEIGHT = 120, 90
FOCAL = WIDTH / 2 / np.tan(np.radians(30))  # [px]
CAMERA_X, _, CAMERA_Z = Xtion().mount  # [m] in base_footprint
CAMERA = np.array([[0, 0, 1, CAMERA_X], [-1, 0, 0, 0], [0, -1, 0, CAMERA_Z]], float)
PERIOD = 0.05  # [s]
RIGHT, DOWN = np.meshgrid((np.arange(WIDTH) - (WIDTH - 1) / 2) / FOCAL, (np.arange(HEIGHT) - (HEIGHT - 1) / 2) / FOCAL)


def picture(begins: float, low: float, high: float) -> np.ndarray:
    """(H, W, 3) [m] of the floor and of a thing between these heights, 30 cm wide and 1 m long, so far before the camera."""
    nearest = high if high < CAMERA_Z else low  # of its two level sides, the one that the camera sees
    with np.errstate(divide="ignore"):
        floor = np.where(DOWN > 0, CAMERA_Z / DOWN, np.inf)
        level = (CAMERA_Z - nearest) / DOWN
    reaches = CAMERA_Z - DOWN * begins
    enters = np.where((low <= reaches) & (reaches <= high), begins, np.where(level > begins, level, np.inf))
    side = 0.15 / np.maximum(np.abs(RIGHT), 1e-9)  # where a ray leaves the thing's width
    z = np.where((enters <= side) & (enters < np.minimum(floor, begins + 1.0)), enters, floor)
    z = np.where((z > 0.4) & (z < 5.0), z, np.nan)
    return np.stack([z * RIGHT, z * DOWN, z], -1).astype(np.float32)


FLOOR = picture(10.0, 0.0, 0.1)


def gap_left(low: float, high: float, speed: float, odometry: bool, lasts: float = 15.0, gone: float = np.inf, **settings) -> float:
    """[m] before a thing 0.9 m ahead, between these heights, for who drives at it for so long [s]; it is gone then."""
    control = core.GuardControl(core.Settings(mode="guard", **settings))
    x, end = 0.0, 0.9 + BODY_RADIUS  # [m] of the robot, and of what stands there
    for i in range(round(lasts / PERIOD)):
        now = i * PERIOD
        if odometry:
            control.note_odometry(1000.0 + now, (x, 0.0, 0.0), (0.0, 0.0, 0.0))
        seen = picture(end - x - CAMERA_X, low, high) if now < gone else FLOOR
        control.see(seen, now=now, stamp=1000.0 + now, ros_now=1000.0 + now, camera=CAMERA)
        control.want((speed if now > 1.0 else 0.0, 0.0, 0.0), (0.0, 0.0, 0.0), now=now, ros_now=1000.0 + now)
        x += PERIOD * control.answer(now=now, ros_now=1000.0 + now).given.linear[0]
    return end - BODY_RADIUS - x


@pytest.mark.parametrize("odometry", [True, False])
@pytest.mark.parametrize("speed", [0.1, 0.2, 0.4])
@pytest.mark.parametrize("height", [0.09, 0.11, 0.12])
def test_the_end_of_a_low_thing_stays_where_it_was_below_the_picture(height, speed, odometry):
    assert 0.03 < gap_left(0.0, height, speed, odometry) < 0.4


@pytest.mark.parametrize("odometry", [True, False])
@pytest.mark.parametrize("speed", [0.1, 0.2, 0.4])
@pytest.mark.parametrize("low", [0.49, 0.52])
def test_the_edge_of_a_table_stays_where_it_was_above_the_picture(low, speed, odometry):
    assert 0.03 < gap_left(low, low + 0.03, speed, odometry) < 0.4


@pytest.mark.parametrize("odometry", [True, False])
@pytest.mark.parametrize("low, high", [(0.0, 0.09), (0.0, 0.12), (0.49, 0.52), (0.52, 0.55)])
def test_one_end_is_kept_as_long_as_the_other_is_shown(low, high, odometry):
    for memory_time in (5.0, 12.0):
        at_first = gap_left(low, high, 0.2, odometry, memory_time=memory_time)
        assert gap_left(low, high, 0.2, odometry, 40.0, memory_time=memory_time) == pytest.approx(at_first, abs=0.005)


@pytest.mark.parametrize("odometry", [True, False])
def test_of_a_thing_that_is_gone_no_end_is_kept(odometry):
    """The robot had stood before it for twice as long as the memory holds."""
    assert gap_left(0.0, 0.1, 0.2, odometry, 18.0, gone=15.0, memory_time=5.0) > 0.03
    assert gap_left(0.0, 0.1, 0.2, odometry, 23.0, gone=15.0, memory_time=5.0) < 0.0


def test_the_end_of_a_beam_stays_where_it_was_for_who_coasts_between_bursts():
    control = core.GuardControl(core.Settings(mode="guard"))
    x, speed, end = 0.0, 0.0, 0.9 + BODY_RADIUS  # [m], [m/s] of the robot, [m] of what stands there
    for i in range(300):
        now = i * PERIOD
        control.see(picture(end - x - CAMERA_X, 0.0, 0.126), now=now, stamp=1000.0 + now, ros_now=1000.0 + now, camera=CAMERA)
        control.want((0.7 if now > 1.0 and i % 5 == 0 else 0.0, 0.0, 0.0), (0.0, 0.0, 0.0), now=now, ros_now=1000.0 + now)
        told = control.answer(now=now, ros_now=1000.0 + now).given.linear[0]
        speed = max(told, speed - 0.36 * PERIOD)  # it gains speed at once
        x += PERIOD * speed
    assert 0.03 < end - BODY_RADIUS - x < 0.4
