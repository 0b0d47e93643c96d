# SPDX-License-Identifier: BSD-3-Clause
"""One guarded drive again, told moment by moment, or drawn."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from rich.console import Console

from ..families import scenario_of
from ..scenario import Scenario
from .drawing import Block, Spot, draw
from .drive import guarded_drive
from .outcome import Moment, Outcome


def replay(family: str, seed: int, methods: Sequence[str], console: Console) -> None:
    """Prints what happened."""
    scenario = scenario_of(family, seed)
    facts = ", ".join(f"{name} {value:g}" for name, value in scenario.facts)
    console.print(f"{scenario.name}  {'rectangle' if scenario.hull else 'circle'}  {facts}", highlight=False)
    for method in methods:
        moments, outcome = moments_of(scenario, method)
        console.print(f"\n[bold]{method}[/]")
        for line in _told(moments, outcome):
            console.print(line, highlight=False, markup=False)


def moments_of(scenario: Scenario, method: str) -> tuple[list[Moment], Outcome]:
    """Without their pictures."""
    moments: list[Moment] = []
    outcome = guarded_drive(scenario, method, lambda moment: moments.append(replace(moment, depth=None)))
    return moments, outcome


def draw_to(path: Path, scenario: Scenario, method: str) -> None:
    moments, outcome = moments_of(scenario, method)
    spots = [Spot(one.time, one.pose, one.passed.wanted, one.passed.given, one.passed.factor) for one in moments]
    end = moments[-1].time
    blocks = [Block(*thing.place(end), thing.at.yaw, thing.size[0], thing.size[1], thing.round) for thing in scenario.things]
    draw(path, f"{scenario.name}, {method}", spots, blocks, scenario.hull, [touch.hit.point for touch in outcome.touches])


def _told(moments: Sequence[Moment], outcome: Outcome) -> list[str]:
    """A line whenever what is said changes, and every touch."""
    lines, before, told = [], None, 0
    for moment in moments:
        passed = moment.passed
        now = (round(passed.factor, 1), passed.cause)
        while told < len(outcome.touches) and outcome.touches[told].hit.time <= moment.time:
            touch = outcome.touches[told]
            seen = "" if touch.since_seen is None else f", which returned {touch.since_seen:.2f} s before"
            lines.append(f"{touch.hit.time:6.2f} s  touched {touch.hit.thing} at {touch.hit.approach:.2f} m/s: {touch.kind}{seen}")
            told += 1
        if now != before:
            pose, wanted = moment.pose, passed.wanted
            lines.append(f"{moment.time:6.2f} s  ({pose.x:.2f}, {pose.y:.2f}, {pose.yaw:.2f})  wants {wanted.linear:.2f} m/s "
                         f"{wanted.angular:.2f} rad/s, given {passed.factor:.2f}: {passed.cause}, {passed.reason}")
        before = now
    lost = "" if outcome.time_lost is None else f", {100 * outcome.time_lost:.1f} % later than without a guard"
    arrived = "" if outcome.arrived is None else f"; arrived{lost}"
    return [*lines, f"{outcome.seconds:6.2f} s  end, {outcome.metres:.1f} m driven{arrived}{'; stuck' if outcome.is_stuck else ''}"]
