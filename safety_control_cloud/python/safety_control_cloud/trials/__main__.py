# SPDX-License-Identifier: BSD-3-Clause
"""Randomised drives in simulation: does the robot run into things?"""
from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from os import cpu_count
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from .deciders import METHODS
from .families import FAMILIES
from .outcome import Outcome
from .run import drive_all, jobs_for
from .summary import is_collision, to_json
from .table import table_of, verdict_of

COLLIDED, INTERRUPTED = 1, 130  # exit codes; argparse says 2


def options(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="trials", description=__doc__, epilog="Exit code 1: our method has run into something it could have seen.")
    parser.add_argument("--episodes", metavar="N", type=_positive, default=1000,
                        help="shared out among the families [%(default)s]")
    parser.add_argument("--seed", metavar="S", type=int, default=1,
                        help="of the first episode of each family [%(default)s]")
    parser.add_argument("--jobs", metavar="J", type=_positive, default=cpu_count() or 1, help="processes [%(default)s]")
    parser.add_argument("--method", choices=(*METHODS, "both"), default="both", help="[%(default)s]")
    parser.add_argument("--family", choices=tuple(FAMILIES), action="append", default=[], metavar="F",
                        help=f"only this one; may be repeated: {', '.join(FAMILIES)}")
    parser.add_argument("--json", metavar="F", type=Path, help="write the table and every outcome")
    parser.add_argument("--report", metavar="DIR", type=Path,
                        help="write a page with the table, histograms and our collisions")
    parser.add_argument("--replay", metavar="FAMILY:SEED", type=_scenario, help="one drive, told moment by moment")
    parser.add_argument("--video", metavar="F.gif", type=Path, help="with --replay: what the robot saw and where it went")
    given = parser.parse_args(arguments)
    if given.video and not given.replay:
        parser.error("--video goes with --replay")
    return given


def main() -> int:
    given = options()
    methods = METHODS if given.method == "both" else (given.method,)
    try:
        return _replay(given, methods) if given.replay else _drive(given, methods)
    except KeyboardInterrupt:
        return INTERRUPTED


def _replay(given: argparse.Namespace, methods: Sequence[str]) -> int:
    from .replay import replay

    replay(*given.replay, methods, given.video, _console())
    return 0


def _drive(given: argparse.Namespace, methods: Sequence[str]) -> int:
    outcomes = _with_progress(jobs_for(given.episodes, given.seed, methods, given.family), given.jobs)
    console = _console()
    console.print(table_of(outcomes))
    for line in verdict_of(outcomes):
        console.print(line, highlight=False)
    if given.json:
        given.json.write_text(to_json(outcomes) + "\n")
    if given.report:
        from .report import write_report

        console.print(f"report: {write_report(outcomes, given.report)}")
    return COLLIDED if any(is_collision(one) and one.method == "ours" for one in outcomes) else 0


def _console() -> Console:
    return Console(width=None if sys.stdout.isatty() else 130)


def _with_progress(jobs, workers: int) -> list[Outcome]:
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("drives", total=len(jobs))
        return drive_all(jobs, workers, lambda outcome: progress.advance(task))


def _positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return number


def _scenario(text: str) -> tuple[str, int]:
    family, _, seed = text.partition(":")
    if family not in FAMILIES or not seed.isdigit():
        raise argparse.ArgumentTypeError(f"{text!r} is not FAMILY:SEED; the families are {', '.join(FAMILIES)}")
    return family, int(seed)


if __name__ == "__main__":
    sys.exit(main())
