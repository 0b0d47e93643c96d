# SPDX-License-Identifier: BSD-3-Clause
"""What a drive up to an obstacle was like, and whether it went well."""
from __future__ import annotations

from dataclasses import dataclass, field
from itertools import groupby
from math import isfinite
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

STANDING = 0.001  # [m/s] below which the robot stands


@dataclass(frozen=True)
class Sample:
    """What the node said of one cloud, and what the robot did then."""

    time: float  # [s]
    zone: str  # Safe, Warning or Danger
    nearest: float  # [m] along z from the camera; inf: nothing there, NaN: the node could not look
    commanded: float  # [m/s] on /mobile_base/commands/velocity
    speed: float  # [m/s] over the floor

    @property
    def stands_before_something(self) -> bool:
        """Not so a robot that stands because its camera has not begun."""
        return self.zone == "Danger" and isfinite(self.nearest) and abs(self.speed) < STANDING


@dataclass(frozen=True)
class Approach:
    """One drive. `views` holds the camera's picture at the first sample of each zone, (height, width, 3)."""

    samples: tuple[Sample, ...]
    contacts: frozenset[str] = frozenset()  # what the robot touched
    views: dict[str, NDArray[np.uint8]] = field(default_factory=dict)

    @property
    def zones(self) -> tuple[str, ...]:
        """In the order in which they came."""
        return tuple(zone for zone, _ in groupby(sample.zone for sample in self.samples))

    @property
    def stood_at(self) -> float | None:
        """[m] from the camera to the obstacle where the robot came to stand in Danger; None if it did not."""
        last = self.samples[-1] if self.samples else None
        return last.nearest if last and last.stands_before_something else None

    @property
    def problem(self) -> str | None:
        """Why this drive did not go well, in words; None if it did."""
        if self.contacts:
            return "the robot touched " + ", ".join(sorted(self.contacts))
        if not self.samples:
            return "the node said nothing"
        if self.stood_at is None:
            last = self.samples[-1]
            return f"the robot did not come to stand in Danger: {last.zone} zone, {last.speed:.2f} m/s at the end"
        return None
