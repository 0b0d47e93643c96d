# SPDX-License-Identifier: BSD-3-Clause
"""What became of one sensor's pictures: whether the bag tells where it is, and by which clock it stamps."""
from __future__ import annotations

import math
from typing import Iterator, List, Optional

from safety_control_cloud import core
from safety_control_cloud.replay.eyes import Sighting
from safety_control_cloud.replay.places import Place
from safety_control_cloud.replay.topics import Source

JUMP = 1.0  # [s] by which a stamp may lag more or less than the one before
TOLD = 20  # jumps at most


class Seen:
    def __init__(self, source: Source, settings: core.Settings, number: int) -> None:
        own = settings.sensors[number] if settings.sensors else {}
        self.is_required = own.get("required", True)
        self._topic, self._base = source.name, settings.base_frame
        self._tolerance = own.get("stamp_tolerance", settings.stamp_tolerance)  # [s]
        self._pictures = self._placed = 0
        self._unplaced = ""
        self._lag: Optional[float] = None  # [s] of the latest stamp behind the bag's time
        self._least = math.inf  # [s] that a stamp was off
        self._jumps: List[str] = []
        self._untold = 0

    def note(self, sighting: Sighting, place: Place, since_start: float) -> None:
        self._pictures += 1
        if isinstance(place, str):
            self._unplaced = f"from {sighting.header.frame} ({self._topic}) to {self._base}, ~base_frame: {place}"
        else:
            self._placed += 1
        lag = (sighting.time - sighting.header.stamp) / 1e9
        if self._lag is not None and abs(lag - self._lag) > JUMP:
            self._note_jump(self._lag - lag, since_start)
        self._lag, self._least = lag, min(self._least, abs(lag))

    @property
    def jumps(self) -> List[str]:
        more = [f"the stamps of {self._topic} jump {self._untold} times more"] if self._untold else []
        return [*self._jumps, *more]

    def _note_jump(self, by: float, since_start: float) -> None:
        if len(self._jumps) == TOLD:
            self._untold += 1
            return
        self._jumps.append(f"the stamps of {self._topic} jump by {by:+.3f} s against the bag's time at {since_start:.3f} s")

    def problems(self) -> Iterator[str]:
        """Why nothing of it can be believed."""
        if not self._pictures:
            yield f"no image of {self._topic} has a CameraInfo with its stamp"
        elif not self._placed:
            yield f"no transform in the bag leads {self._unplaced}"
        elif self._lag is not None and 0.0 < self._tolerance < self._least:
            behind = f"{self._least:.3f} s {'behind' if self._lag > 0.0 else 'ahead of'}"
            yield (f"the stamps of {self._topic} are of another clock, {behind} the bag's time or more: "
                   "--param stamp_tolerance=0 takes what comes as fresh")
