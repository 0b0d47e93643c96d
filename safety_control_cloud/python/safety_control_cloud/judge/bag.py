# SPDX-License-Identifier: BSD-3-Clause
"""One bag judged by one or more settings of one mode, in one reading."""
from __future__ import annotations

import errno
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple

from safety_control_cloud.judge.choice import Choice
from safety_control_cloud.judge.find import path_of
from safety_control_cloud.judge.guard.reading import GuardSheet, read_as_guards
from safety_control_cloud.judge.guard.rows import GUARD
from safety_control_cloud.judge.identity import Stat, hash_of_bag, hash_of_settings, stat_of, version
from safety_control_cloud.judge.memory import keep_freed_memory
from safety_control_cloud.judge.reading import Sheet, read
from safety_control_cloud.judge.rows import DRIVE
from safety_control_cloud.judge.table import AnyBag, Key, Mode
from safety_control_cloud.replay.bags import BagError

SHEETS = {DRIVE.name: Sheet, GUARD.name: GuardSheet}
READERS = {DRIVE.name: read, GUARD.name: read_as_guards}


@dataclass(frozen=True)
class Job:
    """What a worker is asked for."""

    path: str  # of a bag, as the worker can open it
    settings: Tuple[Mapping[str, object], ...]  # what differs from the defaults
    choice: Choice = Choice()
    known: Optional[Tuple[Stat, str]] = None  # what the bag was when it was hashed, and its hash
    have: Tuple[str, ...] = ()  # the settings' hashes by which that content has been judged
    store: str = ""  # the folder of what has been judged, if the worker can see it


@dataclass(frozen=True)
class Judged:
    """What the worker answers."""

    path: str
    stat: Optional[Stat] = None
    bag: Optional[str] = None  # None: it could not be opened
    rows: Tuple[AnyBag, ...] = ()  # of the settings that have been judged now
    files: Tuple[bytes, ...] = ()  # the RowFile of each
    error: Optional[str] = None  # why it could not be read, which may be another time


def mode_of(settings: Sequence[Mapping[str, Any]]) -> Mode:
    """All are of one."""
    return GUARD if any(one.get("mode") == GUARD.name for one in settings) else DRIVE


def judge_bag(job: Job) -> Judged:
    """Raises nothing because of a bag: what is wrong with one stands in the answer."""
    keep_freed_memory()
    path, mode = path_of(job.path), mode_of(job.settings).name
    try:
        stat = stat_of(path)
        bag = job.known[1] if job.known and job.known[0] == stat else hash_of_bag(path)
    except Exception as error:  # of the disk, the network or the store
        return Judged(job.path, error=f"cannot open {job.path}: {error}")
    with tempfile.TemporaryDirectory(prefix="judge_") as folder:
        sheets: Any = [SHEETS[mode](job.path, key, given, Path(folder)) for key, given in _missing(job, bag).items()]
        try:
            if sheets:
                READERS[mode](path, job.choice, sheets)
        except BagError as error:
            if _may_pass(error.__cause__):
                return Judged(job.path, error=str(error))
            for sheet in sheets:
                sheet.row.status, sheet.row.error = "error", sheet.row.error or str(error)
        files = tuple(sheet.close() for sheet in sheets)
        return Judged(job.path, stat, bag, tuple(sheet.row for sheet in sheets), files)


def _missing(job: Job, bag: str) -> Dict[Key, Mapping[str, object]]:
    """By which the bag has not been judged."""
    same = job.known is not None and job.known[1] == bag
    keys = {Key(bag, hash_of_settings(given, job.choice), version()): given for given in job.settings}
    return {key: given for key, given in keys.items()
            if not (same and key.settings in job.have or job.store and (Path(job.store) / f"{key}.parquet").exists())}


def _may_pass(cause: Optional[BaseException]) -> bool:
    """Whether it was not the bag's content: a disk or a network may be back the next time."""
    return isinstance(cause, OSError) and cause.errno not in (None, errno.EINVAL)
