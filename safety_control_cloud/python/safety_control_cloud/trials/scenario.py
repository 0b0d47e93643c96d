# SPDX-License-Identifier: BSD-3-Clause
"""One drive, written down: what stands where, how the robot starts, what goes wrong."""
from __future__ import annotations

import zlib
from dataclasses import dataclass, field

import numpy as np

from ..simulation.base import Pose
from ..simulation.hull import Rectangle
from ..simulation.sensor import Xtion
from .camera_faults import CameraFaults, Spell
from .things import Thing

XTION = Xtion(width=320, height=240)  # half of VGA each way: a post of 2 cm is 5 pixels wide at 1 m, not 11


@dataclass(frozen=True)
class Turn:
    """Somebody turns the robot on the spot, by an input of higher priority."""

    spell: Spell
    rate: float  # [rad/s] about z, counter-clockwise


@dataclass(frozen=True)
class Scenario:
    """Frozen: the same family and seed draw the same one."""

    family: str
    seed: int
    things: tuple[Thing, ...]
    start: Pose = Pose()
    seconds: float = 16.0  # the longest that it may last
    transport: float = 0.05  # [s] from a picture to the cloud's arrival: one sensor period
    processing: float = 0.01  # [s] from there to the command's arrival at the multiplexer
    faults: CameraFaults = CameraFaults()
    stray: float = 0.0  # share of the pixels too near for the camera that return any depth
    turns: tuple[Turn, ...] = ()
    settings: tuple[tuple[str, float | str], ...] = ()  # of the node, other than its defaults
    hull: Rectangle | None = None  # in place of the TurtleBot's
    route: tuple[tuple[float, float], ...] = ()  # x, y [m] of a polite driver's way; the last is where he wants to be
    odometry: bool = True  # whether the base says where it is
    limit: str = ""  # why one forward depth camera cannot do it, if so
    facts: tuple[tuple[str, float], ...] = field(default=())  # what was drawn, for the report

    @property
    def name(self) -> str:
        return f"{self.family}:{self.seed}"

    @property
    def settled_at(self) -> float:
        """[s] from when on nothing moves but the robot, and the camera is well."""
        paths = [thing.path.ends_at for thing in self.things if thing.path]
        return max([0.0, self.faults.over_at, *paths, *(turn.spell.end for turn in self.turns)])


def random_of(family: str, seed: int, purpose: int = 0) -> np.random.Generator:
    """The same on every machine; another stream for another `purpose`."""
    return np.random.Generator(np.random.SFC64([zlib.crc32(family.encode()), seed, purpose]))
