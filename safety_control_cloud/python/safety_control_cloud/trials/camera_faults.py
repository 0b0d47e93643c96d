# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong between the world and the node. Each is a value; `None` or 0 stands for a camera without it."""
from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

Depth = "NDArray[np.float32]"


@dataclass(frozen=True)
class Spell:
    start: float  # [s]
    seconds: float

    def holds(self, time: float) -> bool:
        return self.start <= time < self.end

    @property
    def end(self) -> float:
        """[s]"""
        return self.start + self.seconds


@dataclass(frozen=True)
class CameraFaults:
    """Of one episode."""

    dropouts: tuple[Spell, ...] = ()  # no cloud comes
    frozen: Spell | None = None  # the last picture comes again and again, with new stamps
    lateness: tuple[float, float] = (0.0, 0.0)  # [s] least and most that a cloud comes later than it should
    skew: float = 0.0  # [s] by which the camera's stamps are ahead of ROS time
    skewed_from: float = 0.0  # [s]
    speckle: float = 0.0  # share of the pixels that return any depth
    flying: float = 0.0  # share of the pixels at edges that return a depth between the two
    bumps: tuple[tuple[float, float], ...] = ()  # time [s] and height [rad]: pitch by a bump of the floor, nose down

    @property
    def over_at(self) -> float:
        """[s] when the last fault ends; a wrong clock stays wrong."""
        if self.skew:
            return inf
        spells = [*self.dropouts, *([self.frozen] if self.frozen else [])]
        return max((spell.end for spell in spells), default=0.0)

    def pitch(self, time: float) -> float:
        """[rad] nose down, beside the robot's own rocking. A bump lasts about 0.3 s."""
        return sum(height * float(np.exp(-(((time - at) / 0.1) ** 2))) for at, height in self.bumps)

    def marred(self, depth: Depth, random: np.random.Generator) -> Depth:
        """The picture with flying pixels and speckle."""
        if self.flying:
            depth = _with_flying_pixels(depth, self.flying, random)
        return _with_speckle(depth, self.speckle, random) if self.speckle else depth


def _with_speckle(depth: Depth, share: float, random: np.random.Generator) -> Depth:
    """Somewhere in the Xtion's range, evenly."""
    marred = depth.copy()
    hit = random.random(depth.shape, dtype=np.float32) < share
    marred[hit] = random.uniform(0.4, 5.0, int(hit.sum())).astype(np.float32)
    return marred


def _with_flying_pixels(depth: Depth, share: float, random: np.random.Generator) -> Depth:
    """Where a pixel's right neighbour is farther by a tenth, the pixel may show anything in between."""
    marred = depth.copy()
    near, far = np.minimum(depth[:, :-1], depth[:, 1:]), np.maximum(depth[:, :-1], depth[:, 1:])
    edge = (far > 1.1 * near) & (random.random(near.shape, dtype=np.float32) < share)
    blend = random.random(near.shape, dtype=np.float32)
    marred[:, :-1][edge] = (near + (far - near) * blend)[edge]
    return marred
