# SPDX-License-Identifier: BSD-3-Clause
"""What another setting would have changed: the clouds of the same bags that two settings decide differently."""
from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Sequence, Tuple

import pyarrow.parquet as pq

from safety_control_cloud.judge.replay_line import replay_line
from safety_control_cloud.judge.rows import BagRow
from safety_control_cloud.judge.store import Store

SAID = ("zone", "cause", "speed")
DECIDED = (*SAID, "nearest")
COLUMNS = ("topic", "number", "stamp", "time", *DECIDED)


@dataclass(frozen=True)
class Difference:
    """A stretch of clouds, or a silence, of which the two say something else; None where one says nothing."""

    path: str
    topic: str
    number: int  # of the first
    time: int  # [ns] of the bag
    before: Optional[Dict[str, object]]
    after: Optional[Dict[str, object]]
    length: int = 1  # clouds

    @property
    def size(self) -> Tuple[float, bool]:
        """What changes the robot's speed most comes first."""
        speeds = [one["speed"] if one else 0.0 for one in (self.before, self.after)]
        zones = [one and one["zone"] for one in (self.before, self.after)]
        return -abs(float(speeds[0]) - float(speeds[1])), zones[0] == zones[1]

    def command(self, given: argparse.Namespace) -> str:
        """What shows it by the second settings."""
        return replay_line(self.path, given, 1, "--topic", self.topic, "--around", str(self.number))


def differences(store: Store, rows: Sequence[BagRow], before: str, after: str) -> List[Difference]:
    """Between the verdicts by two settings (their hashes), the largest first."""
    bags = {row.path: row.bag for row in rows if row.bag}
    found: List[Difference] = []
    for path, bag in sorted(bags.items()):
        found += _stretches(_of(path, store.file_of(bag, before), store.file_of(bag, after)))
    return sorted(found, key=lambda one: (*one.size, one.path, one.topic, one.time))


def _stretches(found: Iterator[Difference]) -> List[Difference]:
    """Successive clouds of which the same is said are one."""
    joined: List[Difference] = []
    for one in found:
        last = joined[-1] if joined else None
        if last and one.topic == last.topic and one.number == last.number + last.length and _said(one) == _said(last):
            joined[-1] = replace(last, length=last.length + 1)
        else:
            joined.append(one)
    return joined


def _said(one: Difference) -> list:
    return [verdict and [verdict[name] for name in SAID] for verdict in (one.before, one.after)]


def _of(path: str, *files: Path) -> Iterator[Difference]:
    before, after = (_verdicts(file) for file in files)
    for key in sorted(set(before) | set(after)):
        one, other = before.get(key), after.get(key)
        if not (one and other and all(one[name] == other[name] for name in SAID)):
            topic, number, _ = key
            yield Difference(path, topic, number, (one or other or {})["time"], one, other)


def _verdicts(file: Path) -> Dict[Tuple[str, int, bool], Dict[str, object]]:
    """By topic, number and whether it is a silence."""
    with pq.ParquetFile(file, pre_buffer=False) as opened:
        table = opened.read(list(COLUMNS), use_threads=False)
    columns = {name: table.column(name) for name in COLUMNS}
    times = columns["time"].cast("int64").to_pylist()
    silent = columns["stamp"].is_null().to_pylist()
    keys = zip(columns["topic"].to_pylist(), columns["number"].to_pylist(), silent)
    decided = zip(*(columns[name].to_pylist() for name in DECIDED))
    return {key: {"time": time, **dict(zip(DECIDED, values))} for key, time, values in zip(keys, times, decided)}
