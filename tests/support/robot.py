# SPDX-License-Identifier: BSD-3-Clause
"""A robot with the real node, a camera before it, and ears for what the node says.

    robot.camera.show(without_returns)
    robot.stops("BLIND")
    robot.camera.show(hall())
    robot.drives()

SAFETY_CONTROL_NODE names another executable of the node, say one that is built with a sanitizer.
"""
from __future__ import annotations

import os
import resource
import signal
import time
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Callable, ContextManager, Iterator, List, Optional, Tuple

import rospy
from camera import Camera, Clock
from geometry_msgs.msg import Twist
from listening import Heard, eventually, is_sending  # noqa: F401 (the last two for the tests)
from scenes import View, hall

from safety_control_cloud.msg import SafetyState
from safety_control_cloud.processes import Process, process
from safety_control_cloud.ros_session import node

NODE = "/safety_control_cloud"
SANITIZED = "SAFETY_CONTROL_NODE" in os.environ
GRACE = 1.0 if SANITIZED else 0.25  # [s] for a busy machine, or a sanitizer that looks up a name
ONE_CLOUD = 0.05 + GRACE  # [s] the camera's period
SOURCE_TIMEOUT = 0.5 + GRACE  # [s]
AGAIN = 1.0 + GRACE  # [s] of good data until the robot drives again
WATCH = 0.7  # [s] for which it is watched: more than source_timeout, after which silence would be said
START = 20.0  # [s]


class Robot:
    def __init__(self, process: Process, camera: Camera) -> None:
        self.process = process
        self.states = Heard(NODE + "/state", SafetyState)
        self.commands = Heard("/cmd_vel_mux/input/teleop", Twist)
        self.camera = camera

    def drives(self, speed: float = 0.2, within: float = AGAIN) -> None:
        """Once the camera shows what it shows now, the robot drives at this speed, because it has seen."""
        self._settles(speed, "SEEN", within)

    def slows(self, cause: str, within: float = ONE_CLOUD) -> SafetyState:
        """Once the camera shows what it shows now, the robot is told to drive slowly, for this cause."""
        return self._settles(0.1, cause, within)

    def stops(self, cause: str, within: float = ONE_CLOUD) -> SafetyState:
        """Once the camera shows what it shows now, the robot is told to stand, for this cause; and stands."""
        return self._settles(0.0, cause, within)

    def keeps(self, speed: float, seconds: float = WATCH) -> None:
        """From now on it is told nothing else."""
        since = time.monotonic()
        time.sleep(seconds)
        self.is_alive()
        assert {command.linear.x for _, command in after(since + 0.1, self.commands)} == {speed}

    def keeps_silent(self, seconds: float) -> None:
        """From now on it is told nothing at all; what is under way is given time to arrive."""
        time.sleep(GRACE)
        since = time.monotonic()
        time.sleep(seconds)
        assert after(since, self.commands) == []

    def first_command(self, within: float = AGAIN) -> Twist:
        """The first since the last change before the camera."""
        return self._first(self.commands, lambda command: True, self.camera.changed_at, within)[1]

    def memory(self) -> int:
        """[byte] that the node has in use."""
        pages = Path(f"/proc/{self.process.pid}/statm").read_text().split()[1]
        return int(pages) * resource.getpagesize()

    def is_alive(self) -> None:
        assert self.process.exit_code is None, self.process.output()

    def end(self) -> None:
        self.camera.end()
        self.states.close()
        self.commands.close()

    def _settles(self, speed: float, cause: str, within: float) -> SafetyState:
        since = self.camera.changed_at

        def is_so(state: SafetyState) -> bool:
            return state.cause_text == cause and state.speed == speed

        commanded_at, _ = self._first(self.commands, lambda command: command.linear.x == speed, since, within)
        stated_at, state = self._first(self.states, is_so, since, within)
        time.sleep(WATCH)
        self.is_alive()
        commands, states = after(commanded_at, self.commands), after(stated_at, self.states)
        assert [flat(command) for _, command in commands] == [(speed, 0, 0, 0, 0, 0)] * len(commands)
        assert {(state.cause_text, state.speed) for _, state in states} == {(cause, speed)}
        assert SANITIZED or commands[-1][0] > stated_at + WATCH / 2, f"silent after {commands[-1][0] - stated_at:.3f} s of {WATCH} s"
        return state

    def _first(self, heard: Heard, fits: Callable[[Any], bool], since: float, within: float) -> Tuple[float, Any]:
        deadline = since + within
        while True:
            now = time.monotonic()
            for arrival, message in after(since, heard):
                if fits(message):
                    assert arrival <= deadline, f"{heard.topic}: {arrival - since:.3f} s, not within {within:.3f} s"
                    return arrival, message
            self.is_alive()
            assert now < deadline + GRACE, f"{heard.topic}: not within {within} s; the last was\n{heard.all()[-1:]}"
            time.sleep(0.005)


def flat(twist: Twist) -> Tuple[float, ...]:
    linear, angular = twist.linear, twist.angular
    return linear.x, linear.y, linear.z, angular.x, angular.y, angular.z


def after(moment: float, heard: Heard) -> List[Tuple[float, Any]]:
    """What was heard at that moment [s] or later."""
    return [(arrival, message) for arrival, message in heard.timed() if arrival >= moment]


@contextmanager
def driving_robot(
    view: Optional[View] = None, clock: Clock = rospy.Time.now, cause: str = "SEEN", **parameters: Any
) -> Iterator[Robot]:
    """A robot that has begun to drive (or to stand, for another cause than SEEN), and its node's parameters.

    At the end the node must obey Ctrl-C, unless it has ended before.
    """
    arguments = [f"_{name}:={value}" for name, value in parameters.items()]
    with node_under_test(*arguments) as running, robot_with(running, view or hall(), clock) as robot:
        started = time.monotonic() - robot.camera.changed_at + START
        robot.drives(within=started) if cause == "SEEN" else robot.stops(cause, within=started)
        yield robot
        if running.exit_code is None:
            running.send(signal.SIGINT)
            assert running.wait(10.0) == 0, running.output()


def node_under_test(*arguments: str) -> ContextManager[Process]:
    chosen = os.environ.get("SAFETY_CONTROL_NODE")
    return process([chosen, *arguments]) if chosen else node("safety_control_node", *arguments)


@contextmanager
def robot_with(process: Process, view: View, clock: Clock = rospy.Time.now) -> Iterator[Robot]:
    """A camera and ears for a node that runs already; takes away what it leaves behind on the parameter server."""
    robot = Robot(process, Camera(view, clock))
    try:
        yield robot
    finally:
        robot.end()
        for left in (NODE, NODE + "_lost"):
            if rospy.has_param(left):
                rospy.delete_param(left)
