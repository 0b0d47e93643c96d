# SPDX-License-Identifier: BSD-3-Clause
"""What stands or walks in a trial's world, in the world's frame: x ahead of the robot's start, y left, z up [m]."""
from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from math import cos, hypot, sin

import numpy as np

from ..simulation.base import Pose


class Surface(Enum):
    """What the camera gets back from it."""

    PLAIN = "plain"
    GLASS = "glass"  # what lies behind it
    BLACK = "black"  # nothing


@dataclass(frozen=True)
class Path:
    """Where a thing is at which time: straight lines between waypoints, at rest before the first and after the last."""

    waypoints: tuple[tuple[float, float, float], ...]  # time [s], x, y [m]
    stride: float = 0.0  # [m] that a foot swings to the front and to the back of it
    step: float = 0.7  # [m] of way for one swing there and back
    phase: float = 0.0  # [rad]

    @property
    def ends_at(self) -> float:
        """[s]"""
        return self.waypoints[-1][0]

    def at(self, time: float) -> tuple[float, float]:
        """x, y [m] at `time` [s]."""
        times, xs, ys = zip(*self.waypoints)
        x, y = float(np.interp(time, times, xs)), float(np.interp(time, times, ys))
        walk = next((walk for walk in self._walks() if walk[0][0] < time < walk[-1][0]), None) if self.stride else None
        if walk is None:
            return x, y
        (begins, from_x, from_y), (ends, to_x, to_y) = walk[0], walk[-1]
        dx, dy = to_x - from_x, to_y - from_y
        way = hypot(dx, dy) or 1.0
        ease = min(1.0, (time - begins) / 0.3, (ends - time) / 0.3)  # the feet come together at either end
        swing = ease * self.stride * sin(2 * np.pi * hypot(x - from_x, y - from_y) / self.step + self.phase)
        return x + swing * dx / way, y + swing * dy / way

    def _walks(self) -> list[list[tuple[float, float, float]]]:
        """The waypoints between two rests."""
        walks = [[self.waypoints[0]]]
        for last, waypoint in zip(self.waypoints, self.waypoints[1:]):
            if waypoint[1:] == last[1:]:
                walks.append([waypoint])
            else:
                walks[-1].append(waypoint)
        return walks


@dataclass(frozen=True)
class Thing:
    """A box, or a cylinder if `round`, upright; `size` its whole length along x, width along y and height."""

    name: str
    at: Pose  # of its middle
    size: tuple[float, float, float]  # [m]; of a cylinder the first is the diameter
    bottom: float = 0.0  # [m] above the floor
    round: bool = False
    surface: Surface = Surface.PLAIN
    path: Path | None = None  # goes before `at`

    @property
    def mjcf(self) -> str:
        """A movable body of one geom of the same name."""
        half = [side / 2 for side in self.size]
        box = f'type="box" size="{half[0]} {half[1]} {half[2]}"'
        shape = f'type="cylinder" size="{half[0]} {half[2]}"' if self.round else box
        x, y = self.place(0.0)
        turned = f"{cos(self.at.yaw / 2)} 0 0 {sin(self.at.yaw / 2)}"
        body = f'<body name="{self.name}" mocap="true" pos="{x} {y} {self.bottom + half[2]}" quat="{turned}">'
        return f'{body}<geom name="{self.name}" {shape} rgba="{_COLOURS[self.surface]}"/></body>'

    def place(self, time: float) -> tuple[float, float]:
        """x, y [m] of its middle at `time` [s]."""
        return self.path.at(time) if self.path else (self.at.x, self.at.y)


_COLOURS = {
    Surface.PLAIN: "0.62 0.42 0.24 1",
    Surface.GLASS: "0.70 0.85 0.95 0.4",
    Surface.BLACK: "0.05 0.05 0.05 1",
}


def wall(name: str, x: float, y: float = 0.0, yaw: float = 0.0, length: float = 10.0, **more) -> Thing:
    """2.5 m high; the middle of its front at (x, y), facing the robot's start if `yaw` [rad] is 0."""
    middle = Pose(x + 0.05 * cos(yaw), y + 0.05 * sin(yaw), yaw)
    return Thing(name, middle, (0.1, length, 2.5), **more)


def post(name: str, x: float, y: float, diameter: float, height: float = 1.2, **more) -> Thing:
    return Thing(name, Pose(x, y), (diameter, diameter, height), round=True, **more)
