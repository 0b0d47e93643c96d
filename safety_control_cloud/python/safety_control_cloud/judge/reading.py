# SPDX-License-Identifier: BSD-3-Clause
"""One bag in mode drive, by one setting or more, in one reading."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional, Sequence

from safety_control_cloud import core
from safety_control_cloud.judge.choice import Choice
from safety_control_cloud.judge.drive import Drive, Verdict
from safety_control_cloud.judge.rows import CLOUDS, BagRow
from safety_control_cloud.judge.table import Key, RowFile
from safety_control_cloud.replay.bags import Bags, Topic, opened
from safety_control_cloud.replay.eyes import Sighting, eye_for
from safety_control_cloud.replay.places import Places
from safety_control_cloud.replay.topics import Source, chosen, transforms_in


class Sheet:
    """What one setting says of a bag."""

    def __init__(self, path: str, key: Key, given: Mapping[str, Any], folder: Path) -> None:
        self.settings, self._path = core.Settings(**given), folder / f"{key}.parquet"
        self._file = RowFile(self._path, key, CLOUDS)
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


def read(path: Path, choice: Choice, sheets: Sequence[Sheet]) -> None:
    """Raises BagError."""
    with opened([path]) as bags:
        sources: Dict[str, Source] = {}
        for sheet in sheets:
            its = chosen(bags, choice.topics, sheet.settings.input)
            sheet.look_at(its)
            sources.update({source.name: source for source in its})
        _see_all(bags, list(sources.values()), sheets)
        for sheet in sheets:
            sheet.end(bags.end)


def _see_all(bags: Bags, sources: Sequence[Source], sheets: Sequence[Sheet]) -> None:
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
            with bags.understanding(message):
                sighting = eyes[source.name].sighting_of(message)
            for sheet in sheets if sighting else ():
                sheet.see(source.name, sighting, places)
        if places and message.topic not in names:
            with bags.understanding(message):
                places.add(message)
