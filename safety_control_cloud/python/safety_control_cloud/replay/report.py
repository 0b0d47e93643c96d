# SPDX-License-Identifier: BSD-3-Clause
"""Answers as a table for people and as JSON for programs."""
from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any, Dict, Iterable, Iterator, Sequence, TypeVar

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table
from rich.text import Text

from safety_control_cloud.replay.lockstep import Answer

COLOURS = {"Safe": "green", "Warning": "yellow", "Danger": "red"}
LONGEST_CAUSE = len("UNREADABLE:")
WIDE = 240  # columns, where there is no terminal whose width would limit the table

Item = TypeVar("Item")


def with_progress(items: Iterable[Item], count: int) -> Iterator[Item]:
    """The same items, with a bar on stderr if that is a terminal."""
    console = Console(stderr=True)
    columns = (TextColumn("clouds"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, disable=not console.is_terminal, transient=True) as progress:
        yield from progress.track(items, total=count)


def print_table(answers: Sequence[Answer], title: str) -> None:
    console = Console()
    if not console.is_terminal:
        console = Console(width=WIDE)
    console.print(table_of(answers, title))


def table_of(answers: Sequence[Answer], title: str) -> Table:
    """Fits into 80 columns, where the words of a cause are folded."""
    table = Table(
        box=SIMPLE_HEAD, show_edge=False, pad_edge=False, padding=(0, 1, 0, 0), title=Text(title),
        title_justify="left", caption=summary_of(answers), caption_justify="left")
    table.add_column(Text("stamp\n[s]"), justify="right", no_wrap=True)
    table.add_column("zone", no_wrap=True)
    table.add_column("cause", min_width=LONGEST_CAUSE)
    for figure in ("nearest\n[m]", "inside/returns/total\n[points]", "speed\n[m/s]"):
        table.add_column(Text(figure), justify="right", no_wrap=True)
    for answer in answers:
        table.add_row(*_cells(answer))
    return table


def summary_of(answers: Sequence[Answer]) -> str:
    zones = [answer.zone for answer in answers]
    counted = ", ".join(f"{zone} {zones.count(zone)}" for zone in COLOURS)
    return f"{len(answers)} cloud{'' if len(answers) == 1 else 's'}: {counted}"


def write_json(answers: Sequence[Answer], path: Path) -> None:
    """A list of objects with the names of Answer; stamp in [s]."""
    path.write_text(json.dumps([_object(answer) for answer in answers], indent=1, allow_nan=False) + "\n")


def _object(answer: Answer) -> Dict[str, Any]:
    return {**asdict(answer), "stamp": answer.stamp / 1e9}


def _cells(answer: Answer) -> Sequence[Text]:
    seen = answer.cause == "SEEN"
    nearest = "free" if seen else "-"
    return (
        Text(f"{answer.stamp // 10**9}.{answer.stamp % 10**9:09d}"),
        Text(answer.zone, style=COLOURS.get(answer.zone, "")),
        Text(answer.cause if seen else f"{answer.cause}: {answer.reason}"),
        Text(nearest if answer.nearest is None else f"{answer.nearest:.3f}"),
        Text(f"{answer.inside}/{answer.returns}/{answer.total}"),
        Text(f"{round(answer.speed, 3)}"),
    )
