# SPDX-License-Identifier: BSD-3-Clause
"""Rows as Parquet: a file for each bag and setting, and in its footer the row of the bag."""
from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Type

import pyarrow as pa
import pyarrow.parquet as pq

BATCH = 4096  # rows that wait for being written
BAG_ROW = b"bag"  # the footer's key
WORD = pa.dictionary(pa.int32(), pa.string())
TIME = pa.timestamp("ns")
COUNTS = pa.map_(pa.string(), pa.int64())
KEY = [("bag", WORD), ("settings", WORD), ("version", WORD)]  # how each row begins
BAG = [("path", pa.string()), ("bag", pa.string()), ("settings", pa.string()), ("version", pa.string()),
       ("status", pa.string()), ("error", pa.string()), ("topics", pa.list_(pa.string())), ("start", TIME), ("end", TIME)]


@dataclass(frozen=True)
class Key:
    """What has been judged: not judged again."""

    bag: str  # hash of its content
    settings: str  # hash of the settings
    version: str  # of what judges

    def __str__(self) -> str:
        return f"{self.bag}-{self.settings}-{self.version}"


@dataclass
class AnyBag:
    """What is told of a bag in either mode."""

    path: str
    bag: Optional[str]  # None: its content could not even be read
    settings: str
    version: str
    status: str = "judged"  # or error
    error: Optional[str] = None
    topics: List[str] = field(default_factory=list)
    start: Optional[int] = None  # [ns] of the bag
    end: Optional[int] = None

    @property
    def rows(self) -> int:
        """In the file whose footer this is."""
        raise NotImplementedError


@dataclass(frozen=True)
class Mode:
    """What of the node's modes is written where."""

    name: str
    place: str  # the folder below OUT that has `folder` and bags.parquet
    folder: str  # of the rows
    rows: str  # what one of them is, to people
    bag: Type[AnyBag]
    bags: pa.Schema


class RowFile:
    """Takes rows, a batch in memory at most. Closed, it is a Parquet file with the bag's row in the footer."""

    def __init__(self, path: Path, key: Key, schema: pa.Schema) -> None:
        self._key, self._schema, self._waiting = tuple(asdict(key).values()), schema, []  # type: Tuple[str, ...], Any, List[Sequence]
        self._writer = pq.ParquetWriter(path, schema, compression="zstd")

    def add(self, row: Sequence[Any]) -> None:
        """What comes after the KEY."""
        self._waiting.append(row)
        if len(self._waiting) == BATCH:
            self._write()

    def close(self, bag: AnyBag) -> None:
        self._write()
        self._writer.add_key_value_metadata({BAG_ROW: json.dumps(asdict(bag))})
        self._writer.close()

    def _write(self) -> None:
        columns = list(zip(*self._waiting)) or [()] * (len(self._schema) - len(KEY))
        same = [[word] * len(self._waiting) for word in self._key]
        arrays = [pa.array(list(values), kind.type) for values, kind in zip([*same, *columns], self._schema)]
        self._writer.write_table(pa.Table.from_arrays(arrays, schema=self._schema))
        self._waiting.clear()


def bag_row_in(path: Path, kind: Type[AnyBag]) -> AnyBag:
    """Of a closed RowFile."""
    footer = pq.read_metadata(path).metadata
    return kind(**json.loads(footer[BAG_ROW]))


def rows_in(path: Path, columns: Sequence[str]) -> Iterator[Dict[str, Any]]:
    """A batch in memory at a time; times in [ns]."""
    with pq.ParquetFile(path, pre_buffer=False) as file:
        for batch in file.iter_batches(columns=list(columns), use_threads=False):
            there = [batch.column(name) for name in columns]
            numbers = [one.cast("int64") if pa.types.is_timestamp(one.type) else one for one in there]
            for values in zip(*(column.to_pylist() for column in numbers)):
                yield dict(zip(columns, values))


def write_bags(rows: Sequence[AnyBag], path: Path, schema: pa.Schema) -> None:
    objects = []
    for row in rows:
        whole = asdict(row)
        counts = {name: sorted(value.items()) for name, value in whole.items() if isinstance(value, dict)}
        objects.append({**whole, **counts})
    pq.write_table(pa.Table.from_pylist(objects, schema=schema), path, compression="zstd")
