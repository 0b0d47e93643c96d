# SPDX-License-Identifier: BSD-3-Clause
"""One node with one setting, in the bag's own time: what it says of each cloud, and when it says that there is none."""
from __future__ import annotations

from typing import Iterator, NamedTuple, Optional, Tuple

from safety_control_cloud import core
from safety_control_cloud.replay.eyes import Sighting
from safety_control_cloud.replay.places import Place
from safety_control_cloud.replay.wire import seconds_of

NAN = float("nan")


class Verdict(NamedTuple):
    """A cloud, or a silence. `nearest` [m] ahead; x, y, z [m] of a point that was seen, in the frame of the node's state."""

    topic: str
    number: int  # of the cloud on its topic, from 0; a silence has that of the cloud before
    time: int  # [ns] of the bag: when the cloud came, or the silence began
    stamp: Optional[int]  # [ns] the cloud's own; a silence has none
    zone: str
    cause: str
    reason: str
    nearest: Optional[float]
    x: Optional[float]
    y: Optional[float]
    z: Optional[float]
    speed: float  # [m/s]
    inside: int
    returns: int
    total: int


class Drive:
    def __init__(self, topic: str, settings: core.Settings) -> None:
        """Raises ValueError with all problems of the settings."""
        self._topic, self._settings = topic, settings
        self._control = core.SafetyControl(settings)
        self._timeout = round(settings.source_timeout * 1e9)  # [ns]
        self._first = self._last = 0  # [ns]
        self._seen = 0

    def see(self, sighting: Sighting, place: Optional[Place]) -> Iterator[Verdict]:
        """The verdict on a cloud, after the silence before it, if there was one."""
        yield from self.wait(sighting.time)
        if not self._seen:
            self._first = sighting.time
        self._last = sighting.time
        self._seen += 1
        decision = self._control.decide(
            sighting.cloud, now=self._steady(sighting.time), ros_now=seconds_of(sighting.time),
            stamp=sighting.header.seconds, source=sighting.source, camera=place,
            frame=sighting.header.frame)
        yield self._verdict(decision, sighting.number, sighting.time, sighting.header.stamp)

    def wait(self, until: int) -> Iterator[Verdict]:
        """The silence since the last cloud, if it is one by then."""
        if self._seen and until - self._last > self._timeout:
            decision = self._control.without_cloud(self._steady(until), seconds_of(until))
            yield self._verdict(decision, self._seen - 1, self._last + self._timeout, None)

    def _steady(self, time: int) -> float:
        """[s] of a clock that starts with the first cloud: small numbers, so that differences are exact."""
        return (time - self._first) / 1e9

    def _in_its_frame(self, point: Tuple[float, float, float]) -> Tuple[float, float, float]:
        """From the corridor's axes (x right, y down, z forward) to those of the target frame, if there is one."""
        right, down, forward = point
        return (forward, -right, -down) if self._settings.target_frame else point

    def _verdict(self, decision: core.Decision, number: int, time: int, stamp: Optional[int]) -> Verdict:
        nearest, sight = decision.nearest, decision.sight
        x, y, z = self._in_its_frame(nearest.point) if nearest else (NAN, NAN, NAN)
        seen = x == x and y == y and z == z
        return Verdict(
            self._topic, number, time, stamp, decision.zone.name.capitalize(), decision.cause.name, decision.reason,
            nearest.distance if nearest else None, x if seen else None, y if seen else None, z if seen else None,
            decision.speed, sight.inside, sight.returns, sight.total)
