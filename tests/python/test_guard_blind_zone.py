# SPDX-License-Identifier: BSD-3-Clause
"""A guarded robot without odometry that turns toward what it has passed: ahead by then, nearer than its camera can see."""
from __future__ import annotations

from typing import List

import numpy as np
import pytest
from boxes import Box, picture, placing

from safety_control_cloud import core
from safety_control_cloud.simulation.hull import BODY_RADIUS

CAMERA = np.array([0.1, 0.0, 0.32])  # [m] in base_footprint: what is nearer than 0.32 m before the hull is not seen
PERIOD = 0.05  # [s]
ROOM = ((4.0, 4.1, -5.0, 5.0, 0.0, 2.0), (-3.0, 4.0, -3.1, -3.0, 0.0, 2.0))
ASIDE = 0.28  # [m] from the robot's middle to the side of the bag
BAG = (0.9, 1.0, -ASIDE - 0.12, -ASIDE, 0.31, 0.65)  # hangs


class Drive:
    """Of a robot that begins in the origin and does what it is given."""

    def __init__(self, boxes: List[Box]) -> None:
        self.control = core.GuardControl(core.Settings(mode="guard"))
        self.boxes, self.random = boxes, np.random.default_rng(0)
        self.now, self.place, self.heading = 0.0, np.zeros(2), 0.0

    def is_told(self, ahead: float, turn: float) -> float:
        """For one picture; the speed ahead that is left of it [m/s]."""
        self.now += PERIOD
        times = {"now": self.now, "ros_now": 1000.0 + self.now}
        c, s = np.cos(self.heading), np.sin(self.heading)
        camera = placing((*(self.place + CAMERA[0] * np.array([c, s])), CAMERA[2]), self.heading)
        self.control.see(picture(camera, self.boxes, self.random), stamp=times["ros_now"], camera=placing(CAMERA), **times)
        self.control.want((ahead, 0.0, 0.0), (0.0, 0.0, turn), **times)
        given = self.control.answer(**times).given
        self.place += PERIOD * given.linear[0] * np.array([c, s])
        self.heading += PERIOD * given.angular[2]
        return given.linear[0]

    def gap_to(self, box: Box) -> float:
        """[m]"""
        nearest = np.clip(self.place, (box[0], box[2]), (box[1], box[3]))
        return float(np.hypot(*(nearest - self.place))) - BODY_RADIUS


def turned_toward_the_bag(drive: Drive, ahead: float) -> Drive:
    """It slows down first, as who knows what he does; what is off by more than 20 cm does not count there."""
    while (left := BAG[0] - ahead - drive.place[0]) > 0.005:
        drive.is_told(min(0.3, left + 0.02), 0.0)
    while drive.heading > -np.arctan2(ASIDE + 0.03, ahead):
        drive.is_told(0.0, -0.8)
    for _ in range(20):
        drive.is_told(0.0, 0.0)
    return drive


@pytest.mark.parametrize("ahead, speed", [(0.2, 0.3), (0.27, 0.7)])
def test_what_it_turned_toward_stays_where_the_camera_cannot_see_it(ahead, speed):
    drive = turned_toward_the_bag(Drive([*ROOM, BAG]), ahead)
    for _ in range(40):
        drive.is_told(speed, 0.0)
        assert drive.gap_to(BAG) > 0.0


def test_it_may_go_where_nothing_was():
    drive = turned_toward_the_bag(Drive([*ROOM]), 0.2)
    assert [drive.is_told(0.5, 0.0) for _ in range(20)] == [0.5] * 20
