# SPDX-License-Identifier: BSD-3-Clause
"""What the judge says of a bag, for tests."""
from __future__ import annotations

import io
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List, Mapping, Sequence

import pyarrow as pa
import pyarrow.parquet as pq

from safety_control_cloud.judge.bag import Job, Judged, judge_bag
from safety_control_cloud.judge.choice import Choice

COMMAND = [sys.executable, "-m", "safety_control_cloud.judge"]


def judge(*arguments: Any, code: int = 0) -> subprocess.CompletedProcess:
    result = subprocess.run([*COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    assert result.returncode == code, result.stdout + result.stderr
    return result


def judged(bag: Path, settings: Mapping[str, Any] = {}, topics: Sequence[str] = (), **others: str) -> Judged:
    answer = judge_bag(Job(str(bag), (settings,), Choice(tuple(topics), **others)))
    assert answer.error is None
    return answer


def rows_in(content: bytes) -> List[Dict[str, Any]]:
    """Times in [ns]."""
    with pq.ParquetFile(io.BytesIO(content), pre_buffer=False) as file:
        table = file.read(use_threads=False)  # pyarrow 21 may abort at exit if its threads have read a Python file
    times = [field.name for field in table.schema if pa.types.is_timestamp(field.type)]
    rows = table.drop_columns(times).to_pylist()
    for name in times:
        for row, value in zip(rows, table.column(name).cast("int64").to_pylist()):
            row[name] = value
    return rows


def rows_of(bag: Path, settings: Mapping[str, Any] = {}, topics: Sequence[str] = ()) -> List[Dict[str, Any]]:
    answer = judged(bag, settings, topics)
    assert answer.rows[0].status == "judged", answer.rows[0].error
    return rows_in(answer.files[0])
