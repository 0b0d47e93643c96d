# SPDX-License-Identifier: BSD-3-Clause
"""What the families draw with."""
from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from ...simulation.base import DRIVER, Pose, stepped
from ...simulation.sensor import Xtion
from ..deciders import tutorial_verdict
from ..things import Path, Thing, wall

if TYPE_CHECKING:
    from ...simulation.hull import Rectangle
    from ..camera_faults import CameraFaults
    from ..scenario import Turn

CAMERA_X, CAMERA_Y, CAMERA_Z = Xtion().mount  # [m] in base_footprint, and in the world while the robot is at its start
CORRIDOR = (CAMERA_Y - 0.30, CAMERA_Y + 0.30)  # [m] right and left of it, in the world
LEG = 0.08  # [m] from a leg's middle to its front, about
STRIDE = 0.15  # [m] that a foot swings to the front
LATENCY = 0.1  # [s] from what is before the camera to the wheels, about


@dataclass(frozen=True)
class Draft:
    """Of a Scenario: what a family says of it. None is left to the Scenario's own default."""

    things: tuple[Thing, ...]
    start: Pose | None = None
    seconds: float | None = None
    faults: CameraFaults | None = None
    turns: tuple[Turn, ...] | None = None
    settings: tuple[tuple[str, float | str], ...] | None = None
    hull: Rectangle | None = None
    route: tuple[tuple[float, float], ...] | None = None
    odometry: bool | None = None
    limit: str | None = None


class Draw:
    """Random numbers; those with a name are kept as facts for the report."""

    def __init__(self, random: np.random.Generator) -> None:
        self._random = random
        self._facts: list[tuple[str, float]] = []

    @property
    def facts(self) -> tuple[tuple[str, float], ...]:
        return tuple(self._facts)

    def between(self, low: float, high: float, name: str = "") -> float:
        value = float(self._random.uniform(low, high))
        if name:
            self._facts.append((name, round(value, 4)))
        return value

    def sign(self) -> int:
        return 1 if self._random.random() < 0.5 else -1

    def chance(self, share: float) -> bool:
        return bool(self._random.random() < share)

    def one_of(self, *choices):
        return choices[int(self._random.integers(len(choices)))]


def background(draw: Draw, nearest: float = 2.5) -> tuple[Thing, ...]:
    """A wall behind it all at `nearest` [m] or more, or open space beyond the camera's range."""
    if draw.chance(0.3):
        return ()
    return (wall("background", draw.between(nearest, nearest + 2.0), yaw=draw.between(-0.3, 0.3)),)


def at_most_driven(time: float) -> float:
    """[m] that the robot can be ahead of its start at `time` [s]."""
    return 0.2 * time


def stops_at(start: float, begins: float, speed: float) -> float:
    """x [m] where the robot comes to stand before somebody who walks up from x = `start` and does not stop."""
    step, x, now, time = 0.01, 0.0, 0.0, 0.0
    while True:
        walks = speed if time >= begins else 0.0
        apart = start - STRIDE - walks * (time - begins) - (x + CAMERA_X)
        seen = apart + LATENCY * (now + walks)
        wanted = tutorial_verdict(seen).speed
        now = stepped(now, wanted, (DRIVER.acceleration if wanted > now else DRIVER.deceleration) * step)
        if wanted == now == 0.0:
            return x
        x, time = x + now * step, time + step


def legs(draw: Draw, waypoints: tuple[tuple[float, float, float], ...], heading: float) -> tuple[Thing, ...]:
    """Two legs of a person that walks along `waypoints` (time [s], x, y [m]), turned to `heading` [rad]."""
    diameter, apart = draw.between(0.09, 0.15, "leg [m]"), draw.between(0.10, 0.16)
    dx, dy = -np.sin(heading) * apart, np.cos(heading) * apart
    made = []
    for side, name in ((-0.5, "right_leg"), (0.5, "left_leg")):
        moved = tuple((time, x + side * dx, y + side * dy) for time, x, y in waypoints)
        path = Path(moved, stride=STRIDE, phase=pi * (side > 0))
        made.append(Thing(name, Pose(), (diameter, diameter, 0.85), round=True, path=path))
    return tuple(made)
