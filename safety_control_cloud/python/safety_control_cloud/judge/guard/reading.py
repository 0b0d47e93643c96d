# SPDX-License-Identifier: BSD-3-Clause
"""One bag past one guard or more, in one reading."""
from __future__ import annotations

from pathlib import Path
from typing import Any, List, Mapping, Optional, Sequence

from safety_control_cloud.judge.choice import Choice
from safety_control_cloud.judge.guard.rows import ANSWERS, GuardedBag, row_of
from safety_control_cloud.judge.table import Key, RowFile
from safety_control_cloud.replay.bags import BagError, Bags, Recorded, opened
from safety_control_cloud.replay.guard.counts import Counts
from safety_control_cloud.replay.guard.drive import Answer
from safety_control_cloud.replay.guard.inputs import Inputs, inputs_in
from safety_control_cloud.replay.guard.reading import Reading
from safety_control_cloud.replay.parameters import BadSettings


class GuardSheet:
    """What one guard says of a bag. What it cannot be given of the bag costs its own row alone."""

    def __init__(self, path: str, key: Key, given: Mapping[str, Any], folder: Path) -> None:
        self._given, self._path = given, folder / f"{key}.parquet"
        self._file = RowFile(self._path, key, ANSWERS)
        self.row = GuardedBag(path, key.bag, key.settings, key.version)
        self._counts = Counts()
        self._reading: Optional[Reading] = None
        self._wanted: set = set()  # topics and their types

    @property
    def topics(self) -> List[Any]:
        """What it still has to see."""
        return self._reading.topics if self._reading else []

    def look_at(self, bags: Bags, choice: Choice) -> None:
        try:
            inputs = inputs_in(bags, self._given, choice.topics, choice.cmd_vel, choice.odom)
            self._reading = Reading(bags, inputs, self._add)
        except (BagError, BadSettings) as error:
            return self._fail(error)
        self.row.topics = _topics_of(inputs)
        self._wanted = {(topic.name, topic.kind) for topic in self._reading.topics}

    def see(self, message: Recorded) -> None:
        if not self._reading or (message.topic, message.kind) not in self._wanted:
            return
        try:
            self._reading.take(message)
        except BagError as error:
            self._fail(error)

    def end(self, time: int) -> None:
        if not self._reading:
            return
        self.row.end = time
        try:
            self.row.warnings = self._reading.end()
        except BagError as error:
            self._fail(error)
        self._counts.end(time)

    def close(self) -> bytes:
        self.row.note(self._counts)
        self._file.close(self.row)
        return self._path.read_bytes()

    def _add(self, answer: Answer) -> None:
        if self.row.start is None:
            self.row.start = answer.time
        self._file.add(row_of(self._counts.answers, answer))
        self._counts.add(answer)

    def _fail(self, error: Exception) -> None:
        self.row.status, self.row.error, self._reading = "error", "; ".join(str(error).splitlines()), None


def read_as_guards(path: Path, choice: Choice, sheets: Sequence[GuardSheet]) -> None:
    """Raises BagError where the bag is damaged."""
    with opened([path]) as bags:
        for sheet in sheets:
            sheet.look_at(bags, choice)
        for message in bags.messages({topic: None for sheet in sheets for topic in sheet.topics}):
            for sheet in sheets:
                sheet.see(message)
            if not any(sheet.topics for sheet in sheets):
                return
        for sheet in sheets:
            sheet.end(bags.end)


def _topics_of(inputs: Inputs) -> List[str]:
    sensors = [source.topic.name for source in inputs.sensors]
    return list(dict.fromkeys([*(topic.name for topic in inputs.of_base), *sensors]))
