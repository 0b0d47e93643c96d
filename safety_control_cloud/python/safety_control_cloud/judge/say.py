# SPDX-License-Identifier: BSD-3-Clause
"""What a run of the judge shows: the bar, the table, the differences."""
from __future__ import annotations

import argparse
import sys
from contextlib import contextmanager
from typing import Callable, Iterator, List, Mapping, Sequence, Tuple

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table
from rich.text import Text

from safety_control_cloud.judge.compare import Difference
from safety_control_cloud.judge.rows import BagRow
from safety_control_cloud.judge.table import AnyBag
from safety_control_cloud.zone_colours import PRINTED as COLOURS

WIDE = 200  # columns, where there is no terminal whose width would limit the table
SHOWN = 20  # bags and differences at most; all of them are in the files


def console() -> Console:
    return Console(width=None if sys.stdout.isatty() else WIDE, highlight=False)


@contextmanager
def progress(total: int, things: str) -> Iterator[Tuple[Callable[[Sequence[AnyBag]], None], Callable[[str], None]]]:
    """What to call with the rows of a bag that is done, and with a line to say meanwhile. `things`: clouds, or answers."""
    shown = Console(stderr=True)
    columns = (TextColumn("bags"), BarColumn(), MofNCompleteColumn(), TextColumn("{task.fields[met]}"), TimeRemainingColumn())
    with Progress(*columns, console=shown, disable=not shown.is_terminal, transient=True) as bar:
        task, met = bar.add_task("bags", total=total, met=""), [0, 0]

        def done(rows: Sequence[AnyBag]) -> None:
            met[0] += sum(row.rows for row in rows)
            met[1] += any(row.status == "error" for row in rows)
            bar.update(task, advance=1, met=f"{met[0]:,} {things}" + (f", {met[1]} errors" if met[1] else ""))

        yield done, lambda line: bar.console.print(line, markup=False, highlight=False)


def empty_table(figures: Sequence[str]) -> Table:
    """Between a bag and its causes."""
    table = Table(box=SIMPLE_HEAD, show_edge=False, pad_edge=False, padding=(0, 1, 0, 0))
    table.add_column("bag", overflow="fold")
    for figure in figures:
        table.add_column(Text(figure), justify="right")
    table.add_column("causes")
    return table


def table_of(rows: Sequence[BagRow]) -> Table:
    """The bags that stood most first, and all of them together."""
    table = empty_table(("clouds", "silences", *COLOURS, "nearest [m]"))
    by_danger = sorted(rows, key=lambda row: (row.status != "error", -row.zones.get("Danger", 0), row.path))
    for row in by_danger[:SHOWN]:
        table.add_row(*_cells(row))
    if len(rows) > SHOWN:
        table.add_row(f"... and {len(rows) - SHOWN} more")
    return table


def summary_of(rows: Sequence[BagRow]) -> str:
    zones = ", ".join(f"{zone} {sum(row.zones.get(zone, 0) for row in rows):,}" for zone in COLOURS)
    return (f"{bags_of(rows)}, {sum(row.clouds for row in rows):,} clouds, {sum(row.silences for row in rows):,} silences: {zones}"
            + errors_of(rows))


def bags_of(rows: Sequence[AnyBag]) -> str:
    return f"{len(rows):,} bag{'' if len(rows) == 1 else 's'}"


def errors_of(rows: Sequence[AnyBag]) -> str:
    errors = sum(row.status == "error" for row in rows)
    return f"; {errors} could not be read to the end" if errors else ""


def told(differences: Sequence[Difference], given: argparse.Namespace) -> List[str]:
    """The largest differences, each with the command that shows it."""
    lines = [f"{sum(one.length for one in differences):,} clouds and silences are decided differently"]
    for one in differences[:SHOWN]:
        before, after = (_short(verdict) for verdict in (one.before, one.after))
        clouds = f"cloud {one.number}" if one.length == 1 else f"clouds {one.number} to {one.number + one.length - 1}"
        lines += [f"{one.path} {one.topic} {clouds}: {before} -> {after}", f"    {one.command(given)}"]
    return lines


def _short(verdict) -> str:
    return "nothing" if verdict is None else f"{verdict['zone']}, {verdict['cause']}, {verdict['speed']:g} m/s"


def _cells(row: BagRow) -> Sequence[Text]:
    zones = [Text(str(row.zones.get(zone, 0)), style=COLOURS[zone]) for zone in COLOURS]
    nearest = "-" if row.nearest is None else f"{row.nearest:.3f}"
    return (Text(row.path), Text(str(row.clouds)), Text(str(row.silences)), *zones, Text(nearest), why(row, row.causes))


def why(row: AnyBag, causes: Mapping[str, int]) -> Text:
    if row.status == "error":
        return Text(f"error: {row.error}")
    return Text(", ".join(f"{name} {count}" for name, count in sorted(causes.items())))
