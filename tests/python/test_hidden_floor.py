# SPDX-License-Identifier: BSD-3-Clause
"""What came in from the side nearer than the camera can see, and hides the near floor, while the camera turns away."""
from __future__ import annotations

import numpy as np
import pytest
from boxes import ROOM, picture, placing

from safety_control_cloud import core

CAMERA = np.array([-0.087, 0.0, 0.2972])  # [m] in base_footprint
RATE, TURNS, RETURNS = 10.0, 2.5, 4.0  # [Hz], and [s] at which the head begins to move
SETTINGS = {
    "drive": core.Settings(mode="drive", target_frame="base_footprint", bottom=0.05, top=0.8, left=0.3, right=0.3),
    "guard": core.Settings(mode="guard"),
}


class Robot:
    """Wants to drive at 0.2 m/s."""

    def __init__(self, mode: str):
        self.mode = mode
        self.control = (core.SafetyControl if mode == "drive" else core.GuardControl)(SETTINGS[mode])

    def sees(self, view: np.ndarray, camera: np.ndarray, now: float):
        """Its speed [m/s], and why."""
        if self.mode == "drive":
            decision = self.control.decide(view, now=now, camera=camera)
            return decision.speed, decision.reason
        self.control.see(view, now=now, stamp=now, ros_now=now, camera=camera)
        self.control.want((0.2, 0.0, 0.0), (0.0, 0.0, 0.0), now=now, ros_now=now)
        answer = self.control.answer(now=now, ros_now=now)
        return answer.given.linear[0], answer.reason

    def restart(self):
        text = self.control.remembered()
        self.control = type(self.control)(SETTINGS[self.mode])
        assert self.control.recall(text)


def drive(mode: str, pan: float, up: float, wide: float, high: float, leaves=np.inf, returns=np.inf, restarts=np.inf,
          down: float = 0.0, speed: float = 1.0, until: float = 5.0):
    """What the robot does, and when [s]: a box slides in until 1.7 s at most, 0.3 m before the camera, which looks so
    far down and turns to the left and up [rad], and back; the box slides away again."""
    random = np.random.default_rng(0)
    robot = Robot(mode)
    for now in np.arange(1 / RATE, until, 1 / RATE):
        turned = min(1.0, speed * max(0.0, now - TURNS)) - min(1.0, speed * max(0.0, now - returns))
        camera = placing(CAMERA, turned * pan, turned * up - down)
        aside = 1.8 - min(1.8, 1.5 * max(0.0, now - 0.5)) + 1.5 * max(0.0, now - leaves)
        box = (0.213, 0.313, aside - wide / 2, aside + wide / 2, 0.0, high)
        if restarts <= now:
            robot.restart()
            restarts = np.inf
        yield now, *robot.sees(picture(camera, (box, *ROOM), random), camera, now)


def stands(drive, before: float = np.inf):
    for now, speed, why in drive:
        if 2.2 < now < before:
            assert speed == 0.0, f"after {now:.2f} s: {why}"
    return speed, why


@pytest.mark.parametrize("mode", SETTINGS)
@pytest.mark.parametrize(("pan", "up"), [(0.0, 0.2), (0.0, 0.35), (-0.3, 0.35), (0.35, 0.0)])
@pytest.mark.parametrize("wide", [0.1, 0.3])
def test_it_is_still_there(mode, pan, up, wide):
    stands(drive(mode, pan, up, wide, 0.22))


@pytest.mark.parametrize("mode", SETTINGS)
@pytest.mark.parametrize("speed", [0.2, 20.0])
def test_it_is_however_fast_the_camera_turns(mode, speed):
    stands(drive(mode, 0.0, 0.35, 0.3, 0.22, speed=speed))


@pytest.mark.parametrize("wide", [0.1, 0.3, 1.0])
def test_a_guard_whose_camera_looks_down_does_not_drive_at_the_rest_of_it(wide):
    """Of which it saw the top, farther away."""
    stands(drive("guard", 0.0, 0.35, wide, 0.15, down=0.2))


@pytest.mark.parametrize("restarts", [2.3, 2.7, 4.5])
def test_it_is_after_a_restart_too(restarts):
    stands(drive("guard", 0.0, 0.35, 0.3, 0.22, restarts=restarts, speed=20.0))


@pytest.mark.parametrize("mode", SETTINGS)
@pytest.mark.parametrize("leaves", [3.0, 5.2])
@pytest.mark.parametrize(("pan", "up"), [(0.0, 0.0), (0.0, 0.1), (0.0, 0.35), (0.3, 0.2), (0.35, 0.0)])
def test_once_it_has_gone_and_the_camera_looks_there_again_the_robot_drives(mode, leaves, pan, up):
    speed, why = stands(drive(mode, pan, up, 0.3, 0.22, leaves=leaves, returns=RETURNS, until=7.5), leaves)
    assert speed > 0.0, why


def test_and_so_it_does_after_a_restart():
    speed, why = stands(drive("guard", 0.0, 0.35, 0.3, 0.22, leaves=3.7, returns=RETURNS, restarts=3.6, until=7.5), 3.7)
    assert speed > 0.0, why


@pytest.mark.parametrize("mode", SETTINGS)
@pytest.mark.parametrize(("pan", "up"), [(0.0, 0.35), (0.35, 0.0)])
def test_where_nothing_is_hidden_the_robot_drives_while_the_camera_turns(mode, pan, up):
    for now, speed, why in drive(mode, pan, up, 0.3, -0.1, returns=RETURNS):
        assert speed > 0.0, f"after {now:.2f} s: {why}"
