# SPDX-License-Identifier: BSD-3-Clause
"""Who says how fast the robot may go: the compiled core as the node calls it, or the tutorial's algorithm."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from ..simulation.sensor import Xtion, points
from .scenario import XTION, Scenario

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

    from ..core import Decision

_EPOCH = 1000.0  # [s] of ROS time when a drive begins


@dataclass(frozen=True)
class Verdict:
    zone: str  # Safe, Warning or Danger
    speed: float  # [m/s] forward
    cause: str


class Decider(Protocol):
    repeats: float | None  # [s] after which the last verdict is said again; None: only upon clouds

    def decide(self, depth: NDArray[np.float32], stamp: float, now: float) -> Verdict:
        """For a picture [m] taken at `stamp` by the camera's clock, arriving at `now` [s]."""

    def without_cloud(self, now: float) -> Verdict:
        """What holds at `now` [s] while no cloud comes."""


class Ours:
    """The node's decision and its watchdog."""

    def __init__(self, settings: dict[str, float], xtion: Xtion = XTION) -> None:
        from .. import core  # compiled; the tutorial's method does without

        self._xtion = xtion
        parameters = core.Settings(**settings)
        self.control = core.SafetyControl(parameters)
        self.decision: Decision | None = None  # the latest
        self.repeats: float | None = 1 / parameters.publish_rate

    def decide(self, depth: NDArray[np.float32], stamp: float, now: float) -> Verdict:
        cloud = points(depth, self._xtion)
        return self._said(self.control.decide(cloud, now=now, stamp=_EPOCH + stamp, ros_now=_EPOCH + now))

    def without_cloud(self, now: float) -> Verdict:
        return self._said(self.control.without_cloud(now, ros_now=_EPOCH + now))

    def _said(self, decision: Decision) -> Verdict:
        self.decision = decision
        return Verdict(decision.zone.name.capitalize(), decision.speed, decision.cause.name)


def tutorial_verdict(nearest: float) -> Verdict:
    """For the nearest point's distance [m]; our defaults are the same."""
    if nearest > 1.0:
        return Verdict("Safe", 0.2, "SEEN")
    return Verdict("Warning", 0.1, "SEEN") if nearest > 0.5 else Verdict("Danger", 0.0, "SEEN")


class Tutorial:
    """PassThrough y, PassThrough x, getMinMax3D: where the crop is empty, its minimum is 3.4e38, and that is Safe."""

    repeats: float | None = None

    def __init__(self, xtion: Xtion = XTION) -> None:
        self._xtion = xtion

    def decide(self, depth: NDArray[np.float32], stamp: float, now: float) -> Verdict:
        x, y, z = np.moveaxis(points(depth, self._xtion), -1, 0)
        inside = (y >= np.float32(-0.25)) & (y <= np.float32(0.20)) & (x >= np.float32(-0.30)) & (x <= np.float32(0.30))
        return tutorial_verdict(float(z[inside].min(initial=np.finfo(np.float32).max)))

    def without_cloud(self, now: float) -> Verdict:
        raise AssertionError("the tutorial's node has no watchdog")


def decider_for(method: str, scenario: Scenario) -> Decider:
    """One of names.METHODS."""
    return Ours(dict(scenario.settings)) if method == "ours" else Tutorial()
