# SPDX-License-Identifier: BSD-3-Clause
"""What became of a guarded drive, judged by the truth and not by what the guard believed."""
from __future__ import annotations

from dataclasses import dataclass, field
from math import hypot, inf
from typing import TYPE_CHECKING

import numpy as np

from ...simulation.base import DRIVER, Pose, Velocity
from ..scenario import XTION, Scenario
from .drivers import seen_from
from .guards import Passed
from .sighted import MEMORY_DISTANCE, MEMORY_TIME, Sighting, Sightings
from .truth import Ground, Law

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

CAUSED_ABOVE = 0.01  # [m/s] of the hull toward what it touches
WALKED_IN = 0.02  # [m] deep in the hull: the robot stays where it touches, and comes no deeper in a tick
APART = 0.5  # [s] without touching a thing, after which touching it is another touch
REACTION = 0.2  # [s] of the law, for a cloud as fresh as it comes: sensor_period, latency, base_reaction
MARGIN = 0.05  # [m] the guard's default
JUDGED_EVERY = 4  # pictures
LEAST = 0.02  # a greatest factor below this is standing
AHEAD = 0.05  # [m/s] more than this is going forward, where the camera looks
SEEING = "SEEN"  # the cause of an answer by what is seen

IN_VIEW, LEFT, LATE, FORGOTTEN, NEVER = KINDS = (
    "in view",  # where the camera looks, or nearer than it can see; returned in time to stop
    "left the view",  # returned in time to stop, and lay beside the picture or behind the robot when it was touched
    "too late",  # returned T before, but not in time to stop
    "forgotten",  # returned longer ago, or farther away, than a guard is to remember
    "never seen",
)


@dataclass(frozen=True)
class Hit:
    """The hull touches something."""

    time: float  # [s]
    thing: str
    point: tuple[float, float]  # [m] in the world
    approach: float  # [m/s] of the robot toward it
    depth: float = 0.0  # [m] of it in the hull


@dataclass(frozen=True)
class Moment:
    """The truth at one picture."""

    time: float  # [s]
    pose: Pose
    velocity: Velocity  # over the floor
    passed: Passed  # the guard's latest answer
    depth: NDArray[np.float32] | None = field(repr=False, compare=False)  # [m] the picture
    hits: tuple[Hit, ...] = ()  # since the last
    has_arrived: bool = False


@dataclass(frozen=True)
class Touch:
    """A contact toward which the robot moved."""

    hit: Hit
    kind: str  # one of KINDS
    wanted: tuple[float, float]  # [m/s], [rad/s] then
    cause: str  # of what was given then
    since_seen: float | None  # [s] since it returned something last; None: never


@dataclass(frozen=True)
class Outcome:
    family: str
    seed: int
    method: str
    hull: str  # circle or rectangle
    odometry: bool
    touches: tuple[Touch, ...]
    seconds: float
    metres: float  # driven
    shares: tuple[float, ...]  # given over greatest safe factor, at moments at which the robot was to go forward
    shares_seeing: tuple[float, ...]  # those of them at which nothing was lost from sight, or else in doubt
    shares_elsewhere: tuple[float, ...]  # at moments at which it was to turn in place or go backward
    safe: int  # moments at which all of a wish to go forward was safe
    whole: int  # of these, passed equal in every bit
    lost: int  # of these, not passed for what was lost from sight
    arrived: float | None = None  # [s] polite
    alone: float | None = None  # [s] without a guard
    alone_clearance: float | None = None  # [m] least, to what is there

    @property
    def name(self) -> str:
        return f"{self.family}:{self.seed}"

    @property
    def time_lost(self) -> float | None:
        """Of the time without a guard, as a share."""
        return self.arrived / self.alone - 1 if self.is_polite and self.arrived is not None else None

    @property
    def is_polite(self) -> bool:
        """Without a guard the same driver comes there, and keeps the margin that the guard is to keep."""
        return self.alone is not None and self.alone_clearance > MARGIN

    @property
    def is_stuck(self) -> bool:
        return self.is_polite and self.arrived is None


