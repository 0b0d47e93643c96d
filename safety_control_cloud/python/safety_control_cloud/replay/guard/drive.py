# SPDX-License-Identifier: BSD-3-Clause
"""One guard in the bag's own time: what ros/guard_node.cpp does when a message comes, and when none does."""
from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Callable, List, Optional, Tuple

from safety_control_cloud import core
from safety_control_cloud.replay.eyes import Sighting
from safety_control_cloud.replay.guard.poses import Pose, Poses
from safety_control_cloud.replay.places import Place
from safety_control_cloud.replay.wire import seconds_of

Numbers = Tuple[float, ...]  # linear x, y, z [m/s], angular x, y, z [rad/s]
Motion = Tuple[float, float, float]  # forward, left [m/s], turning left [rad/s]
COMMAND, QUIET = "command", "quiet"  # why the guard answered, besides the name of a sensor or switch
SHORTEST = 1e-3  # [s] between two answers to nothing; as in ros/time/wake.cpp
NOTHING_CHANGES_AFTER = 60.0  # [s] without a message: each timeout is over by then


@dataclass(frozen=True)
class Answer:
    """What the guard gave, published as the node would have. Frame: base_frame."""

    time: int  # [ns] of the bag
    asked_by: str  # COMMAND, QUIET, a switch, or the sensor whose picture changed what is safe
    wanted: Numbers
    given: Numbers
    driven: Optional[Motion]  # by the latest odometry, which is that of the recorded drive
    factor: float  # given is so much of wanted
    time_to_contact: float  # [s] of wanted; infinite: nothing is touched before the robot could stand
    point: Optional[Tuple[float, float]]  # [m] that decided
    sensor: str  # that decided; empty: none did
    cause: str
    reason: str
    stuck: bool  # something is wanted and nothing is given

    @property
    def differs(self) -> bool:
        return bits(self.given) != bits(self.wanted)


Told = Callable[[Answer], None]


class GuardDrive:
    """Times [ns] of the bag, never backward."""

    def __init__(self, settings: core.Settings, names: List[str], start: int, told: Told, poses: Optional[Poses] = None) -> None:
        """`told` hears of each answer, `poses`: by TF, in the place of odometry.

        Raises ValueError with all problems of the settings.
        """
        self._control = core.GuardControl(settings)
        self._names, self._start, self._told, self._poses = names, start, told, poses
        self._driven: Optional[Motion] = None
        self.latest: Optional[Answer] = None
        self._due = float("inf")  # [s] steady
        self._answer(start, QUIET)

    def see(self, sensor: int, sighting: Sighting, place: Place, time: int) -> None:
        self._wait(time)
        self._note_transform()
        self._control.see(
            sighting.cloud, now=self._steady(time), ros_now=seconds_of(time), stamp=sighting.header.seconds, camera=place,
            source=sighting.source, frame=sighting.header.frame, sensor=sensor)
        self._answer(time, self._names[sensor], only_changes=True)

    def want(self, wanted: Numbers, stamp: Optional[float], time: int) -> None:
        """`stamp` [s]: of a command that has one."""
        self._wait(time)
        self._control.want(wanted[:3], wanted[3:], now=self._steady(time), ros_now=seconds_of(time), stamp=stamp)
        self._answer(time, COMMAND)

    def touch(self, switch: str, side: str, touched: bool, time: int) -> None:
        self._wait(time)
        self._control.note_switch(switch, side, touched, self._steady(time))
        self._answer(time, switch)

    def note_odometry(self, stamp: float, pose: Pose, twist: Motion, time: int, base: Pose = (0.0, 0.0, 0.0)) -> None:
        """`base`: where base_frame is in the frame of which this tells."""
        self._wait(time)
        self._control.note_odometry(stamp, pose, twist, base)
        self._driven = twist

    def end(self, time: int) -> None:
        self._wait(time)

    def _wait(self, until: int) -> None:
        """The answers that are due before that."""
        latest = min(self._steady(until), self._due + NOTHING_CHANGES_AFTER)
        while self._due < latest:
            self._answer(self._start + round(self._due * 1e9), QUIET)

    def _note_transform(self) -> None:
        told = self._poses.next() if self._poses else None
        if told:
            self._control.note_pose(*told)

    def _answer(self, time: int, asked_by: str, only_changes: bool = False) -> None:
        now = self._steady(time)
        self._note_transform()
        said = self._control.answer(now, seconds_of(time))
        answer = self._answer_of(said, time, asked_by)
        before = self.latest
        if only_changes and before and bits(before.given) == bits(answer.given) and before.cause == answer.cause:
            return
        self.latest = answer
        self._told(answer)
        changes = [change for change in (self._control.until_silent(now), said.override_left) if change > 0.0]
        self._due = now + max(min([self._control.answer_period, *changes]), SHORTEST)

    def _answer_of(self, said: core.Guarded, time: int, asked_by: str) -> Answer:
        return Answer(
            time, asked_by, (*said.wanted.linear, *said.wanted.angular), (*said.given.linear, *said.given.angular),
            self._driven, said.factor, said.time_to_contact, said.point, said.sensor, said.cause.name, said.reason,
            said.stuck_since is not None)

    def _steady(self, time: int) -> float:
        """[s] of a clock that starts with the bag: small numbers, so that differences are exact."""
        return (time - self._start) / 1e9


def bits(numbers: Numbers) -> bytes:
    return struct.pack("6d", *numbers)
