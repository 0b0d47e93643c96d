# SPDX-License-Identifier: BSD-3-Clause
"""Answers as a table for people and as JSON for programs."""
from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any, Dict, Iterable, Iterator, List, Optional, Sequence, TypeVar

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table
from rich.text import Text

from safety_control_cloud.replay.lockstep import Answer
from safety_control_cloud.replay.silence import Silence, by_topic
from safety_control_cloud.zone_colours import PRINTED as COLOURS

NEXT_TO = 5  # clouds on either side of the one that is asked for
LONGEST_CAUSE = len("UNREADABLE:")
WIDE = 240  # columns, where there is no terminal whose width would limit the table

Item = TypeVar("Item")


def with_progress(items: Iterable[Item], count: int, what: str = "clouds") -> Iterator[Item]:
    """The same items, with a bar on stderr if that is a terminal."""
    console = Console(stderr=True)
    columns = (TextColumn(what), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, disable=not console.is_terminal, transient=True) as progress:
        yield from progress.track(items, total=count)


def print_table(
    answers: Sequence[Answer], title: str, silences: Sequence[Silence] = (), around: Optional[int] = None
) -> None:
    """Of the clouds next to number `around` of each topic, if there is one."""
    console = Console()
    if not console.is_terminal:
        console = Console(width=WIDE)
    console.print(table_of(answers, title, silences, around))


def table_of(
    answers: Sequence[Answer], title: str, silences: Sequence[Silence] = (), around: Optional[int] = None
) -> Table:
    """Fits into 80 columns, where the words of a cause are folded. Of several topics, each row names its own."""
    several = len(by_topic(answers)) > 1
    table = Table(
        box=SIMPLE_HEAD, show_edge=False, pad_edge=False, padding=(0, 1, 0, 0), title=Text(title),
        title_justify="left", caption=summary_of(answers, silences), caption_justify="left")
    table.add_column(Text("stamp\n[s]"), justify="right", no_wrap=True)
    if several:
        table.add_column("topic", overflow="fold")
    table.add_column("zone", no_wrap=True)
    table.add_column("cause", min_width=LONGEST_CAUSE)
    for figure in ("nearest\n[m]", "inside/returns/total\n[points]", "speed\n[m/s]"):
        table.add_column(Text(figure), justify="right", no_wrap=True)
    silent = {(silence.topic, silence.after): silence for silence in silences}
    seen: Dict[str, int] = {}
    for answer in answers:
        number = seen[answer.topic] = seen.get(answer.topic, -1) + 1
        if around is not None and abs(number - around) > NEXT_TO:
            continue
        name = [Text(answer.topic)] if several else []
        table.add_row(*_with(name, _cells(answer)), style="bold" if number == around else "")
        if (answer.topic, number) in silent:
            table.add_row(*_with(name, _silent_cells(silent[answer.topic, number])))
    return table


def _with(name: List[Text], cells: Sequence[Text]) -> Sequence[Text]:
    return (cells[0], *name, *cells[1:])


def summary_of(answers: Sequence[Answer], silences: Sequence[Silence] = ()) -> str:
    """A line for each topic."""
    topics = by_topic(answers)
    if len(topics) < 2:
        return _summary(answers, silences)
    return "\n".join(f"{topic}: {_summary(its, [silence for silence in silences if silence.topic == topic])}"
                     for topic, its in topics.items())


def _summary(answers: Sequence[Answer], silences: Sequence[Silence]) -> str:
    zones = [answer.zone for answer in answers]
    counted = ", ".join(f"{zone} {zones.count(zone)}" for zone in COLOURS)
    silent = sum(silence.end - silence.start for silence in silences) / 1e9
    gaps = f"; SILENT {len(silences)} times, {silent:.1f} s in all" if silences else ""
    return f"{len(answers)} cloud{'' if len(answers) == 1 else 's'}: {counted}{gaps}"


def write_json(answers: Sequence[Answer], path: Path) -> None:
    """A list of objects with the names of Answer; stamp and time in [s]."""
    path.write_text(json.dumps([_object(answer) for answer in answers], indent=1, allow_nan=False) + "\n")


def _object(answer: Answer) -> Dict[str, Any]:
    return {**asdict(answer), "stamp": answer.stamp / 1e9, "time": answer.time / 1e9}


def _silent_cells(silence: Silence) -> Sequence[Text]:
    lasts = (silence.end - silence.start) / 1e9
    return (Text("-"), Text("Danger", style=COLOURS["Danger"]), Text(f"SILENT: {lasts:.3f} s more without a cloud"),
            Text("-"), Text("-"), Text("0.0"))


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
