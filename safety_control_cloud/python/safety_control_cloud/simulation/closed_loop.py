# SPDX-License-Identifier: BSD-3-Clause
"""Closed-loop drives without ROS and without waiting: camera, decision, multiplexer and base, turn by turn."""
from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .base import Pose, Velocity
from .mux import Mux
from .sensor import Xtion, points
from .turtlebot import TICK, TurtleBot
from .world import Contact

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

    from ..core import SafetyControl  # compiled; a drive may do without

TELEOP = "Teleoperation"  # the mux's input that safety_control_cloud drives

Steer = "Callable[[NDArray[np.float32], float], Velocity | None]"
"""From a depth image [m] and the time [s] to the velocity wanted; None says nothing at all, as a dead node does."""


@dataclass(frozen=True)
class Situation:
    """The truth at one picture."""

    time: float  # [s]
    pose: Pose
    wanted: Velocity | None  # by the steering, upon this picture
    velocity: Velocity  # over the floor
    contacts: tuple[Contact, ...]  # since the last picture


def steered_by(control: SafetyControl, xtion: Xtion) -> Steer:
    """Drives as the node does: the compiled decision upon every picture."""
    return lambda depth, now: Velocity(control.decide(points(depth, xtion), now=now).speed)


def drive(
    robot: TurtleBot, steer: Steer, seconds: float, latency: float = 0.0, mux: Mux | None = None
) -> Iterator[Situation]:
    """Yields a Situation for every picture; what the caller does to the world in between, happens there.

    `latency` [s] passes between a picture and its velocity's arrival at the mux.
    """
    mux = mux or Mux()
    ticks_a_picture = round(1 / (robot.world.xtion.rate * TICK))
    under_way: deque[tuple[int, Velocity]] = deque()
    contacts: list[Contact] = []
    for tick in range(round(seconds / TICK)):
        if tick % ticks_a_picture == 0:
            wanted = steer(robot.depth(), robot.time)
            if wanted is not None:
                under_way.append((tick + round(latency / TICK), wanted))
            yield Situation(robot.time, robot.pose, wanted, robot.velocity, tuple(contacts))
            contacts.clear()
        while under_way and under_way[0][0] <= tick:
            _, velocity = under_way.popleft()
            if mux.passes(TELEOP, robot.time):
                robot.command(velocity)
        robot.step()
        contacts += robot.contacts
