# SPDX-License-Identifier: BSD-3-Clause
"""One drive: world, camera, decision, multiplexer and base in lockstep, with the latencies that a robot has."""
from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from math import cos, inf, sin

import numpy as np

from ..simulation.base import Velocity
from ..simulation.closed_loop import TELEOP
from ..simulation.mux import Mux
from ..simulation.turtlebot import TICK, TurtleBot
from .deciders import Decider, Verdict, decider_for
from .outcome import Hit, Judge, Outcome, Truth
from .scenario import XTION, Scenario, random_of
from .stage import Stage

SOMEBODY = "Safe reactive controller"  # the input, of higher priority than TELEOP, by which the robot is turned
_TICKS_A_PICTURE = round(1 / (XTION.rate * TICK))

Watch = "Callable[[Stage, Truth], None]"


def episode(
    scenario: Scenario, method: str, watch: Watch = lambda stage, moment: None, decider: Decider | None = None
) -> Outcome:
    """Drive it by `method` and judge it; `watch` sees every moment. The same arguments give the same outcome.

    `decider`, if not the method's own, is one that somebody looks into.
    """
    stage, judge = Stage(scenario), Judge(scenario, method)
    try:
        for moment in moments(scenario, stage, decider or decider_for(method, scenario)):
            judge.see(moment)
            watch(stage, moment)
            if judge.is_over:
                break
    finally:
        stage.close()
    return judge.outcome()


def moments(scenario: Scenario, stage: Stage, decider: Decider) -> Iterator[Truth]:
    """One for every picture that the camera takes, with all that has happened since the last."""
    clouds, line, robot = Clouds(scenario, stage), Line(scenario, decider), stage.robot
    hits: list[Hit] = []
    for tick in range(round(scenario.seconds / TICK)):
        now = tick * TICK
        if tick % _TICKS_A_PICTURE == 0:
            clouds.take(now)
            yield Truth(now, robot.pose, robot.velocity.linear, line.verdict, stage.corridor_is_free(),
                        stage.clearance(), tuple(hits))
            hits.clear()
        line.run(robot, clouds.arrived(now), now)
        stage.move_things(now + TICK)
        robot.step()
        hits += _hits(robot)


class Clouds:
    """The pictures on their way from the camera to the node."""

    def __init__(self, scenario: Scenario, stage: Stage) -> None:
        self._scenario, self._stage = scenario, stage
        self._random = random_of(scenario.family, scenario.seed, purpose=2)
        self._under_way: deque[tuple[float, float, np.ndarray]] = deque()  # arrival [s], stamp [s], depth [m]
        self._last: np.ndarray | None = None

    @property
    def latest(self) -> np.ndarray | None:
        """[m] the picture that was taken last."""
        return self._last

    def take(self, now: float) -> None:
        faults = self._scenario.faults
        late = float(self._random.uniform(*faults.lateness))
        if any(spell.holds(now) for spell in faults.dropouts):
            return
        if self._last is None or faults.frozen is None or not faults.frozen.holds(now):
            self._last = self._stage.picture()
        arrival = max(now + self._scenario.transport + late, self._under_way[-1][0] if self._under_way else 0.0)
        stamp = now + (faults.skew if now >= faults.skewed_from else 0.0)
        self._under_way.append((arrival, stamp, self._last))

    def arrived(self, now: float) -> tuple[float, np.ndarray] | None:
        """The newest one's stamp [s] and depth [m]: the node's queue holds one."""
        newest = None
        while self._under_way and self._under_way[0][0] <= now + TICK / 2:
            _, *newest = self._under_way.popleft()
        return tuple(newest) if newest else None


class Line:
    """From the clouds through the node and the multiplexer to the base."""

    def __init__(self, scenario: Scenario, decider: Decider) -> None:
        self.verdict = Verdict("Danger", 0.0, "NO_CLOUD")  # the node's latest
        self._scenario, self._decider = scenario, decider
        self._mux = Mux()
        self._commands: deque[tuple[float, float]] = deque()  # arrival [s], speed [m/s]
        self._said_at = -inf

    def run(self, robot: TurtleBot, cloud: tuple[float, np.ndarray] | None, now: float) -> None:
        repeats = self._decider.repeats
        if cloud is not None:
            stamp, depth = cloud
            self._say(self._decider.decide(depth, stamp, now), now)
        elif repeats is not None and now - self._said_at >= repeats - TICK / 2:
            self._say(self._decider.without_cloud(now), now)
        self._pass_on(robot, now)

    def _say(self, verdict: Verdict, now: float) -> None:
        self.verdict, self._said_at = verdict, now
        self._commands.append((now + self._scenario.processing, verdict.speed))

    def _pass_on(self, robot: TurtleBot, now: float) -> None:
        for turn in self._scenario.turns:
            if turn.spell.holds(now) and self._mux.passes(SOMEBODY, now):
                robot.command(Velocity(0.0, turn.rate))
        while self._commands and self._commands[0][0] <= now + TICK / 2:
            _, speed = self._commands.popleft()
            if self._mux.passes(TELEOP, now):
                robot.command(Velocity(speed))


def _hits(robot: TurtleBot) -> Iterator[Hit]:
    """By the wheels' speed toward each contact: they slip where the robot cannot go on."""
    pose, speed = robot.pose, robot.base.velocity.linear
    for contact in robot.contacts:
        dx, dy = contact.point[0] - pose.x, contact.point[1] - pose.y
        ahead = (dx * cos(pose.yaw) + dy * sin(pose.yaw)) / (np.hypot(dx, dy) or 1.0)
        yield Hit(robot.time, contact.obstacle, speed * float(ahead))
