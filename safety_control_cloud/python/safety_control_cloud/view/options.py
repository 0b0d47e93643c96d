# SPDX-License-Identifier: BSD-3-Clause
"""--rrd and --view, as replay, demo and trials have them; needs Python alone."""
from __future__ import annotations

import argparse
import os
import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import Iterator, Optional

ENDING = ".rrd"


def add_to(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rrd", metavar="F.rrd", type=recording_file, help="write a recording for the Rerun viewer")
    parser.add_argument("--view", action="store_true",
                        help="and open it: in a window, or for a browser where there is no screen")


def recording_file(text: str) -> Path:
    if Path(text).suffix != ENDING:
        raise argparse.ArgumentTypeError(f"{text!r} does not end in {ENDING}")
    return writable(text)


def writable(text: str) -> Path:
    """A file that can be written; it is tried, and left as it was."""
    path = Path(text)
    was_there = path.exists()
    try:
        path.open("ab").close()
    except OSError as error:
        raise argparse.ArgumentTypeError(f"cannot write {text}: {error.strerror}") from error
    if not was_there:
        path.unlink()
    return path


def make(folder: Path, parser: argparse.ArgumentParser) -> None:
    """One that can be written to. Not while arguments are read: --help makes nothing."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        parser.error(f"cannot write {folder}: {error.strerror}")
    if not os.access(folder, os.W_OK | os.X_OK):
        parser.error(f"cannot write {folder}")


@contextmanager
def recorded_in(rrd: Optional[Path], view: bool) -> Iterator[Optional[Path]]:
    """The file to record in, if one is wanted; at the end of the block it is opened, if that is.

    Raises optional.MissingPackages.
    """
    if not rrd and not view:
        yield None
        return
    from safety_control_cloud.optional import require

    require("view")
    with tempfile.TemporaryDirectory(prefix="view_") as folder:
        file = rrd or Path(folder) / f"drive{ENDING}"
        yield file
        if view:
            from safety_control_cloud.view.open import look_at

            look_at(file)
