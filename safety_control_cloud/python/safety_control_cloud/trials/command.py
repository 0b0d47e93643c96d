# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/trials does with its arguments."""
from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace
from datetime import date
from shlex import quote
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from ..view.options import recorded_in
from .names import METHODS
from .run import Interrupted, Job, drive_all, jobs_for
from .summary import is_collision, to_json
from .table import table_of, verdict_of

COLLIDED = 1  # exit code


def run(given: argparse.Namespace) -> int:
    """Gives the exit code."""
    methods = METHODS if given.method == "both" else (given.method,)
    return _replay(given, methods) if given.replay else _drive(given, methods)


def _replay(given: argparse.Namespace, methods: Sequence[str]) -> int:
    if given.driver:
        from .guarded import replay as guarded

        guarded.replay(*given.replay, methods, _console())
        return 0
    from .families import scenario_of
    from .telling import tell

    scenario = scenario_of(*given.replay)
    if given.strays is not None:
        scenario = replace(scenario, stray=given.strays)
    with recorded_in(given.rrd, given.view) as rrd:
        tell(scenario, methods, given.video, _console(), rrd)
    return 0


def _drive(given: argparse.Namespace, methods: Sequence[str]) -> int:
    jobs = jobs_for(given.episodes, given.seed, methods, given.family, given.driver or "")
    try:
        return _tell(_with_progress(jobs, given), given)
    except Interrupted as interrupted:
        if interrupted.outcomes:
            _tell(interrupted.outcomes, given)
        print(f"interrupted: {len(interrupted.outcomes)} of {len(jobs)} drives", file=sys.stderr)
        raise KeyboardInterrupt from None


def _tell(outcomes: Sequence[Any], given: argparse.Namespace) -> int:
    if given.driver:
        return _tell_guarded(outcomes, given)
    console = _console()
    console.print(table_of(outcomes))
    for line in verdict_of(outcomes):
        console.print(line, highlight=False)
    if given.json:
        given.json.write_text(to_json(outcomes) + "\n")
    if given.report:
        from .report import write_report

        console.print(f"report: {write_report(outcomes, given.report, _made_by(given.seed))}")
    return COLLIDED if any(is_collision(one) and one.method == "ours" for one in outcomes) else 0


def _tell_guarded(outcomes: Sequence[Any], given: argparse.Namespace) -> int:
    from .guarded import summary, table

    console = _console()
    console.print(table.table_of(outcomes))
    for line in table.verdict_of(outcomes):
        console.print(line, highlight=False)
    if given.json:
        given.json.write_text(summary.to_json(outcomes) + "\n")
    if given.report:
        from .guarded.report import write_report

        console.print(f"report: {write_report(outcomes, given.report, given.driver, _made_by(given.seed))}")
    return COLLIDED if any(summary.is_failure(one) and one.method == "ours" for one in outcomes) else 0


def _made_by(seed: int) -> str:
    return f"scripts/trials {' '.join(map(quote, sys.argv[1:]))}  (seed {seed}, {date.today().isoformat()})"


def _console() -> Console:
    return Console(width=None if sys.stdout.isatty() else 130)


def _with_progress(jobs: Sequence[Job], given: argparse.Namespace) -> list[Any]:
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("drives", total=len(jobs))
        say = progress.console.print
        return drive_all(jobs, given.jobs, lambda outcome: progress.advance(task), given.scheduler, say)
