# SPDX-License-Identifier: BSD-3-Clause
"""What a camera lost before a restart, after which places are told in another frame: the camera itself has not moved."""
from __future__ import annotations

import numpy as np
import pytest
from boxes import ROOM, picture, placing

from safety_control_cloud import core

HEIGHT, RATE = 0.2972, 20.0  # [m] of a TurtleBot's camera, [Hz]
ALONE = core.Settings(mode="drive", x_min=-0.3, x_max=0.3, y_min=-0.5, y_max=HEIGHT - 0.05)
RAIL = (0.3, 0.36)  # [m] from, to


def lost_alone(camera: np.ndarray, random: np.random.Generator) -> list[str]:
    control = core.SafetyControl(ALONE)
    for now in np.arange(0.0, 3.0, 1 / RATE):
        view = picture(camera, (rail_at(max(0.213, 0.9 - 0.5 * now)), *ROOM), random)
        decision = control.decide(view, now=now)
    assert decision.speed == 0.0, decision.reason
    return control.remembered()


def rail_at(ahead: float):
    return (ahead, ahead + 0.04, -0.25, 0.25, *RAIL)


@pytest.mark.parametrize("degrees", [-5, 0, 5, 8, 10, 12])
def test_a_guard_stands_for_what_was_lost_in_the_cameras_own_frame_until_that_has_gone(degrees):
    random = np.random.default_rng(0)
    camera = placing((-0.087, 0.0, HEIGHT), up=np.radians(degrees))
    guard = core.GuardControl(core.Settings(mode="guard"))
    assert guard.recall(lost_alone(camera, random))
    for now in np.arange(10.0, 16.0, 1 / RATE):
        boxes = (rail_at(0.213), *ROOM) if now < 13.0 else ROOM
        guard.see(picture(camera, boxes, random), now=now, stamp=now, ros_now=now, camera=camera)
        guard.want((0.2, 0.0, 0.0), (0.0, 0.0, 0.0), now=now, ros_now=now)
        answer = guard.answer(now=now, ros_now=now)
        if now < 13.0:
            assert answer.factor == 0.0, f"at {now:.2f} s: {answer.reason}"
    assert answer.factor > 0.0, answer.reason
