# SPDX-License-Identifier: BSD-3-Clause
"""A camera on a mast that goes up and down: what is below its picture by then has not gone."""
from __future__ import annotations

import numpy as np
import pytest
from boxes import ROOM, picture, placing

from safety_control_cloud import core

CAMERA = np.array([-0.087, 0.0, 0.2972])  # [m] in base_footprint
RATE, AT = 20.0, 2.0  # [Hz], and [s] at which the mast begins to move
SETTINGS = core.Settings(mode="drive", target_frame="base_footprint", bottom=0.05, top=0.8, left=0.3, right=0.3)
THINGS = {  # [m] how near it comes, how deep and wide it is, and from which height to which
    "post": (0.25, 0.1, 0.2, 0.0, 0.4),
    "board": (0.25, 0.1, 0.2, 0.25, 0.45),
    "crate": (0.25, 0.1, 0.2, 0.0, 0.3),
    "step": (0.45, 1.6, 1.2, 0.0, 0.045),
    "low step": (0.45, 1.6, 1.2, 0.0, 0.03),
}


def drive(height: float, speed: float, thing: str, lowers: bool = False, until: float = 8.0, noise: float = 0.0):
    """What is decided, and when [s]: the robot stands before what it cannot see any more, the mast moves up, and down
    again if it lowers; the thing is taken away at 6 s. TF is off by some noise [m]."""
    random, of_tf = np.random.default_rng(0), np.random.default_rng(1)
    control = core.SafetyControl(SETTINGS)
    nearest, deep, wide, bottom, top = THINGS[thing]
    for now in np.arange(0.0, until, 1 / RATE):
        up = np.clip(speed * (now - AT), 0.0, abs(height))
        if lowers:
            up = min(up, max(0.0, abs(height) - speed * (now - 6.0)))
        camera = placing(CAMERA + [0.0, 0.0, np.copysign(up, height)])
        ahead = max(nearest, 0.9 - 0.5 * now)
        there = ((ahead, ahead + deep, -wide / 2, wide / 2, bottom, top),) if now < 6.0 else ()
        said = camera.copy()
        said[:, 3] += noise * of_tf.standard_normal(3)
        yield now, control.decide(picture(camera, (*there, *ROOM), random), now=now, camera=said)


@pytest.mark.parametrize("thing", THINGS)
@pytest.mark.parametrize(("height", "speed"), [(0.1, 0.2), (0.2, 0.1), (0.4, 0.4), (0.4, 4.0), (0.6, 0.2), (-0.1, 0.2)])
def test_what_was_lost_stays_though_the_camera_looks_over_it(height, speed, thing):
    for now, decision in drive(height, speed, thing, until=6.0):
        if now > 1.0:
            assert decision.speed == 0.0, f"after {now:.2f} s: {decision.reason}"


@pytest.mark.parametrize(("height", "thing"), [(0.4, "post"), (0.4, "crate"), *((0.05, thing) for thing in THINGS)])
def test_once_it_has_gone_and_the_camera_is_down_again_the_robot_drives(height, thing):
    for _, decision in drive(height, 0.4, thing, lowers=True):
        pass
    assert decision.speed > 0.0, decision.reason


@pytest.mark.parametrize("height", [0.05, 0.2, 0.4, -0.1, -0.2])
def test_where_nothing_is_the_robot_drives_while_the_mast_moves(height):
    random = np.random.default_rng(0)
    control = core.SafetyControl(SETTINGS)
    for now in np.arange(0.0, 6.0, 1 / RATE):
        up = np.clip(0.2 * (now - AT), 0.0, abs(height))
        camera = placing(CAMERA + [0.0, 0.0, np.copysign(up, height)])
        decision = control.decide(picture(camera, ROOM, random), now=now, camera=camera)
        assert decision.speed > 0.0, f"after {now:.2f} s: {decision.reason}"


@pytest.mark.parametrize("noise", [0.001, 0.003, 0.005])
@pytest.mark.parametrize("thing", ["post", "board", "low step"])
def test_noise_in_tf_frees_of_nothing_and_keeps_nothing_that_has_gone(thing, noise):
    for now, decision in drive(0.0, 0.0, thing, noise=noise):
        if 1.0 < now < 6.0:
            assert decision.speed == 0.0, f"after {now:.2f} s: {decision.reason}"
    assert decision.speed > 0.0, decision.reason


@pytest.mark.parametrize("wide", [0.3, 1.6])
@pytest.mark.parametrize("height", [0.012, 0.03, -0.012, -0.03])
def test_what_only_hides_the_near_floor_stays_though_the_mast_moves(height, wide):
    """It slides in from the side, nearer than the camera can see."""
    random = np.random.default_rng(0)
    control = core.SafetyControl(SETTINGS)
    stood = False
    for now in np.arange(0.0, 5.0, 1 / RATE):
        up = np.clip(0.1 * (now - 3.0), 0.0, abs(height))
        camera = placing(CAMERA + [0.0, 0.0, np.copysign(up, height)])
        aside = 2.0 - min(1.9, 1.2 * max(0.0, now - 0.5))
        ledge = (0.213, 0.293, aside - wide / 2, aside + wide / 2, 0.0, 0.2)
        decision = control.decide(picture(camera, (ledge, *ROOM), random), now=now, camera=camera)
        stood = stood or decision.speed == 0.0
        assert not stood or decision.speed == 0.0, f"after {now:.2f} s: {decision.reason}"
    assert stood


def test_what_the_mast_looked_over_hides_the_near_floor_again_once_it_is_down():
    """It came in from the side, and is no thing that was ever seen near."""
    random = np.random.default_rng(0)
    control = core.SafetyControl(SETTINGS)
    for now in np.arange(0.0, 6.0, 1 / RATE):
        up = min(0.1, max(0.0, 0.1 * (now - 2.5)), max(0.0, 0.1 * (5.0 - now)))
        camera = placing(CAMERA + [0.0, 0.0, up])
        aside = 2.0 - min(2.0, 1.5 * max(0.0, now - 0.5))
        crate = (0.163, 0.463, aside - 0.2, aside + 0.2, 0.0, 0.2)
        decision = control.decide(picture(camera, (crate, *ROOM), random), now=now, camera=camera)
        if up == 0.0 and now > 2.0:
            assert decision.speed == 0.0, f"after {now:.2f} s: {decision.reason}"


@pytest.mark.parametrize(("top", "speed", "down"), [(0.04, 0.1, 0.05), (0.03, 0.1, 0.05), (0.045, 0.2, 0.06)])
def test_a_step_whose_foot_leaves_the_picture_while_the_mast_goes_down_stays(top, speed, down):
    """The robot brakes before it, and drives on if it is let."""
    random = np.random.default_rng(0)
    control = core.SafetyControl(SETTINGS)
    ahead, velocity, stood = 1.0, 0.0, False
    for now in np.arange(0.0, 6.0, 1 / RATE):
        camera = placing(CAMERA + [0.0, 0.0, 0.05 - np.clip(speed * (now - 1.7), 0.0, down)])
        step = (ahead, ahead + 0.5, -0.6, 0.6, 0.0, top)
        decision = control.decide(picture(camera, (step, *ROOM), random), now=now, camera=camera)
        velocity += np.clip(decision.speed - velocity, -0.5 / RATE, 0.5 / RATE)
        ahead -= velocity / RATE
        stood = stood or decision.speed == 0.0
        assert not stood or decision.speed < 0.2, f"after {now:.2f} s, {ahead:.2f} m before it: {decision.reason}"
    assert stood and decision.speed == 0.0 and ahead > 0.5