class Judge:
    """Sees the moments of one drive."""

    def __init__(self, scenario: Scenario, method: str) -> None:
        self._scenario, self._method = scenario, method
        self._things = {thing.name: thing for thing in scenario.things}
        self._ground, self._sightings = Ground(scenario), Sightings()
        self._law = law_for(scenario)
        self._touching: dict[str, float] = {}  # thing: [s] when last
        self._touches: list[Touch] = []
        self._shares: dict[str, list[float]] = {"ahead": [], "seeing": [], "elsewhere": []}
        self._safe = self._whole = self._lost = self._count = 0
        self._metres, self._last, self.arrived = 0.0, None, None
        self.clearance = inf  # [m] the least

    @property
    def is_over(self) -> bool:
        return self.arrived is not None

    def see(self, moment: Moment) -> None:
        for hit in moment.hits:
            self._note(hit, moment)
        if self._last:
            self._metres += hypot(moment.pose.x - self._last.pose.x, moment.pose.y - self._last.pose.y)
        if moment.has_arrived and self.arrived is None:
            self.arrived = moment.time
        if self._scenario.route:
            self.clearance = min(self.clearance, self._ground.clearance(moment.pose, moment.time))
        if self._count % JUDGED_EVERY == 2:
            self._weigh(moment)
        if moment.depth is not None:
            self._sightings.note(moment.depth, moment.pose, moment.time)
        self._count += 1
        self._last = moment

    def outcome(self, alone: Judge | None = None) -> Outcome:
        scenario, shares = self._scenario, self._shares
        return Outcome(
            scenario.family, scenario.seed, self._method, "rectangle" if scenario.hull else "circle", scenario.odometry,
            tuple(self._touches), self._last.time, self._metres, tuple(shares["ahead"]), tuple(shares["seeing"]), tuple(shares["elsewhere"]),
            self._safe, self._whole, self._lost, self.arrived, alone.arrived if alone else None, alone.clearance if alone else None)

    def _note(self, hit: Hit, moment: Moment) -> None:
        if hit.depth > WALKED_IN:  # nobody walks through a robot that stands, but here; what it does then is no other touch
            self._touching[hit.thing] = hit.time
            return
        if hit.approach <= CAUSED_ABOVE:
            return
        if hit.time - self._touching.get(hit.thing, -APART) >= APART:
            wanted = moment.passed.wanted
            sightings = self._sightings.of(self._things[hit.thing], hit.point, hit.time)
            self._touches.append(Touch(
                hit, _kind_of(hit, sightings, self._last or moment), (wanted.linear, wanted.angular), moment.passed.cause,
                hit.time - sightings[-1].time if sightings else None))
        self._touching[hit.thing] = hit.time

    def _weigh(self, moment: Moment) -> None:
        """What was given against what could have been."""
        passed, wanted = moment.passed, moment.passed.wanted
        greatest = self._ground.greatest_factor(wanted, moment.pose, moment.time, self._law)
        if greatest is None or greatest < LEAST:
            return
        share = min(1.0, passed.factor / greatest)
        if wanted.linear <= AHEAD:
            self._shares["elsewhere"].append(share)
            return
        self._shares["ahead"].append(share)
        if passed.cause == SEEING:
            self._shares["seeing"].append(share)
        if greatest == 1.0:
            self._safe += 1
            self._whole += passed.is_whole
            self._lost += not passed.is_whole and passed.cause != SEEING


def law_for(scenario: Scenario) -> Law:
    """What the guard is to keep to, for it has been told so."""
    return Law(REACTION, MARGIN, dict(scenario.settings).get("obstacle_speed", 0.0))


def _kind_of(hit: Hit, sightings: list[Sighting], before: Moment) -> str:
    known = [one for one in sightings if one.time <= hit.time - REACTION]
    if not known:
        return NEVER
    kept = [one for one in known if one.time >= hit.time - MEMORY_TIME and one.distance <= MEMORY_DISTANCE]
    if not kept:
        return FORGOTTEN
    speed = max(abs(before.velocity.linear), hit.approach)
    if kept[0].time > hit.time - REACTION - speed / DRIVER.deceleration:
        return LATE
    return IN_VIEW if _is_in_view(before.pose, hit.point) else LEFT


def _is_in_view(pose: Pose, point: tuple[float, float]) -> bool:
    """At any distance."""
    x, y, _ = XTION.mount
    c, s = np.cos(pose.yaw), np.sin(pose.yaw)
    camera = Pose(pose.x + c * x - s * y, pose.y + s * x + c * y, pose.yaw)
    return abs(seen_from(camera, point)[0]) <= XTION.horizontal_view / 2
