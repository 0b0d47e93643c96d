# SPDX-License-Identifier: BSD-3-Clause
"""Small worlds whose geometry a test can compute by hand, and a steering that decides as the tutorial does."""
from __future__ import annotations

import numpy as np

from safety_control_cloud.simulation.base import Velocity
from safety_control_cloud.simulation.sensor import Xtion, points
from safety_control_cloud.simulation.world import World

FLOOR = '<geom name="floor" type="plane" size="0 0 1"/>'


def box(name: str, x: float, y: float, half: tuple[float, float, float]) -> str:
    """A box standing on the floor, its centre above (x, y), `half` its half sides."""
    return f'<geom name="{name}" type="box" pos="{x} {y} {half[2]}" size="{half[0]} {half[1]} {half[2]}"/>'


def wall_at(x: float) -> str:
    """A wall of 10 x 5 m across the robot's way, its front at `x` [m]."""
    return box("wall", x + 0.1, 0, (0.1, 5, 2.5))


def room(*things: str, xtion: Xtion = Xtion()) -> World:
    return World.from_xml(f"<mujoco><worldbody>{FLOOR}{''.join(things)}</worldbody></mujoco>", xtion)


def tutorial_steering(xtion: Xtion):
    """The tutorial's pipeline in numpy, but standing where nothing is to be seen at all."""

    def steer(depth: np.ndarray, now: float) -> Velocity:
        if not np.isfinite(depth).any():
            return Velocity()
        x, y, z = np.moveaxis(points(depth, xtion), -1, 0)
        nearest = z[(abs(x) <= 0.3) & (y >= -0.25) & (y <= 0.2)].min(initial=np.inf)
        return Velocity(0.2 if nearest > 1.0 else 0.1 if nearest > 0.5 else 0.0)

    return steer
