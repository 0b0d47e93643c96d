# SPDX-License-Identifier: BSD-3-Clause
"""Who stands between a driver and the base: the compiled guard as the node calls it, the tutorial's algorithm, or nobody."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from ...simulation.base import Pose, Velocity
from ...simulation.sensor import Xtion, points
from ..deciders import Tutorial
from ..scenario import XTION, Scenario

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

_EPOCH = 1000.0  # [s] of ROS time when a drive begins


@dataclass(frozen=True)
class Passed:
    """What became of a wish."""

    wanted: Velocity
    given: Velocity
    factor: float  # that is said of it
    cause: str
    reason: str = ""

    @property
    def is_whole(self) -> bool:
        """Equal in every bit."""
        return np.array_equal(_bits(self.wanted), _bits(self.given))


class Guard(Protocol):
    looks: bool  # at pictures; who does not saves the time of drawing them

    def see(self, depth: NDArray[np.float32], stamp: float, now: float) -> None:
        """A picture [m] taken at `stamp` arrives at `now` [s]."""

    def note_odometry(self, pose: Pose, velocity: Velocity, now: float) -> None: ...

    def want(self, wanted: Velocity, now: float) -> None: ...

    def answer(self, now: float) -> Passed: ...


class Ours:
    looks = True

    def __init__(self, scenario: Scenario, xtion: Xtion = XTION) -> None:
        from ... import core  # compiled; the others do without

        self._xtion, self._wanted = xtion, Velocity()
        x, y, z = xtion.mount
        self._camera = np.array([[0, 0, 1, x], [-1, 0, 0, y], [0, -1, 0, z]], np.float64)
        self._control = core.GuardControl(core.Settings(**dict(scenario.settings)))

    def see(self, depth: NDArray[np.float32], stamp: float, now: float) -> None:
        self._control.see(points(depth, self._xtion), now=now, stamp=_EPOCH + stamp, ros_now=_EPOCH + now, camera=self._camera)

    def note_odometry(self, pose: Pose, velocity: Velocity, now: float) -> None:
        self._control.note_odometry(_EPOCH + now, (pose.x, pose.y, pose.yaw), (velocity.linear, 0.0, velocity.angular))

    def want(self, wanted: Velocity, now: float) -> None:
        self._wanted = wanted
        self._control.want((wanted.linear, 0.0, 0.0), (0.0, 0.0, wanted.angular), now=now, ros_now=_EPOCH + now)

    def answer(self, now: float) -> Passed:
        said = self._control.answer(now=now, ros_now=_EPOCH + now)
        given = Velocity(said.given.linear[0], said.given.angular[2])
        return Passed(self._wanted, given, said.factor, said.cause.name, said.reason)


class Nobody:
    """What is wanted is done."""

    looks = False

    def __init__(self, scenario: Scenario) -> None:
        self._wanted = Velocity()

    def see(self, depth: NDArray[np.float32], stamp: float, now: float) -> None:
        pass

    def note_odometry(self, pose: Pose, velocity: Velocity, now: float) -> None:
        pass

    def want(self, wanted: Velocity, now: float) -> None:
        self._wanted = wanted

    def answer(self, now: float) -> Passed:
        return Passed(self._wanted, self._wanted, 1.0, "")


class TutorialGuard(Nobody):
    """The tutorial's zones as a guard: forward no faster than the zone's speed, all else as it is wanted."""

    looks = True

    def __init__(self, scenario: Scenario) -> None:
        super().__init__(scenario)
        self._tutorial, self._speed = Tutorial(), 0.0

    def see(self, depth: NDArray[np.float32], stamp: float, now: float) -> None:
        self._speed = self._tutorial.decide(depth, stamp, now).speed

    def answer(self, now: float) -> Passed:
        wanted = self._wanted
        if wanted.linear <= self._speed:
            return Passed(wanted, wanted, 1.0, "SEEN")
        factor = self._speed / wanted.linear
        return Passed(wanted, Velocity(self._speed, factor * wanted.angular), factor, "SEEN")


GUARDS = {"ours": Ours, "tutorial": TutorialGuard, "nobody": Nobody}


def _bits(velocity: Velocity) -> NDArray[np.uint64]:
    return np.array([velocity.linear, velocity.angular]).view(np.uint64)
