# SPDX-License-Identifier: BSD-3-Clause
"""The guard's answers as a table for people, a row for each span in which it did the same, and each as JSON."""
from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass
from itertools import groupby
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table
from rich.text import Text

from safety_control_cloud.replay.guard.counts import PASSES, ZONES, Counts, does
from safety_control_cloud.replay.guard.drive import Answer, Numbers
from safety_control_cloud.replay.guard.run import Guarded
from safety_control_cloud.replay.report import WIDE
from safety_control_cloud.zone_colours import PRINTED as COLOURS


@dataclass(frozen=True)
class Span:
    """Answers in a row of one kind and cause."""

    does: str  # PASSES, LESS or NOTHING
    answers: Sequence[Answer]
    end: int  # [ns] when the next span begins

    @property
    def first(self) -> Answer:
        return self.answers[0]

    @property
    def least(self) -> float:
        return min(answer.factor for answer in self.answers)


def spans(answers: Sequence[Answer], end: int) -> List[Span]:
    grouped = [(kind, list(its)) for (kind, _), its in groupby(answers, lambda answer: (does(answer), answer.cause))]
    ends = [its[0].time for _, its in grouped[1:]] + [end]
    return [Span(kind, its, until) for (kind, its), until in zip(grouped, ends)]


def print_guarded(guarded: Guarded, end: int, title: str) -> None:
    console = Console()
    if not console.is_terminal:
        console = Console(width=WIDE)
    console.print(table_of(guarded, end, title))


def table_of(guarded: Guarded, end: int, title: str) -> Table:
    """Times since the bag's start. What is wanted, given and driven is that at the span's first moment."""
    table = Table(
        box=SIMPLE_HEAD, show_edge=False, pad_edge=False, padding=(0, 1, 0, 0), title=Text(title),
        title_justify="left", caption=summary_of(guarded, end), caption_justify="left")
    for name in ("at\n[s]", "for\n[s]", "wanted\n[m/s rad/s]", "given\n[m/s rad/s]", "driven\n[m/s rad/s]", "factor\n(least)"):
        table.add_column(Text(name), justify="right", no_wrap=True)
    table.add_column("cause")
    for span in spans(guarded.answers, end):
        table.add_row(*_cells(span, guarded.start))
    return table


def summary_of(guarded: Guarded, end: int) -> str:
    """How often commands passed, and the moment where something else was given first; without the start."""
    counts = Counts()
    for answer in guarded.answers:
        counts.add(answer)
    counts.end(end)
    told = (f"{counts.commands} command{'' if counts.commands == 1 else 's'}: {counts.passed} pass, {counts.scaled} scaled, "
            f"{counts.stopped} stopped{f'; {counts.early} before the first picture' if counts.early else ''}")
    first = counts.first
    if not first:
        return f"{told}\nwhat was wanted is what the guard gives"
    where = f" by {first.sensor}" if first.sensor else ""
    return (f"{told}\ndiffers first at {(first.time - guarded.start) / 1e9:.3f} s: {motion_of(first.wanted)} wanted, "
            f"{motion_of(first.given)} given, {first.cause}{where}; for {counts.differing / 1e9:.1f} s in all")


def write_json(guarded: Guarded, path: Path) -> None:
    """A list of objects with the names of Answer; time in [s] of the bag, infinity as null."""
    path.write_text(json.dumps([_object(answer) for answer in guarded.answers], indent=1, allow_nan=False) + "\n")


def _object(answer: Answer) -> Dict[str, Any]:
    whole = {**asdict(answer), "time": answer.time / 1e9, "differs": answer.differs}
    for name in ("wanted", "given"):
        whole[name] = {"linear": list(map(_finite, whole[name][:3])), "angular": list(map(_finite, whole[name][3:]))}
    whole["driven"] = None if answer.driven is None else list(map(_finite, answer.driven))
    whole["time_to_contact"] = _finite(answer.time_to_contact)
    return whole


def _finite(value: float) -> Optional[float]:
    """JSON has no other numbers."""
    return value if math.isfinite(value) else None


def _cells(span: Span, start: int) -> Sequence[Text]:
    first = span.first
    reason = "" if span.does == PASSES else f": {first.reason}"
    sensor = f", {first.sensor}" if first.sensor else ""
    driven = "-" if first.driven is None else _figures(first.driven[0], first.driven[2])
    return (
        Text(f"{(first.time - start) / 1e9:.3f}"), Text(f"{(span.end - first.time) / 1e9:.3f}"), Text(motion_of(first.wanted)),
        Text(motion_of(first.given), style=COLOURS[ZONES[span.does]]), Text(driven), Text(f"{span.least:.2f}"),
        Text(f"{first.cause}{sensor}{reason}"))


def motion_of(numbers: Numbers) -> str:
    """Forward and turning; what a robot of two wheels drives."""
    sideward = f"{numbers[1]:+.2f}y " if numbers[1] else ""
    return f"{sideward}{_figures(numbers[0], numbers[5])}"


def _figures(forward: float, turning: float) -> str:
    return f"{forward:.3f} {turning:+.3f}"
