# SPDX-License-Identifier: BSD-3-Clause
"""One drive: world, camera, driver, guard and base in lockstep, with the latencies that a robot has."""
from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator

from ...simulation.base import Velocity
from ...simulation.turtlebot import TICK, TurtleBot
from ..episode import Clouds
from ..scenario import XTION, Scenario
from ..stage import Stage
from .drivers import PERIOD, Driver, driver_of
from .guards import GUARDS, Guard, Passed
from .outcome import Hit, Judge, Moment, Outcome
from .truth import point_speed

_TICKS_A_PICTURE, _TICKS_A_COMMAND, _TICKS_AN_ODOMETRY = round(1 / (XTION.rate * TICK)), round(PERIOD / TICK), 2
_AFTER_PICTURE = 2  # ticks: a command comes between two pictures

Watch = "Callable[[Moment], None]"


def guarded_drive(scenario: Scenario, method: str, watch: Watch = lambda moment: None) -> Outcome:
    """Drive it with a guard of this method and judge it; a polite driver's way is driven unguarded too."""
    judge = _driven(scenario, method, watch)
    if not scenario.route:
        return judge.outcome()
    alone = _driven(scenario, "nobody", lambda moment: None)
    return judge.outcome(alone)


def _driven(scenario: Scenario, method: str, watch: Watch) -> Judge:
    stage, judge = Stage(scenario), Judge(scenario, method)
    try:
        for moment in moments(scenario, stage, GUARDS[method](scenario), driver_of(scenario)):
            judge.see(moment)
            watch(moment)
            if judge.is_over:
                break
    finally:
        stage.close()
    return judge


def moments(scenario: Scenario, stage: Stage, guard: Guard, driver: Driver) -> Iterator[Moment]:
    """One for every picture, with all that has happened since the last."""
    clouds, line, robot = Clouds(scenario, stage), Line(scenario, guard, driver), stage.robot
    hits: list[Hit] = []
    for tick in range(round(scenario.seconds / TICK)):
        now = tick * TICK
        if tick % _TICKS_A_PICTURE == 0:
            if guard.looks:
                clouds.take(now)
            yield Moment(now, robot.pose, robot.velocity, line.passed, clouds.latest, tuple(hits), driver.has_arrived)
            hits.clear()
        line.run(robot, clouds.arrived(now), tick)
        stage.move_things(now + TICK)
        robot.step()
        hits += _hits(robot, now + TICK)


class Line:
    """From clouds, odometry and driver through the guard to the base."""

    def __init__(self, scenario: Scenario, guard: Guard, driver: Driver) -> None:
        self.passed = Passed(Velocity(), Velocity(), 0.0, "NO_CLOUD")  # the latest
        self._scenario, self._guard, self._driver = scenario, guard, driver
        self._commands: deque[tuple[float, Velocity]] = deque()  # arrival [s]

    def run(self, robot: TurtleBot, cloud: tuple | None, tick: int) -> None:
        now, asked = tick * TICK, cloud is not None
        if self._scenario.odometry and tick % _TICKS_AN_ODOMETRY == 0:
            self._guard.note_odometry(robot.pose, robot.velocity, now)
        if cloud is not None:
            self._guard.see(cloud[1], cloud[0], now)
        if tick % _TICKS_A_COMMAND == _AFTER_PICTURE:
            self._guard.want(self._driver.wants(now, robot.pose, robot.velocity), now)
            asked = True
        if asked:
            self.passed = self._guard.answer(now)
            self._commands.append((now + self._scenario.processing, self.passed.given))
        while self._commands and self._commands[0][0] <= now + TICK / 2:
            robot.command(self._commands.popleft()[1])


def _hits(robot: TurtleBot, now: float) -> Iterator[Hit]:
    """By the wheels' speed toward each contact: they slip where the robot cannot go on."""
    for contact in robot.contacts:
        point, normal = contact.point[:2], contact.normal[:2]
        yield Hit(now, contact.obstacle, point, point_speed(robot.base.velocity, robot.pose, point, normal), contact.depth)
