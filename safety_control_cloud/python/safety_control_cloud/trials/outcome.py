# SPDX-License-Identifier: BSD-3-Clause
"""What became of a drive, judged by the truth and not by what the camera saw."""
from __future__ import annotations

from dataclasses import dataclass, field
from itertools import groupby
from math import inf

from ..simulation.base import DRIVER, Pose
from ..simulation.sensor import Xtion
from .deciders import Verdict
from .scenario import Scenario
from .view import is_in_view

CAUSED_ABOVE = 0.01  # [m/s] toward the obstacle at contact
FALSE_STOP = 2.0  # [s] in Danger although the corridor is free
STANDING = 0.005  # [m/s]
AT_REST = 3.5  # [s] of standing after which nothing more is to be expected
SIDE_ENTRY = "it came into the corridor from the side, nearer than the robot can brake"
BESIDE_THE_VIEW = "it was beside the camera's view, or at its border, until the robot was nearer than it can brake"


@dataclass(frozen=True)
class Hit:
    """The robot's hull touches something."""

    time: float  # [s]
    thing: str
    approach: float  # [m/s] of the robot toward it


@dataclass(frozen=True)
class Truth:
    """The truth at one picture."""

    time: float  # [s]
    pose: Pose
    speed: float  # [m/s] over the floor
    verdict: Verdict
    free: bool  # the corridor, to stage.FREE_TO
    clearance: float  # [m] hull to the nearest thing
    hits: tuple[Hit, ...] = ()  # since the last picture


@dataclass(frozen=True)
class Outcome:
    family: str
    seed: int
    method: str
    collision: Hit | None  # the first that the robot caused
    limit: str  # why one forward depth camera could not have helped; empty if it could
    clearance: float  # [m] the smallest while the robot moved; inf if it never did
    seconds: float  # how long the drive lasted
    driving: float  # [s]
    free_seconds: float  # with nothing in the corridor
    free_metres: float  # driven meanwhile
    false_stop: float | None  # [s] when the first began
    stuck: bool  # at the end, although nothing is in the way or amiss
    zones: tuple[str, ...]  # one after the other
    causes: tuple[str, ...]

    @property
    def name(self) -> str:
        return f"{self.family}:{self.seed}"


@dataclass
class Judge:
    """Sees the moments of one drive."""

    scenario: Scenario
    method: str
    _seen: list[Truth] = field(default_factory=list)
    _still_since: float = 0.0
    _wrong_since: float = inf
    _blocked_since: float = inf
    _false_stop: float | None = None
    _collision: Hit | None = None
    _limit: str = ""

    def see(self, moment: Truth) -> None:
        caused = [hit for hit in moment.hits if hit.approach > CAUSED_ABOVE]
        if caused and self._collision is None:
            self._collision, self._limit = caused[0], self.scenario.limit or self._too_late(caused[0])
        stands = abs(moment.speed) < STANDING
        self._blocked_since = inf if moment.free else min(self._blocked_since, moment.time)
        self._still_since = self._still_since if stands else moment.time
        wrong = stands and moment.free and moment.verdict.zone == "Danger"
        self._wrong_since = min(self._wrong_since, moment.time) if wrong else inf
        if self._false_stop is None and moment.time - self._wrong_since >= FALSE_STOP:
            self._false_stop = self._wrong_since
        self._seen.append(moment)

    @property
    def is_over(self) -> bool:
        """Nothing more is to be expected."""
        now = self._seen[-1].time
        return self._collision is not None or now - max(self._still_since, self.scenario.settled_at) > AT_REST

    def outcome(self) -> Outcome:
        moving = [moment for moment in self._seen if abs(moment.speed) >= STANDING]
        free = [moment for moment in self._seen if moment.free]
        period, last = 1 / Xtion().rate, self._seen[-1]
        return Outcome(
            self.scenario.family, self.scenario.seed, self.method, self._collision, self._limit,
            min((moment.clearance for moment in moving), default=inf), last.time, period * len(moving),
            period * len(free), period * sum(moment.speed for moment in free), self._false_stop,
            last.time - self._wrong_since >= FALSE_STOP and last.time >= self.scenario.settled_at,
            _without_repeats(moment.verdict.zone for moment in self._seen),
            _without_repeats(moment.verdict.cause for moment in self._seen))

    def _too_late(self, hit: Hit) -> str:
        """Why it was in the way, or in the picture, for less time than it takes to see it and to stand."""
        thing = next(thing for thing in self.scenario.things if thing.name == hit.thing)
        if thing.path and hit.time - self._blocked_since < self._reaction(self._blocked_since):
            return SIDE_ENTRY
        # Who stands beside the corridor may be passed; who moves there is to be watched.
        watched = [moment for moment in self._seen if thing.path or not moment.free]
        shown = [moment.time for moment in watched if is_in_view(thing, moment.time, moment.pose)]
        if not shown:
            return BESIDE_THE_VIEW
        from_the_start = shown[0] == self._seen[0].time  # then it need not set out
        return BESIDE_THE_VIEW if not from_the_start and hit.time - shown[0] < self._reaction(shown[0]) else ""

    def _reaction(self, since: float) -> float:
        """[s] that it takes to see what is there from then on, and to stand."""
        speed = max((abs(moment.speed) for moment in self._seen if moment.time >= since), default=0.0)
        return 2 / Xtion().rate + self.scenario.transport + self.scenario.processing + speed / DRIVER.deceleration


def _without_repeats(names) -> tuple[str, ...]:
    return tuple(name for name, _ in groupby(names))
