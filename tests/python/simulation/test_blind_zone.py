# SPDX-License-Identifier: BSD-3-Clause
"""A post slides from the side into the camera's blind zone while the robot looks; the compiled decision drives it."""
from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from rooms import room, wall_at
from safety_control_cloud.simulation import closed_loop
from safety_control_cloud.simulation.base import Pose, Velocity
from safety_control_cloud.simulation.sensor import Xtion, points
from safety_control_cloud.simulation.turtlebot import TurtleBot

core = pytest.importorskip("safety_control_cloud.core")

QVGA = Xtion(width=320, height=240)
CAMERA_X, CAMERA_Y, _ = QVGA.mount
RADIUS = 0.03  # [m] of the post
POST = f'<body name="post" mocap="true" pos="0 9 0.6"><geom name="post" type="cylinder" size="{RADIUS} 0.6"/></body>'
LAST_5_S = round(5 * QVGA.rate)  # pictures
GATE = '<body name="gate" mocap="true" pos="0 9 1"><geom name="gate" type="box" size="0.001 1 1"/></body>'


class Drive:
    """A robot at the origin of a room with a post and a gate, what it decided upon every picture, and where it was."""

    def __init__(self) -> None:
        self.robot = TurtleBot(room(POST, GATE, wall_at(4.5), xtion=QVGA))
        self.decisions: list[core.Decision] = []
        self.moments: list[closed_loop.Situation] = []

    def pictures(self, seconds: float) -> Iterator[float]:
        """The time [s] of each; what the caller moves then is in the next."""
        control = core.SafetyControl()

        def steer(depth: np.ndarray, now: float) -> Velocity:
            self.decisions.append(control.decide(points(depth, QVGA), now=now))
            return Velocity(self.decisions[-1].speed)

        for moment in closed_loop.drive(self.robot, steer, seconds, latency=0.05):
            self.moments.append(moment)
            yield moment.time
        self.robot.close()

    def put(self, name: str, from_camera: float, aside: float = 0.0) -> None:
        """Its middle so far [m] ahead of the camera, which looks along x, and to the left of its axis."""
        x, y = self.robot.pose.x + CAMERA_X + from_camera, CAMERA_Y + aside
        self.robot.world.move(name, Pose(x, y))


def slides(time: float, begins: float, speed: float) -> float:
    """[m] from the camera's axis: from just beside its view up to the axis, where it stays."""
    return max(0.0, 0.3 - speed * max(0.0, time - begins))


@pytest.mark.parametrize("side", [-1, 1], ids=["from_the_right", "from_the_left"])
@pytest.mark.parametrize("distance", [0.29, 0.33, 0.37], ids="{:.2f}_m".format)
def test_a_standing_robot_never_moves_toward_a_post_that_slid_into_its_blind_zone(distance, side):
    drive = Drive()
    drive.put("gate", 0.46)  # the robot stands before it until it is taken away
    for time in drive.pictures(10.0):
        if time > 4.0:
            drive.put("gate", 9.0)
        drive.put("post", distance + RADIUS, side * slides(time, begins=1.5, speed=0.4))
    assert {moment.pose for moment in drive.moments} == {Pose()}
    assert {decision.zone for decision in drive.decisions} == {core.Zone.DANGER}
    assert {decision.cause for decision in drive.decisions[-LAST_5_S:]} == {core.Cause.NEAR_LOSS}
    assert not any(moment.contacts for moment in drive.moments)


@pytest.mark.parametrize("side", [-1, 1], ids=["from_the_right", "from_the_left"])
def test_a_driving_robot_brakes_for_a_post_that_slid_into_its_blind_zone_and_does_not_go_on(side):
    drive = Drive()
    for time in drive.pictures(10.0):
        if time <= 2.0:
            started = drive.robot.pose.x  # until then the post comes along, beside the view
        drive.put("post", started + 0.385 + RADIUS - drive.robot.pose.x, side * slides(time, begins=2.0, speed=1.6))
    assert {decision.cause for decision in drive.decisions[-LAST_5_S:]} == {core.Cause.NEAR_LOSS}
    assert {decision.zone for decision in drive.decisions[-LAST_5_S:]} == {core.Zone.DANGER}
    assert len({moment.pose for moment in drive.moments if moment.time > 3.0}) == 1
    assert not any(moment.contacts for moment in drive.moments)
