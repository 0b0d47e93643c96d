# SPDX-License-Identifier: BSD-3-Clause
"""Verdicts as Parquet: a file for each bag and setting, and in its footer the row of the bag."""
from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Dict, List, Optional

import pyarrow as pa
import pyarrow.parquet as pq

from safety_control_cloud.judge.drive import Verdict

BATCH = 4096  # rows that wait for being written
BAG_ROW = b"bag"  # the footer's key
WORD = pa.dictionary(pa.int32(), pa.string())
TIME = pa.timestamp("ns")
CLOUDS = pa.schema([
    ("bag", WORD), ("settings", WORD), ("version", WORD), ("topic", WORD), ("number", pa.int64()), ("time", TIME),
    ("stamp", TIME), ("zone", WORD), ("cause", WORD), ("reason", pa.string()), ("nearest", pa.float64()),
    ("x", pa.float64()), ("y", pa.float64()), ("z", pa.float64()), ("speed", pa.float64()), ("inside", pa.int64()),
    ("returns", pa.int64()), ("total", pa.int64())])
COUNTS = pa.map_(pa.string(), pa.int64())
BAGS = pa.schema([
    ("path", pa.string()), ("bag", pa.string()), ("settings", pa.string()), ("version", pa.string()),
    ("status", pa.string()), ("error", pa.string()), ("topics", pa.list_(pa.string())), ("start", TIME), ("end", TIME),
    ("clouds", pa.int64()), ("silences", pa.int64()), ("zones", COUNTS), ("causes", COUNTS), ("nearest", pa.float64())])


@dataclass(frozen=True)
class Key:
    """What has been judged: not judged again."""

    bag: str  # hash of its content
    settings: str  # hash of the settings
    version: str  # of what judges

    def __str__(self) -> str:
        return f"{self.bag}-{self.settings}-{self.version}"


@dataclass
class BagRow:
    """What was met in a bag. A cloud counts in `zones` and `causes`, and so does a silence."""

    path: str
    bag: Optional[str]  # None: its content could not even be read
    settings: str
    version: str
    status: str = "judged"  # or error
    error: Optional[str] = None
    topics: List[str] = field(default_factory=list)
    start: Optional[int] = None  # [ns] of the bag
    end: Optional[int] = None
    clouds: int = 0
    silences: int = 0
    zones: Dict[str, int] = field(default_factory=dict)
    causes: Dict[str, int] = field(default_factory=dict)
    nearest: Optional[float] = None  # [m] the least of all

    def count(self, verdict: Verdict) -> None:
        if verdict.stamp is None:
            self.silences += 1
        else:
            self.clouds += 1
        self.zones[verdict.zone] = self.zones.get(verdict.zone, 0) + 1
        self.causes[verdict.cause] = self.causes.get(verdict.cause, 0) + 1
        if verdict.nearest is not None and (self.nearest is None or verdict.nearest < self.nearest):
            self.nearest = verdict.nearest


class CloudFile:
    """Takes verdicts, a batch in memory at most. Closed, it is a Parquet file with its BagRow in the footer."""

    def __init__(self, path: Path, key: Key) -> None:
        self._key, self._waiting = key, []
        self._writer = pq.ParquetWriter(path, CLOUDS, compression="zstd")

    def add(self, verdict: Verdict) -> None:
        self._waiting.append(verdict)
        if len(self._waiting) == BATCH:
            self._write()

    def close(self, row: BagRow) -> None:
        self._write()
        self._writer.add_key_value_metadata({BAG_ROW: json.dumps(asdict(row))})
        self._writer.close()

    def _write(self) -> None:
        columns = list(zip(*self._waiting)) or [()] * len(Verdict._fields)
        same = [[word] * len(self._waiting) for word in asdict(self._key).values()]
        arrays = [pa.array(list(values), kind.type) for values, kind in zip([*same, *columns], CLOUDS)]
        self._writer.write_table(pa.Table.from_arrays(arrays, schema=CLOUDS))
        self._waiting.clear()


def bag_row_in(path: Path) -> BagRow:
    """Of a closed CloudFile."""
    footer = pq.read_metadata(path).metadata
    return BagRow(**json.loads(footer[BAG_ROW]))


def write_bags(rows: List[BagRow], path: Path) -> None:
    objects: List[Dict[str, Any]] = []
    for row in rows:
        counts = {name: sorted(getattr(row, name).items()) for name in ("zones", "causes")}
        objects.append({**asdict(row), **counts})
    pq.write_table(pa.Table.from_pylist(objects, schema=BAGS), path, compression="zstd")
