# SPDX-License-Identifier: BSD-3-Clause
"""The summary as a table in a terminal."""
from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from rich.table import Table
from rich.text import Text

from ..summary import ALL
from .outcome import IN_VIEW, KINDS, Outcome
from .summary import Row, is_failure, row, rows

HEADINGS = ("family", "method", "drives", "way [m]", *KINDS, "given / safe", "seeing", "elsewhere", "whole", "seeing ",
            "polite", "stuck", "late p50", "late p90")
EXPLAINED = (
    "contacts while moving, with what was: " + ", ".join(KINDS),
    "given / safe: mean of the given over the greatest safe factor, where it was to go forward; seeing: while nothing was lost "
    "from sight; elsewhere: turning in place, backward",
    "whole: of what was safe ahead, passed equal in every bit; late: than without a guard")


def cells(one: Row) -> tuple[str, ...]:
    """In the order of HEADINGS."""

    def count(number: int) -> str:
        return str(number) if number else "-"

    def share(value: float) -> str:
        return f"{value:.2f}" if isfinite(value) else "-"

    def percent(value: float) -> str:
        return f"{100 * value:.1f}%" if isfinite(value) else "-"

    return (one.family, one.method, str(one.drives), f"{one.metres:.0f}", *(count(one.touches[kind]) for kind in KINDS),
            share(one.share), share(one.share_seeing), share(one.share_elsewhere), percent(one.whole),
            percent(one.whole_seeing), count(one.polite), count(one.stuck), percent(one.time_lost_median), percent(one.time_lost_p90))


def table_of(outcomes: Sequence[Outcome]) -> Table:
    told = [cells(one) for one in rows(outcomes)]
    shown = [place for place, heading in enumerate(HEADINGS) if place < 4 or any(line[place] != "-" for line in told)]
    table = Table(title="Guarded drives in simulation", caption="\n".join(EXPLAINED), caption_justify="left", padding=(0, 0, 0, 1))
    for place in shown:
        table.add_column(Text(HEADINGS[place]), justify="left" if place < 2 else "right", no_wrap=place < 2)
    for one, line in zip(rows(outcomes), told):
        if one.family == ALL:
            table.add_section()
        style = "bold red" if one.touches[IN_VIEW] and one.method == "ours" else None
        table.add_row(*(line[place] for place in shown), style=style)
    return table


def _by_odometry(outcomes: Sequence[Outcome], method: str) -> str:
    told = []
    for odometry, who in ((True, "with odometry"), (False, "without")):
        some = row(ALL, method, [one for one in outcomes if (one.method, one.odometry) == (method, odometry)])
        if isfinite(some.share):
            told.append(f"{some.share:.2f} {who} ({some.drives} drives)")
    return ", ".join(told) or "never to go forward"


def verdict_of(outcomes: Sequence[Outcome]) -> list[str]:
    """A line for each method, and our failures."""
    lines = []
    for method in dict.fromkeys(one.method for one in outcomes):
        one = row(ALL, method, [other for other in outcomes if other.method == method])
        touches = ", ".join(f"{count} {kind}" for kind, count in one.touches.items())
        lines.append(f"{method}: in {one.drives} drives, contacts while moving with what was {touches}")
        lines.append(f"  given / safe: {_by_odometry(outcomes, method)}")
    for one in outcomes:
        if one.method == "ours" and is_failure(one):
            touched = [touch.hit.thing for touch in one.touches if touch.kind == IN_VIEW]
            lines.append(f"  {one.name} ({one.hull}): " + (f"touched {', '.join(touched)}" if touched else "did not arrive"))
    return lines
