# SPDX-License-Identifier: BSD-3-Clause
"""The simulated TurtleBot as a whole: a Base and a Camera in a World, moved on in equal ticks by whoever holds it."""
from __future__ import annotations

from collections.abc import Iterable
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from .base import DRIVER, Base, Limits, Pose, Velocity, pitch_at
from .camera import Camera, Picture
from .world import Contact, World

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

TICK = 0.01  # [s]


class TurtleBot:
    """Deterministic: the same world, seed and commands give the same bits.

    `seed` None leaves out the depth's noise and the body's rocking.
    """

    def __init__(self, world: World, limits: Limits = DRIVER, seed: int | None = 0) -> None:
        self.world = world
        self.base = Base(limits)
        self.contacts: tuple[Contact, ...] = ()  # of the last tick
        self.velocity = Velocity()  # over the floor, which slipping wheels do not tell
        self._ticks = 0
        self._camera: Camera | None = None
        self.reset(seed)

    @property
    def time(self) -> float:
        """[s] since the robot was made; nothing turns it back."""
        return self._ticks * TICK

    @property
    def pose(self) -> Pose:
        return self.base.pose

    def command(self, velocity: Velocity) -> None:
        """What arrives on /mobile_base/commands/velocity."""
        self.base.command(velocity, self.time)

    def step(self) -> None:
        """One TICK. Nothing gives way to the robot: it stays, wheels slipping, where going on would lead deeper in."""
        self._ticks += 1
        before, after = self.pose, self.base.next_pose(self.time, TICK)
        self.velocity = self.base.velocity
        self.contacts = self._touching_at(after)
        if self.contacts:
            if _deepest(self.contacts) > _deepest(self._touching_at(before)):
                after, self.velocity = before, Velocity()
            self._put(after)
        self.base.pose = after

    def advance(self, seconds: float) -> None:
        for _ in range(round(seconds / TICK)):
            self.step()

    def depth(self) -> NDArray[np.float32]:
        """What the Xtion sees now, [m], see `Camera.depth`."""
        return self._eye().depth(self._random)

    def colour(self) -> NDArray[np.uint8]:
        """(height, width, 3) red, green, blue."""
        return self._eye().colour()

    def picture(self) -> Picture:
        """Depth and colour at once."""
        return self._eye().picture(self._random)

    def place(self, pose: Pose) -> None:
        """Lift the robot and put it down at `pose`, at rest."""
        self.base.stand_at(pose)
        self.velocity = Velocity()
        self.contacts = self._touching_at(pose)

    def reset(self, seed: int | None) -> None:
        """As newly made with this seed, back at the world's start and the dropped boxes gone; the time goes on."""
        self._random = None if seed is None else np.random.Generator(np.random.SFC64(seed))
        self._phase = 0.0 if self._random is None else float(self._random.uniform(-pi, pi))
        self.world.clear_boxes()
        self.place(self.world.start)

    def close(self) -> None:
        """Give OpenGL's buffers back; the next look makes new ones."""
        if self._camera is not None:
            self._camera.close()
            self._camera = None

    def _eye(self) -> Camera:
        if self._camera is None:  # belongs to the thread that looks
            self._camera = Camera(self.world)
        return self._camera

    def _touching_at(self, pose: Pose) -> tuple[Contact, ...]:
        self._put(pose)
        return self.world.contacts()

    def _put(self, pose: Pose) -> None:
        rocking_speed = 0.0 if self._random is None else self.base.velocity.linear
        self.world.place_robot(pose, pitch_at(rocking_speed, self.base.pitch_phase + self._phase))


def _deepest(contacts: Iterable[Contact]) -> float:
    return max((contact.depth for contact in contacts), default=0.0)
