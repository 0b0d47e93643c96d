# SPDX-License-Identifier: BSD-3-Clause
"""One drive again, told moment by moment, drawn, or filmed."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PIL import Image
from rich.console import Console

from .drawing import plan_and_speed, plan_picture
from .episode import episode
from .outcome import Outcome, Truth
from .scenario import Scenario
from .stage import Stage

FRAME_TIME = 0.2  # [s] between two pictures of the film


def tell(scenario: Scenario, methods: Sequence[str], video: Path | None, console: Console, rrd: Path | None = None) -> None:
    """Prints what happened, and films or records the last of the methods."""
    console.print(f"{scenario.name}  " + ", ".join(f"{name} {value:g}" for name, value in scenario.facts), highlight=False)
    for method in methods:
        moments, outcome = moments_of(scenario, method)
        console.print(f"\n[bold]{method}[/]")
        for line in _told(moments, outcome):
            console.print(line, highlight=False)
    if video:
        _film(scenario, methods[-1], video)
        console.print(f"film of {methods[-1]}: {video}")
    if rrd:
        from .show import record

        record(scenario, methods[-1], rrd)


def moments_of(scenario: Scenario, method: str) -> tuple[list[Truth], Outcome]:
    moments: list[Truth] = []
    outcome = episode(scenario, method, lambda stage, moment: moments.append(moment))
    return moments, outcome


def draw_to(path: Path, scenario: Scenario, method: str) -> None:
    """A picture of the drive: the plan and the speed over time."""
    moments, outcome = moments_of(scenario, method)
    plan_and_speed(path, scenario, method, moments, outcome)


def _told(moments: Sequence[Truth], outcome: Outcome) -> list[str]:
    """A line whenever what is said, or what is true, changes."""
    lines, before = [], None
    for moment in moments:
        now = (moment.verdict.zone, moment.verdict.cause, moment.free)
        if now != before:
            free = "free" if moment.free else "not free"
            lines.append(f"{moment.time:6.2f} s  x {moment.pose.x:.3f} m  {moment.speed:.2f} m/s  clearance "
                         f"{moment.clearance:.3f} m  {moment.verdict.zone}, {moment.verdict.cause}; the corridor is {free}")
        before = now
    hit = outcome.collision
    if hit:
        why = f" ({outcome.limit})" if outcome.limit else ""
        lines.append(f"{hit.time:6.2f} s  ran into {hit.thing} at {hit.approach:.2f} m/s{why}")
    stops = "" if outcome.false_stop is None else f"; false stop at {outcome.false_stop:.2f} s"
    return [*lines, f"{outcome.seconds:6.2f} s  end{stops}{'; stuck' if outcome.stuck else ''}"]


def _film(scenario: Scenario, method: str, path: Path) -> None:
    frames: list[Image.Image] = []
    seen: list[Truth] = []

    def watch(stage: Stage, moment: Truth) -> None:
        seen.append(moment)
        if round(moment.time * 100) % round(FRAME_TIME * 100) == 0:
            plan = plan_picture(scenario, seen)
            frames.append(Image.fromarray(np.hstack([stage.colour(), plan])))

    episode(scenario, method, watch)
    frames[0].save(path, save_all=True, append_images=frames[1:], duration=round(1000 * FRAME_TIME), loop=0)
