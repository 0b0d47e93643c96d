# SPDX-License-Identifier: BSD-3-Clause
"""Which drives, by the command line; needs Python alone."""
from __future__ import annotations

import argparse
from collections.abc import Sequence
from os import cpu_count
from pathlib import Path

from ..commands.arguments import count, seed
from ..view import options as view
from .names import DRIVERS, FAMILIES, METHODS

ALL = (*FAMILIES, *(family for families in DRIVERS.values() for family in families))
FILM = ".gif"
OF_MANY = ("episodes", "seed", "jobs", "family", "json", "report", "scheduler")  # drives, not of one
PURPOSE = "Randomised drives in simulation: does the robot run into things?"


def options(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="trials", description=PURPOSE, epilog="Exit code 1: our method has run into something it could have seen; "
        "as a guard: into something in view, or it held up a polite driver for good.")
    parser.add_argument("--driver", choices=(*DRIVERS,), help="somebody else drives, and the methods guard: one who tries to "
                        "hit things, or one who follows a path")
    parser.add_argument("--episodes", metavar="N", type=count, default=1000,
                        help="shared out among the families [%(default)s]")
    parser.add_argument("--seed", metavar="S", type=seed, default=1,
                        help="of the first episode of each family [%(default)s]")
    parser.add_argument("--jobs", metavar="J", type=count, default=cpu_count() or 1, help="processes [%(default)s]")
    parser.add_argument("--method", choices=(*METHODS, "both"), default="both", help="[%(default)s]")
    parser.add_argument("--family", choices=ALL, action="append", default=[], metavar="F",
                        help=f"only this one; may be repeated: {', '.join(FAMILIES)}; "
                        + "; ".join(f"{driver}: {', '.join(names)}" for driver, names in DRIVERS.items()))
    parser.add_argument("--json", metavar="F", type=view.writable, help="write the table and every outcome")
    parser.add_argument("--report", metavar="DIR", type=Path,
                        help="write a page with the table, histograms and our collisions")
    parser.add_argument("--replay", metavar="FAMILY:SEED", type=_scenario, help="one drive, told moment by moment")
    parser.add_argument("--strays", metavar="SHARE", type=_share,
                        help="with --replay: of the pixels too near for the camera, which return any depth, in place of the share drawn")
    parser.add_argument("--video", metavar="F.gif", type=_film, help="with --replay: what the robot saw and where it went")
    view.add_to(parser)
    parser.add_argument("--scheduler", metavar="ADDRESS", help="drive on the workers of this Dask scheduler")
    given = parser.parse_args(arguments)
    for name in OF_MANY:
        if getattr(given, name) != parser.get_default(name) and given.replay:
            parser.error(f"--{name} does not go with --replay")
    if given.report:
        view.make(given.report, parser)
    for name in ("strays", "video", "rrd", "view"):
        if getattr(given, name) != parser.get_default(name) and not given.replay:
            parser.error(f"--{name} goes with --replay")
        if getattr(given, name) != parser.get_default(name) and given.driver:
            parser.error(f"--{name} does not go with --driver")
    families = DRIVERS[given.driver] if given.driver else FAMILIES
    for family in [*given.family, *([given.replay[0]] if given.replay else [])]:
        if family not in families:
            parser.error(f"{family} does not go with {'--driver ' + given.driver if given.driver else 'no --driver'}: "
                         f"the families are {', '.join(families)}")
    return given


def _film(text: str) -> Path:
    if Path(text).suffix != FILM:
        raise argparse.ArgumentTypeError(f"{text!r} does not end in {FILM}")
    return view.writable(text)


def _share(text: str) -> float:
    number = float(text)
    if not 0.0 <= number <= 1.0:
        raise argparse.ArgumentTypeError(f"{text} is not within 0 and 1")
    return number


def _scenario(text: str) -> tuple[str, int]:
    family, _, seed = text.partition(":")
    if family not in ALL or not seed.isdigit():
        raise argparse.ArgumentTypeError(f"{text!r} is not FAMILY:SEED; the families are {', '.join(ALL)}")
    return family, int(seed)
