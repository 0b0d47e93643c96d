# SPDX-License-Identifier: BSD-3-Clause
"""What is written in mode drive: verdicts, and a row for each bag."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Dict, Optional

import pyarrow as pa

from safety_control_cloud.judge.drive import Verdict
from safety_control_cloud.judge.table import BAG, COUNTS, KEY, TIME, WORD, AnyBag, Mode

CLOUDS = pa.schema([
    *KEY, ("topic", WORD), ("number", pa.int64()), ("time", TIME),
    ("stamp", TIME), ("zone", WORD), ("cause", WORD), ("reason", pa.string()), ("nearest", pa.float64()),
    ("x", pa.float64()), ("y", pa.float64()), ("z", pa.float64()), ("speed", pa.float64()), ("inside", pa.int64()),
    ("returns", pa.int64()), ("total", pa.int64())])
BAGS = pa.schema([
    *BAG, ("clouds", pa.int64()), ("silences", pa.int64()), ("zones", COUNTS), ("causes", COUNTS), ("nearest", pa.float64())])


@dataclass
class BagRow(AnyBag):
    """What was met in a bag. A cloud counts in `zones` and `causes`, and so does a silence."""

    clouds: int = 0
    silences: int = 0
    zones: Dict[str, int] = field(default_factory=dict)
    causes: Dict[str, int] = field(default_factory=dict)
    nearest: Optional[float] = None  # [m] the least of all

    @property
    def rows(self) -> int:
        return self.clouds

    def count(self, verdict: Verdict) -> None:
        if verdict.stamp is None:
            self.silences += 1
        else:
            self.clouds += 1
        self.zones[verdict.zone] = self.zones.get(verdict.zone, 0) + 1
        self.causes[verdict.cause] = self.causes.get(verdict.cause, 0) + 1
        if verdict.nearest is not None and (self.nearest is None or verdict.nearest < self.nearest):
            self.nearest = verdict.nearest


DRIVE = Mode("drive", "", "clouds", "clouds", BagRow, BAGS)
