# SPDX-License-Identifier: BSD-3-Clause
"""What the judge says of a bag, for tests."""
from __future__ import annotations

import io
from pathlib import Path
from typing import Any, Dict, List, Mapping, Sequence

import pyarrow.parquet as pq

from safety_control_cloud.judge.bag import Job, Judged, judge_bag


def judged(bag: Path, settings: Mapping[str, Any] = {}, topics: Sequence[str] = ()) -> Judged:
    answer = judge_bag(Job(str(bag), (settings,), tuple(topics)))
    assert answer.error is None
    return answer


def rows_in(content: bytes) -> List[Dict[str, Any]]:
    """Times in [ns]."""
    with pq.ParquetFile(io.BytesIO(content), pre_buffer=False) as file:
        table = file.read(use_threads=False)  # pyarrow 21 may abort at exit if its threads have read a Python file
    rows = table.drop_columns(["time", "stamp"]).to_pylist()
    for name in ("time", "stamp"):
        for row, value in zip(rows, table.column(name).cast("int64").to_pylist()):
            row[name] = value
    return rows


def rows_of(bag: Path, settings: Mapping[str, Any] = {}, topics: Sequence[str] = ()) -> List[Dict[str, Any]]:
    answer = judged(bag, settings, topics)
    assert answer.rows[0].status == "judged", answer.rows[0].error
    return rows_in(answer.files[0])
