# SPDX-License-Identifier: BSD-3-Clause
"""What became of a drive in one of the simulators, and of the same drive in both."""
from __future__ import annotations

from dataclasses import dataclass
from math import hypot, nan
from typing import TYPE_CHECKING, Sequence

import numpy as np

from safety_control_cloud.simulation.base import DRIVER, Pose
from safety_control_cloud.trials.scenario import Scenario

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

NEAR = 0.03  # [m] between both places, at most
ALIKE = 0.01  # of its distance: what a pixel's depths may differ by
AT_REST = 3.5  # [s] of standing after which nothing more is to be expected
STANDING = 0.005  # [m/s] of it a robot that stands may seem to have


@dataclass(frozen=True)
class Moment:
    time: float  # [s]
    pose: Pose
    speed: float  # [m/s]


@dataclass(frozen=True)
class Driven:
    track: tuple[Moment, ...]
    clearance: float  # [m] the smallest, hull to the nearest thing
    cause: str  # of the node's last decision
    decided_at: float  # [s] stamp of the picture upon which it stands; NaN: it never drove
    first: NDArray[np.float32]  # (height, width) [m] picture before it set out
    last: NDArray[np.float32]  # picture at the end

    @property
    def end(self) -> Pose:
        return self.track[-1].pose

    @property
    def stands(self) -> bool:
        return self.track[-1].time - last_moved(self.track) > AT_REST

    @property
    def latency(self) -> float:
        """[s] from the picture upon which it stands to where braking as the driver does begins; NaN: it never drove."""
        before = [moment for moment in self.track if moment.time <= self.decided_at]
        if not before or before[-1].speed < STANDING:
            return nan
        speed, times = before[-1].speed, [moment.time for moment in self.track]
        x, y = (np.interp(self.decided_at, times, [getattr(moment.pose, axis) for moment in self.track]) for axis in "xy")
        return (hypot(self.end.x - x, self.end.y - y) - speed**2 / (2 * DRIVER.deceleration)) / speed


@dataclass(frozen=True)
class Pair:
    scenario: Scenario
    mujoco: Driven
    gazebo: Driven

    @property
    def apart(self) -> float:
        """[m] between where the two robots stand."""
        return hypot(self.mujoco.end.x - self.gazebo.end.x, self.mujoco.end.y - self.gazebo.end.y)

    @property
    def touches(self) -> bool:
        return min(self.mujoco.clearance, self.gazebo.clearance) <= 0

    @property
    def is_near(self) -> bool:
        return self.apart <= NEAR and self.mujoco.stands and self.gazebo.stands

    @property
    def unlike(self) -> float:
        """Share of the first picture's pixels that differ."""
        return 1 - float(np.mean(np.isclose(self.gazebo.first, self.mujoco.first, rtol=ALIKE, equal_nan=True)))


def last_moved(track: Sequence[Moment]) -> float:
    """[s] since when it stands."""
    return max((moment.time for moment in track if abs(moment.speed) >= STANDING), default=track[0].time)
