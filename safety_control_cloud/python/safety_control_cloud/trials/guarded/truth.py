# SPDX-License-Identifier: BSD-3-Clause
"""What would have been safe, by the scene itself: rolled out in small steps, with no part of the guard."""
from __future__ import annotations

from dataclasses import dataclass
from math import ceil, copysign, cos, hypot, sin
from typing import TYPE_CHECKING

import numpy as np

from ...simulation.base import DRIVER, Pose, Velocity
from ...simulation.hull import BODY_RADIUS, Rectangle
from ..scenario import Scenario
from ..things import Thing

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

STEP = 0.005  # [m] of the fastest point of the hull
SPACING = 0.01  # [m] between two points of a thing's outline
LOWEST = 0.05  # [m] above the floor: what is lower is none of the guard's business


SHARES = np.linspace(1.0, 0.0, 201)  # of a wish that are tried, the greatest first


@dataclass(frozen=True)
class Law:
    """By which a robot is to be able to stop: `reaction` [s] after the moment, `margin` [m] before what is there.

    approach [m/s]: that of anything, until the robot stands.
    """

    reaction: float
    margin: float
    approach: float = 0.0

    def greatest(self, distances: NDArray[np.float64], wanted: Velocity) -> float:
        """The greatest share s of the wanted motion, of SHARES, with which nothing comes nearer than the margin.

        distances: (n,) [m] least so far from the hull, at even times from 0 to `horizon`. Driven at s, s T + s^2 t_b / 2
        of the motion is used up in T + s t_b.
        """
        braking = self._braking(wanted)
        used = SHARES * self.reaction + SHARES ** 2 * braking / 2
        last = np.ceil(used / self.horizon(wanted) * (len(distances) - 1) - 1e-9).astype(int)
        keeps = distances[last] > self.margin + self.approach * (self.reaction + SHARES * braking)
        return float(SHARES[keeps.argmax()]) if keeps.any() else 0.0

    def horizon(self, wanted: Velocity) -> float:
        """[s] of the wanted motion that are used up by driving it whole, and stopping."""
        return self.reaction + self._braking(wanted) / 2

    def farthest(self, wanted: Velocity) -> float:
        """[m] by which anything may come nearer meanwhile."""
        return self.approach * (self.reaction + self._braking(wanted))

    @staticmethod
    def _braking(wanted: Velocity) -> float:
        return max(abs(wanted.linear) / DRIVER.deceleration, abs(wanted.angular) / DRIVER.angular)


class Ground:
    """A scene from above."""

    def __init__(self, scenario: Scenario) -> None:
        self._hull = scenario.hull
        self._things = [(thing, _outline(thing)) for thing in scenario.things if thing.bottom + thing.size[2] > LOWEST]

    def greatest_factor(self, wanted: Velocity, pose: Pose, now: float, law: Law) -> float | None:
        """Of a wish, as everything stands now; None where nothing is wanted, or something is within the margin already."""
        fastest = abs(wanted.linear) + abs(wanted.angular) * _reach(self._hull)
        horizon = law.horizon(wanted)
        if fastest < 0.02:
            return None
        points = self._near(pose, now, _reach(self._hull) + law.margin + fastest * horizon + law.farthest(wanted))
        if not len(points):
            return 1.0
        if from_hull(self._hull, points).min() <= law.margin:
            return None
        times = np.linspace(0.0, horizon, ceil(fastest * horizon / STEP) + 1)
        nearest = [from_hull(self._hull, _seen_after(points, wanted, time)).min() for time in times]
        return law.greatest(np.minimum.accumulate(nearest), wanted)

    def clearance(self, pose: Pose, now: float, farthest: float = 0.5) -> float:
        """[m] from the hull to the nearest outline; at most `farthest`."""
        points = self._near(pose, now, _reach(self._hull) + farthest)
        return min(farthest, float(from_hull(self._hull, points).min())) if len(points) else farthest

    def _near(self, pose: Pose, now: float, reach: float) -> NDArray[np.float64]:
        """(n, 2) outlines' points [m] as the robot sees them."""
        found = [np.empty((0, 2))]
        for thing, outline in self._things:
            points = outline + np.array(thing.place(now)) - (pose.x, pose.y)
            found.append(points[np.hypot(*points.T) <= reach])
        return np.vstack(found) @ _rotation(pose.yaw)


def from_hull(hull: Rectangle | None, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n,) [m] from the hull; less than 0 inside."""
    if hull is None:
        return np.hypot(*points.T) - BODY_RADIUS
    beyond = np.abs(points - [(hull.front + hull.back) / 2, 0.0]) - [(hull.front - hull.back) / 2, hull.half_width]
    return np.hypot(*np.maximum(beyond, 0.0).T) + np.minimum(beyond.max(axis=1), 0.0)


def point_speed(velocity: Velocity, pose: Pose, point: tuple[float, float], normal: tuple[float, float]) -> float:
    """[m/s] along a normal, of the hull at a point; both in the world. The normal leads out of the hull: MuJoCo turns it
    round where a foot has gone deep into it."""
    x = velocity.linear * cos(pose.yaw) - velocity.angular * (point[1] - pose.y)
    y = velocity.linear * sin(pose.yaw) + velocity.angular * (point[0] - pose.x)
    length = copysign(hypot(*normal), normal[0] * (point[0] - pose.x) + normal[1] * (point[1] - pose.y))
    return (x * normal[0] + y * normal[1]) / length if abs(length) > 1e-6 else 0.0


def _reach(hull: Rectangle | None) -> float:
    return BODY_RADIUS if hull is None else max(hypot(x, y) for x, y in hull.corners)


def _seen_after(points: NDArray[np.float64], velocity: Velocity, time: float) -> NDArray[np.float64]:
    turn = velocity.angular * time
    chord = velocity.linear * time * (sin(turn / 2) / (turn / 2) if abs(turn) > 1e-9 else 1.0)
    return (points - [chord * cos(turn / 2), chord * sin(turn / 2)]) @ _rotation(turn)


def _rotation(angle: float) -> NDArray[np.float64]:
    """Of rows, from a frame into one that is turned by the angle [rad] in it."""
    c, s = cos(angle), sin(angle)
    return np.array([[c, -s], [s, c]])


def _outline(thing: Thing) -> NDArray[np.float64]:
    """(n, 2) [m] around its middle."""
    length, width, _ = thing.size
    if thing.round:
        angles = np.linspace(0, 2 * np.pi, max(16, ceil(np.pi * length / SPACING)), endpoint=False)
        return np.column_stack([np.cos(angles), np.sin(angles)]) * length / 2
    along, across = (np.linspace(-side / 2, side / 2, ceil(side / SPACING) + 1) for side in (length, width))
    sides = [np.column_stack(pair) for side in (1, -1) for pair in (
        (along, np.full_like(along, side * width / 2)), (np.full_like(across, side * length / 2), across))]
    return np.vstack(sides) @ _rotation(-thing.at.yaw)
