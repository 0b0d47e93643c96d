# SPDX-License-Identifier: BSD-3-Clause
"""What the judge's mode guard shows: the table, the differences."""
from __future__ import annotations

import argparse
from typing import Any, Dict, List, Sequence

from rich.table import Table
from rich.text import Text

from safety_control_cloud.judge.guard.compare import GIVEN, Difference
from safety_control_cloud.judge.guard.rows import GuardedBag
from safety_control_cloud.judge.replay_line import replay_line
from safety_control_cloud.judge.say import SHOWN, bags_of, empty_table, errors_of, why

FIGURES = ("commands", "passed", "scaled", "stopped", "first [s]", "differs [s]", "stopped [s]")


def by_time(rows: Sequence[GuardedBag]) -> List[GuardedBag]:
    """Those that could not be read first, and then those in which it stopped longest."""
    return sorted(rows, key=lambda row: (row.status != "error", -row.stopped_for, -row.differs_for, row.path))


def table_of(rows: Sequence[GuardedBag]) -> Table:
    table = empty_table(FIGURES)
    for row in by_time(rows)[:SHOWN]:
        path, *figures, _ = cells_of(row)
        table.add_row(Text(path), *map(Text, figures), why(row, row.causes))
    if len(rows) > SHOWN:
        table.add_row(f"... and {len(rows) - SHOWN} more")
    return table


def summary_of(rows: Sequence[GuardedBag]) -> str:
    commands, passed, scaled, stopped = (sum(getattr(row, name) for row in rows) for name in FIGURES[:4])
    differs, stands = (sum(getattr(row, name) for row in rows) for name in ("differs_for", "stopped_for"))
    return (f"{bags_of(rows)}, {commands:,} commands: {passed:,} pass, {scaled:,} scaled, {stopped:,} stopped; less than wanted "
            f"for {differs:.1f} s, nothing of it for {stands:.1f} s{errors_of(rows)}")


def told(differences: Sequence[Difference], given: argparse.Namespace) -> List[str]:
    """The longest differences, each with the command that shows it."""
    lines = [f"{len(differences):,} bag{' is' if len(differences) == 1 else 's are'} guarded differently"]
    for one in differences[:SHOWN]:
        often = "" if one.stretches == 1 else f" in {one.stretches} stretches"
        lines += [f"{one.path} first at {(one.time - one.start) / 1e9:.3f} s: {short(one.before)} -> {short(one.after)}; "
                  f"for {one.lasting / 1e9:.1f} s{often}", f"    {command(one.path, given)}"]
    return lines


def command(path: str, given: argparse.Namespace, place: int = 1) -> str:
    """What shows a bag by the settings, of two by the one at that place."""
    more = ["--mode", "guard"]
    for topic in given.topic:
        more += ["--topic", topic]
    for option, topic in (("--cmd-vel", given.cmd_vel), ("--odom", given.odom)):
        more += [option, topic] if topic else []
    return replay_line(path, given, place, *more)


def short(said: Dict[str, Any]) -> str:
    forward, left, turn = (said[name] for name in GIVEN)
    return f"{said['zone']}, {said['cause']}, {f'{left:+.2f}y ' if left else ''}{forward:.3f} {turn:+.3f}"


def moment_of(row: GuardedBag) -> str:
    """[s] of its first difference."""
    return "-" if row.differs_at is None or row.start is None else f"{(row.differs_at - row.start) / 1e9:.3f}"


def cells_of(row: GuardedBag) -> Sequence[str]:
    """Path, FIGURES, causes."""
    figures = [str(getattr(row, name)) for name in FIGURES[:4]]
    return (row.path, *figures, moment_of(row), f"{row.differs_for:.1f}", f"{row.stopped_for:.1f}", why(row, row.causes).plain)
