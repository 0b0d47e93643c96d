# SPDX-License-Identifier: BSD-3-Clause
"""What the page shows, gathered from the store a batch at a time."""
from __future__ import annotations

from dataclasses import dataclass, field
from heapq import nsmallest
from typing import Any, Dict, List, Sequence, Tuple

from safety_control_cloud.judge.rows import BagRow
from safety_control_cloud.judge.store import Store
from safety_control_cloud.judge.table import rows_in

BIN = 0.1  # [m] of the histogram
FARTHEST = 5.0  # [m] what is farther is in the last bin
NEAREST_CALLS = 10
APART = 1_000_000_000  # [ns] two calls of a bag are not the same approach
COLUMNS = ("topic", "number", "time", "stamp", "zone", "cause", "reason", "nearest", "speed", "x", "y", "z")


@dataclass(frozen=True)
class Call:
    """A cloud in which something was near."""

    path: str
    row: Dict[str, Any]  # times in [ns]


@dataclass
class Facts:
    histogram: Dict[str, List[int]] = field(default_factory=dict)  # clouds by zone, a figure for each bin
    stretches: Dict[str, List[Tuple[int, str]]] = field(default_factory=dict)  # by path: from when on [ns] which zone
    calls: List[Call] = field(default_factory=list)  # the nearest first


def facts_of(store: Store, rows: Sequence[BagRow], settings: str) -> Facts:
    facts = Facts({zone: [0] * (round(FARTHEST / BIN) + 1) for zone in ("Safe", "Warning", "Danger")})
    calls: List[Call] = []
    for row in rows:
        if row.settings != settings or not row.bag:
            continue
        stretches: List[Tuple[int, str]] = []
        of_bag: List[Call] = []
        for verdict in rows_in(store.file_of(row.bag, settings), COLUMNS):
            _add(facts.histogram, verdict)
            if not stretches or stretches[-1][1] != verdict["zone"]:
                stretches.append((verdict["time"], verdict["zone"]))
            _note(of_bag, Call(row.path, verdict))
        facts.stretches[row.path] = stretches
        calls = nsmallest(NEAREST_CALLS, [*calls, *of_bag], key=lambda call: (call.row["nearest"], call.path))
    facts.calls = calls
    return facts


def _add(histogram: Dict[str, List[int]], verdict: Dict[str, Any]) -> None:
    if verdict["nearest"] is not None:
        place = min(int(max(verdict["nearest"], 0.0) / BIN), round(FARTHEST / BIN))
        histogram[verdict["zone"]][place] += 1


def _note(calls: List[Call], call: Call) -> None:
    """Keeps the nearest of each approach, and of all of a bag's those ten."""
    if call.row["nearest"] is None or call.row["stamp"] is None:
        return
    last = calls[-1] if calls else None
    if last and last.row["topic"] == call.row["topic"] and call.row["time"] - last.row["time"] < APART:
        if call.row["nearest"] >= last.row["nearest"]:
            return
        calls.pop()
    calls.append(call)
    if len(calls) > 50 * NEAREST_CALLS:
        calls[:] = [*nsmallest(NEAREST_CALLS, calls[:-1], key=lambda one: one.row["nearest"]), calls[-1]]
