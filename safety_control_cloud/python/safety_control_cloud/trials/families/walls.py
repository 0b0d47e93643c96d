# SPDX-License-Identifier: BSD-3-Clause
"""Walls and nothing else."""
from __future__ import annotations

from math import cos, radians, sin

from ..things import wall
from .draft import CAMERA_X, Draft, Draw


def _wall(draw: Draw) -> Draft:
    """At any yaw."""
    yaw = radians(draw.between(-60, 60, "yaw [deg]"))
    return Draft((wall("wall", draw.between(1.0, 2.2, "distance [m]"), yaw=yaw),))


def _wall_in_the_blind_zone(draw: Draw) -> Draft:
    """The robot starts nearer to it than the camera can see, but does not touch it."""
    yaw = radians(draw.between(-25, 25, "yaw [deg]"))
    gap = draw.between(0.02, 0.12, "hull to wall [m]")
    reach = 0.178 + gap  # [m] from the robot's middle to the wall's plane
    return Draft((wall("wall", reach * cos(yaw), reach * sin(yaw), yaw),), seconds=8.0)


def _corner(draw: Draw) -> Draft:
    """Two walls that meet ahead of the robot."""
    x, y = draw.between(1.2, 2.2, "distance [m]"), draw.between(-0.4, 0.4, "beside [m]")
    opening = radians(draw.between(35, 80, "half angle [deg]"))
    ahead = x + 2.5 * cos(opening)
    sides = [
        wall(f"wall_{name}", x - 2.5 * cos(opening), y + side * 2.5 * sin(opening), side * (1.5708 - opening), length=5.0)
        for name, side in (("left", 1), ("right", -1))
    ]
    return Draft((*sides, wall("background", ahead + 1.0 + CAMERA_X)))


FAMILIES = {"wall": _wall, "wall_in_the_blind_zone": _wall_in_the_blind_zone, "corner": _corner}
