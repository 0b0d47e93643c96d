# SPDX-License-Identifier: BSD-3-Clause
"""Who drives: somebody who tries to hit things, and somebody who follows a path. Both know where they are."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from math import atan2, cos, hypot, inf, pi, sin
from typing import Protocol

import numpy as np

from ...simulation.base import Pose, Velocity, stepped
from ..scenario import Scenario, random_of

PERIOD = 0.05  # [s] between two commands
FASTEST, FASTEST_TURN = 0.7, 2.5  # [m/s], [rad/s] of the rude one
GIVES_UP = 1.5  # [s] of standing after which the rude one tries something else
ARRIVED = 0.12  # [m]

Place = "tuple[float, float]"
Motion = "Callable[[float, Pose], Velocity]"  # from the time [s] and where the robot is


class Driver(Protocol):
    def wants(self, now: float, pose: Pose, velocity: Velocity) -> Velocity: ...

    @property
    def has_arrived(self) -> bool: ...


def driver_of(scenario: Scenario) -> Driver:
    random = random_of(scenario.family, scenario.seed, purpose=4)
    if scenario.route:
        return Polite(scenario.route, random)
    return Rude(lambda now: [thing.place(now) for thing in scenario.things], random)


class Rude:
    """One way of hitting something after the other; `places`: x, y [m] of what there is to be hit at a time [s]."""

    has_arrived = False

    def __init__(self, places: Callable[[float], Sequence[Place]], random: np.random.Generator) -> None:
        self._places, self._random = places, random
        self._motion: Motion = lambda now, pose: Velocity()
        self._ends, self._moved_at = 0.0, 0.0

    def wants(self, now: float, pose: Pose, velocity: Velocity) -> Velocity:
        if abs(velocity.linear) + abs(velocity.angular) > 0.01:
            self._moved_at = now
        stuck = now - self._moved_at > GIVES_UP
        if now >= self._ends or stuck:
            self._motion, lasts = self._next(now, pose, stuck)
            self._ends, self._moved_at = now + lasts, now
        return self._motion(now, pose)

    def _next(self, now: float, pose: Pose, stuck: bool) -> tuple[Motion, float]:
        ways = ["at", "at", "arc", "arc", "back", "back_at", "turn", "jerk", "weave"]
        way = "back" if stuck and self._random.random() < 0.5 else self._random.choice(ways)
        return getattr(self, f"_{way}")(now, pose)

    def _at(self, now: float, pose: Pose) -> tuple[Motion, float]:
        """Straight at something, turned to it first."""
        which, speed = self._target(now, pose), self._speed()

        def motion(now: float, pose: Pose) -> Velocity:
            bearing, _ = seen_from(pose, self._places(now)[which])
            return Velocity(speed if abs(bearing) < 0.5 else 0.0, float(np.clip(2.5 * bearing, -1.5, 1.5)))

        return motion, 6.0

    def _arc(self, now: float, pose: Pose) -> tuple[Motion, float]:
        """The one through something; backward, if it lies behind."""
        bearing, distance = seen_from(pose, self._places(now)[self._target(now, pose)])
        speed = self._speed() * (1 if abs(bearing) < pi / 2 else -1)
        rate = float(np.clip(2 * abs(speed) * sin(bearing) / max(distance, 0.2), -FASTEST_TURN, FASTEST_TURN))
        return (lambda now, pose: Velocity(speed, rate)), 4.0

    def _back(self, now: float, pose: Pose) -> tuple[Motion, float]:
        """Where it came from; as often straight."""
        speed, rate = self._speed(), float(self._random.choice([0.0, self._random.uniform(-0.5, 0.5)]))
        return (lambda now, pose: Velocity(-speed, rate)), float(self._random.uniform(1.0, 3.0))

    def _back_at(self, now: float, pose: Pose) -> tuple[Motion, float]:
        """Backward at something, turned away from it first."""
        which, speed = self._target(now, pose), self._speed()

        def motion(now: float, pose: Pose) -> Velocity:
            bearing, _ = seen_from(Pose(pose.x, pose.y, pose.yaw + pi), self._places(now)[which])
            return Velocity(-speed if abs(bearing) < 0.5 else 0.0, float(np.clip(2.5 * bearing, -1.5, 1.5)))

        return motion, 5.0

    def _turn(self, now: float, pose: Pose) -> tuple[Motion, float]:
        rate = float(self._random.choice([-1, 1]) * self._random.uniform(0.3, FASTEST_TURN))
        return (lambda now, pose: Velocity(0.0, rate)), float(self._random.uniform(0.5, 2.5))

    def _jerk(self, now: float, pose: Pose) -> tuple[Motion, float]:
        speed = float(self._random.uniform(-FASTEST, FASTEST))
        rate = float(self._random.uniform(-FASTEST_TURN, FASTEST_TURN))
        return (lambda now, pose: Velocity(speed, rate)), float(self._random.uniform(0.2, 0.8))

    def _weave(self, now: float, pose: Pose) -> tuple[Motion, float]:
        speed, often, most = self._speed(), self._random.uniform(1.0, 5.0), self._random.uniform(0.3, 1.5)
        return (lambda now, pose: Velocity(speed, float(most * sin(often * now)))), 3.0

    def _speed(self) -> float:
        return float(self._random.uniform(0.1, FASTEST))

    def _target(self, now: float, pose: Pose) -> int:
        """One of the three that are nearest."""
        places = self._places(now)
        nearest = sorted(range(len(places)), key=lambda one: hypot(places[one][0] - pose.x, places[one][1] - pose.y))
        return int(self._random.choice(nearest[:3]))


class Polite:
    """Along a route at a steady speed: toward a place a little ahead on it, slower where it turns and at its end."""

    def __init__(self, route: Sequence[Place], random: np.random.Generator) -> None:
        self._route, self._left = tuple(route), list(route)
        self._speed = float(random.uniform(0.15, 0.6))
        self._from: Place | None = None
        self._said = Velocity()
        self.has_arrived = False

    def wants(self, now: float, pose: Pose, velocity: Velocity) -> Velocity:
        self._from = self._from or (pose.x, pose.y)
        while len(self._left) > 1 and self._is_passed(pose):
            self._from = self._left.pop(0)
        goal = self._left[-1]
        to_go = hypot(goal[0] - pose.x, goal[1] - pose.y) if len(self._left) == 1 else inf
        self.has_arrived = self.has_arrived or to_go < ARRIVED
        if self.has_arrived:
            return Velocity()
        bearing, distance = seen_from(pose, self._ahead(pose))
        speed = 0.0 if abs(bearing) > 0.8 else min(self._speed, max(0.05, 0.8 * to_go)) * max(0.3, cos(2 * bearing))
        rate = float(np.clip(1.5 * bearing, -0.8, 0.8))
        self._said = Velocity(stepped(self._said.linear, speed, 0.3 * PERIOD), stepped(self._said.angular, rate, 2.0 * PERIOD))
        return self._said

    def _is_passed(self, pose: Pose) -> bool:
        along, whole = self._along(pose)
        return along > whole - 0.05

    def _ahead(self, pose: Pose) -> Place:
        """0.4 m farther on the way to the next place, or beyond it on that to the one after."""
        along, whole = self._along(pose)
        if along + 0.4 <= whole or len(self._left) == 1:
            return _between(self._from, self._left[0], min(1.0, (along + 0.4) / whole))
        (x, y), (to_x, to_y) = self._left[:2]
        return _between(self._left[0], self._left[1], min(1.0, (along + 0.4 - whole) / (hypot(to_x - x, to_y - y) or 1.0)))

    def _along(self, pose: Pose) -> tuple[float, float]:
        """[m] that is gone of the way to the next place, and its whole length."""
        (x, y), (to_x, to_y) = self._from, self._left[0]
        whole = hypot(to_x - x, to_y - y) or 1e-6
        return ((pose.x - x) * (to_x - x) + (pose.y - y) * (to_y - y)) / whole, whole


def seen_from(pose: Pose, place: Place) -> tuple[float, float]:
    """Bearing [rad] and distance [m]."""
    dx, dy = place[0] - pose.x, place[1] - pose.y
    return (atan2(dy, dx) - pose.yaw + pi) % (2 * pi) - pi, hypot(dx, dy)


def _between(start: Place, end: Place, share: float) -> Place:
    return start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])
