# SPDX-License-Identifier: BSD-3-Clause
"""A camera that turns on the robot: what it does not look at any more has not gone."""
from __future__ import annotations

import numpy as np
import pytest
from boxes import ROOM, picture, placing

from safety_control_cloud import core

CAMERA = np.array([-0.087, 0.0, 0.2972])  # [m] in base_footprint
RATE, AFTER = 20.0, 1.0  # [Hz], and [s] for which the head rests before and after it turns
SETTINGS = core.Settings(mode="drive", target_frame="base_footprint", bottom=0.05, top=0.55, left=0.3, right=0.3)


@pytest.mark.parametrize("degrees_per_second", [15, 30, 60])
@pytest.mark.parametrize("degrees", [-25, -35])
@pytest.mark.parametrize("ahead", [0.35])
def test_the_robot_stands_for_a_post_from_which_the_head_turns_away(ahead, degrees, degrees_per_second):
    random = np.random.default_rng(0)
    control = core.SafetyControl(SETTINGS)
    post = (ahead, ahead + 0.1, 0.08, 0.18, 0.0, 1.0)
    turning = abs(degrees) / degrees_per_second
    for now in np.arange(0.0, 2 * AFTER + turning, 1 / RATE):
        pan = np.radians(degrees) * np.clip((now - AFTER) / turning, 0.0, 1.0)
        decision = control.decide(picture(placing(CAMERA, pan), (post, *ROOM), random), now=now, camera=placing(CAMERA, pan))
        if now > 0.3:
            assert decision.speed == 0.0, f"after {now:.2f} s, at {np.degrees(pan):.0f} degrees: {decision.reason}"


@pytest.mark.parametrize(("degrees", "degrees_per_second"), [(6, 60), (-20, 180), (35, 90)])
@pytest.mark.parametrize("thing", [(0.25, 0.0, 0.27), (0.25, 0.22, 0.5)], ids=["crate", "board"])
def test_what_the_head_passed_over_frees_the_robot_once_it_has_gone(thing, degrees, degrees_per_second):
    """While it moves, parts of the thing come into its picture and leave it again, each as seen on another way."""
    random = np.random.default_rng(0)
    control = core.SafetyControl(SETTINGS)
    width, bottom, top = thing
    turning = abs(degrees) / degrees_per_second
    leaves = 4 * AFTER + 2 * turning
    for now in np.arange(0.0, leaves + 5.0, 1 / RATE):
        there, back = (now - AFTER) / turning, 1 + (now - 2 * AFTER - turning) / turning
        pan = np.radians(degrees) * np.clip(min(there, 2 - back), 0.0, 1.0)
        ahead = max(0.3, 0.7 - now) + 0.6 * max(0.0, now - leaves)
        box = (ahead, ahead + 0.2, -width / 2, width / 2, bottom, top)
        decision = control.decide(picture(placing(CAMERA, pan), (box, *ROOM), random), now=now, camera=placing(CAMERA, pan))
        if 0.4 < now <= leaves:
            assert decision.speed == 0.0, f"after {now:.2f} s, at {np.degrees(pan):.0f} degrees: {decision.reason}"
    assert decision.speed > 0.0, decision.reason


def test_what_leaves_the_picture_of_a_fast_head_has_not_vanished():
    """In a hall in which nothing returns there; else the distance at which it was would count as blind from then on."""
    random = np.random.default_rng(0)
    control = core.SafetyControl(SETTINGS)
    board = (0.9, 1.1, -0.15, 0.15, 0.3, 0.5)
    looks = [(0, True)] * 20 + [(20, True), (40, True)] + [(60, False)] * 10 + [(30, False)] + [(0, False)] * 20
    for i, (degrees, is_there) in enumerate(looks):
        camera = placing(CAMERA, np.radians(degrees))
        decision = control.decide(picture(camera, (board,) if is_there else (), random), now=i / RATE, camera=camera)
    assert decision.speed > 0.0, decision.reason


@pytest.mark.parametrize("dropped", [0.15, 0.4])
@pytest.mark.parametrize("degrees", [3, 12])
def test_an_empty_floor_from_which_the_head_tilts_up_in_low_light_is_not_hidden(degrees, dropped):
    random = np.random.default_rng(0)
    control = core.SafetyControl(SETTINGS)
    for now in np.arange(0.0, 12.0, 1 / RATE):
        camera = placing(CAMERA, up=np.radians(degrees) * np.clip(now - 2 * AFTER, 0.0, 1.0))
        cloud = picture(camera, ROOM, random)
        cloud[random.random(cloud.shape[:2]) < dropped] = np.nan
        decision = control.decide(cloud, now=now, camera=camera)
        if now > AFTER:
            assert decision.speed > 0.0, f"after {now:.2f} s: {decision.reason}"
