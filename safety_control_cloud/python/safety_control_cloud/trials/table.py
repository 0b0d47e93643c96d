# SPDX-License-Identifier: BSD-3-Clause
"""The summary as a table in a terminal."""
from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from rich.table import Table
from rich.text import Text

from .outcome import Outcome
from .summary import ALL, Row, is_collision, row, rows, sound

HEADINGS = ("family", "method", "drives", "collisions", "at limits", "clearance p1 [m]", "median [m]", "false stops", "stuck",
            "free [m/s]")


def cells(one: Row) -> tuple[str, ...]:
    """In the order of HEADINGS."""

    def count(number: int) -> str:
        return str(number) if number else "-"

    def metres(value: float, places: int = 2) -> str:
        return f"{value:.{places}f}" if isfinite(value) else "-"

    return (one.family, one.method, str(one.episodes), count(one.collisions), count(one.at_limits), metres(one.clearance_p1),
            metres(one.clearance_median), count(one.false_stops), count(one.stuck), metres(one.free_speed, 3))


def table_of(outcomes: Sequence[Outcome]) -> Table:
    table = Table(title="Drives in simulation")
    for heading in HEADINGS:
        table.add_column(Text(heading), justify="left" if heading in HEADINGS[:2] else "right", no_wrap=heading == "family")
    before = None
    for one in rows(outcomes):
        if one.family == ALL and before != ALL:
            table.add_section()
        family, *rest = cells(one)
        style = "bold red" if one.collisions and one.method == "ours" else None
        table.add_row("" if one.family == before else family, *rest, style=style)
        before = one.family
    return table


def verdict_of(outcomes: Sequence[Outcome]) -> list[str]:
    """A line for each method, and the names of our collisions."""
    lines = []
    for method in dict.fromkeys(one.method for one in outcomes):
        ours = [one for one in outcomes if one.method == method]
        well = sound(ours)
        false = 100 * sum(one.false_stop is not None for one in well) / max(1, len(well))
        stuck = 100 * sum(one.stuck for one in well) / max(1, len(well))
        one = row(ALL, method, ours)
        lines.append(f"{method}: {one.collisions} collisions, and {one.at_limits} touches at a limit of the camera, in "
                     f"{one.episodes} drives; where it works, {false:.1f} % of the drives with a false stop, {stuck:.1f} % "
                     "stuck at the end")
    collided = [one for one in outcomes if is_collision(one) and one.method == "ours"]
    return lines + [f"  collision: {one.name} with {one.collision.thing}" for one in collided]
