# SPDX-License-Identifier: BSD-3-Clause
"""The guard's answers as a table for people, a row for each span in which it did the same, and each as JSON."""
from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass
from itertools import dropwhile, groupby
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table
from rich.text import Text

from safety_control_cloud.replay.guard.drive import COMMAND, Answer, Numbers
from safety_control_cloud.replay.guard.run import Guarded
from safety_control_cloud.replay.report import WIDE
from safety_control_cloud.zone_colours import PRINTED as COLOURS

NOT_YET = ("NO_CLOUD", "NO_TRANSFORM")  # of a guard that has just started
PASSES, LESS, NOTHING = "passes", "less", "nothing"
ZONES = {PASSES: "Safe", LESS: "Warning", NOTHING: "Danger"}


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


def does(answer: Answer) -> str:
    if not answer.differs and answer.factor > 0.0:
        return PASSES
    return LESS if answer.factor > 0.0 else NOTHING


def zone_of(answer: Answer) -> str:
    """As the node's ~state has it."""
    return ZONES[does(answer)]


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
    answers = _after_start(guarded.answers)
    commands = [answer for answer in answers if answer.asked_by == COMMAND]
    early = sum(answer.asked_by == COMMAND for answer in guarded.answers) - len(commands)
    scaled = sum(answer.differs and answer.factor > 0.0 for answer in commands)
    stopped = sum(answer.differs and answer.factor == 0.0 for answer in commands)
    told = (f"{len(commands)} command{'' if len(commands) == 1 else 's'}: {len(commands) - scaled - stopped} pass, "
            f"{scaled} scaled, {stopped} stopped{f'; {early} before the first picture' if early else ''}")
    ends = [*(answer.time for answer in answers[1:]), end]
    differ = [(answer, until - answer.time) for answer, until in zip(answers, ends) if answer.differs]
    if not differ:
        return f"{told}\nwhat was wanted is what the guard gives"
    first, lasting = differ[0][0], sum(lasts for _, lasts in differ) / 1e9
    where = f" by {first.sensor}" if first.sensor else ""
    return (f"{told}\ndiffers first at {(first.time - guarded.start) / 1e9:.3f} s: {_motion(first.wanted)} wanted, "
            f"{_motion(first.given)} given, {first.cause}{where}; for {lasting:.1f} s in all")


def _after_start(answers: Sequence[Answer]) -> List[Answer]:
    """A guard that had run before the bag began would have seen by then; all, if nothing is ever seen."""
    return list(dropwhile(lambda answer: answer.cause in NOT_YET, answers)) or list(answers)


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
        Text(f"{(first.time - start) / 1e9:.3f}"), Text(f"{(span.end - first.time) / 1e9:.3f}"), Text(_motion(first.wanted)),
        Text(_motion(first.given), style=COLOURS[ZONES[span.does]]), Text(driven), Text(f"{span.least:.2f}"),
        Text(f"{first.cause}{sensor}{reason}"))


def _motion(numbers: Numbers) -> str:
    """Forward and turning; what a robot of two wheels drives."""
    sideward = f"{numbers[1]:+.2f}y " if numbers[1] else ""
    return f"{sideward}{_figures(numbers[0], numbers[5])}"


def _figures(forward: float, turning: float) -> str:
    return f"{forward:.3f} {turning:+.3f}"
