# SPDX-License-Identifier: BSD-3-Clause
"""What is shown of one cloud. Frame: the camera's optical one (x right, y down, z forward) [m], the guard's base_frame."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Optional, Tuple, Union

import numpy as np

from safety_control_cloud.pinhole import Pinhole

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04


@dataclass(frozen=True)
class Depth:
    """What a pinhole camera saw."""

    millimetres: NDArray[np.uint16]  # (height, width), 0: no return
    camera: Pinhole


@dataclass(frozen=True)
class Points:
    xyz: NDArray[np.float32]  # (N, 3), finite


Picture = Union[Depth, Points]
Motion = Tuple[float, float, float]  # forward, left [m/s], turning left [rad/s]


@dataclass(frozen=True)
class Guarded:
    """What somebody wants of the robot, and what the guard lets through."""

    wanted: Motion
    given: Motion


def nothing() -> NDArray[np.float32]:
    return np.empty((0, 3), np.float32)


@dataclass(frozen=True)
class Moment:
    """A cloud, and what was decided about it."""

    time: float  # [s] on the clock of the drive
    zone: str  # Safe, Warning or Danger
    cause: str
    reason: str
    nearest: Optional[float]  # [m]
    point: Optional[Tuple[float, float, float]]  # that decides; in the target_frame or base_frame if there is one
    speed: float  # [m/s] commanded
    driven: Optional[float] = None  # [m/s] over the floor, where that is known
    stamp: Optional[int] = None  # [ns] the cloud's own
    picture: Optional[Picture] = None
    guarded: Optional[Guarded] = None
    place: Optional[NDArray[np.float64]] = None  # (3, 4) of the camera in base_frame, [rotation | m]; in mode guard
    remembered: NDArray[np.float32] = field(default_factory=nothing)  # (N, 3) near, or lost from sight
