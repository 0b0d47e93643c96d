# SPDX-License-Identifier: BSD-3-Clause
"""One bag judged by one or more settings, in one reading."""
from __future__ import annotations

import errno
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterator, List, Mapping, Optional, Sequence, Tuple

from safety_control_cloud import core
from safety_control_cloud.judge.drive import Drive, Verdict
from safety_control_cloud.judge.find import path_of
from safety_control_cloud.judge.identity import Stat, hash_of_bag, hash_of_settings, stat_of, version
from safety_control_cloud.judge.memory import keep_freed_memory
from safety_control_cloud.judge.rows import BagRow, CloudFile, Key
from safety_control_cloud.replay.bags import BagError, Bags, Topic, opened
from safety_control_cloud.replay.eyes import Sighting, eye_for
from safety_control_cloud.replay.places import Places
from safety_control_cloud.replay.topics import Source, chosen, transforms_in


@dataclass(frozen=True)
class Job:
    """What a worker is asked for."""

    path: str  # of a bag, as the worker can open it
    settings: Tuple[Mapping[str, object], ...]  # what differs from the defaults
    topics: Tuple[str, ...] = ()  # empty: those that the node would look at
    known: Optional[Tuple[Stat, str]] = None  # what the bag was when it was hashed, and its hash
    have: Tuple[str, ...] = ()  # the settings' hashes by which that content has been judged
    store: str = ""  # the folder of what has been judged, if the worker can see it


@dataclass(frozen=True)
class Judged:
    """What the worker answers."""

    path: str
    stat: Optional[Stat] = None
    bag: Optional[str] = None  # None: it could not be opened
    rows: Tuple[BagRow, ...] = ()  # of the settings that have been judged now
    files: Tuple[bytes, ...] = ()  # the CloudFile of each
    error: Optional[str] = None  # why it could not be read, which may be another time


def judge_bag(job: Job) -> Judged:
    """Raises nothing because of a bag: what is wrong with one stands in the answer."""
    keep_freed_memory()
    path = path_of(job.path)
    try:
        stat = stat_of(path)
        bag = job.known[1] if job.known and job.known[0] == stat else hash_of_bag(path)
    except Exception as error:  # of the disk, the network or the store
        return Judged(job.path, error=f"cannot open {job.path}: {error}")
    with tempfile.TemporaryDirectory(prefix="judge_") as folder:
        sheets = [_Sheet(job.path, key, settings, Path(folder)) for key, settings in _missing(job, bag)]
        try:
            if sheets:
                _judge(path, job.topics, sheets)
        except BagError as error:
            if _may_pass(error.__cause__):
                return Judged(job.path, error=str(error))
            for sheet in sheets:
                sheet.row.status, sheet.row.error = "error", str(error)
        files = tuple(sheet.close() for sheet in sheets)
        return Judged(job.path, stat, bag, tuple(sheet.row for sheet in sheets), files)


def _missing(job: Job, bag: str) -> Iterator[Tuple[Key, core.Settings]]:
    """By which the bag has not been judged."""
    same = job.known is not None and job.known[1] == bag
    for given in job.settings:
        settings = core.Settings(**dict(given))
        key = Key(bag, hash_of_settings(settings, job.topics), version())
        if not (same and key.settings in job.have or job.store and (Path(job.store) / f"{key}.parquet").exists()):
            yield key, settings


def _may_pass(cause: Optional[BaseException]) -> bool:
    """Whether it was not the bag's content: a disk or a network may be back the next time."""
    return isinstance(cause, OSError) and cause.errno not in (None, errno.EINVAL)


class _Sheet:
    """What one setting says of a bag."""

    def __init__(self, path: str, key: Key, settings: core.Settings, folder: Path) -> None:
        self.settings, self._path = settings, folder / f"{key}.parquet"
        self._file = CloudFile(self._path, key)
        self.row = BagRow(path, key.bag, key.settings, key.version)
        self._drives: Dict[str, Drive] = {}

    def look_at(self, sources: Sequence[Source]) -> None:
        self._drives = {source.name: Drive(source.topic.name, self.settings) for source in sources}
        self.row.topics = [source.topic.name for source in sources]

    def see(self, name: str, sighting: Sighting, places: Optional[Places]) -> None:
        drive = self._drives.get(name)
        if not drive:
            return
        frame = self.settings.target_frame
        place = places.at(frame, sighting.header) if places and frame else None
        if self.row.start is None:
            self.row.start = sighting.time
        for verdict in drive.see(sighting, place):
            self._add(verdict)

    def end(self, time: int) -> None:
        self.row.end = time
        for drive in self._drives.values():
            for verdict in drive.wait(time):
                self._add(verdict)

    def close(self) -> bytes:
        self._file.close(self.row)
        return self._path.read_bytes()

    def _add(self, verdict: Verdict) -> None:
        self._file.add(verdict)
        self.row.count(verdict)


def _judge(path: Path, names: Sequence[str], sheets: List[_Sheet]) -> None:
    with opened([path]) as bags:
        sources: Dict[str, Source] = {}
        for sheet in sheets:
            its = chosen(bags, names, sheet.settings.input)
            sheet.look_at(its)
            sources.update({source.name: source for source in its})
        _see_all(bags, list(sources.values()), sheets)
        for sheet in sheets:
            sheet.end(bags.end)


def _see_all(bags: Bags, sources: Sequence[Source], sheets: Sequence[_Sheet]) -> None:
    eyes = {source.name: eye_for(bags, source) for source in sources}
    by_topic: Dict[Topic, List[Source]] = {}
    for source in sources:
        for topic in source.topics:
            by_topic.setdefault(topic, []).append(source)
    places = Places(bags) if any(sheet.settings.target_frame for sheet in sheets) else None
    moving = transforms_in(bags) if places else []
    names = {topic.name: its for topic, its in by_topic.items()}
    for message in bags.messages([*by_topic, *moving]):
        for source in names.get(message.topic, ()):
            sighting = eyes[source.name].sighting_of(message)
            for sheet in sheets if sighting else ():
                sheet.see(source.name, sighting, places)
        if places and message.topic not in names:
            places.add(message)
