# SPDX-License-Identifier: BSD-3-Clause
"""Where the robot should drive on: halls, doorways, rough floors."""
from __future__ import annotations

from math import pi

from ...simulation.base import Pose
from ..camera_faults import CameraFaults
from ..things import Thing, post, wall
from .draft import CAMERA_Y, Draft, Draw


def _hall(draw: Draw) -> Draft:
    """Nothing within the camera's range but floor."""
    return Draft((wall("far", draw.between(8.0, 20.0, "distance [m]")),), seconds=12.0)


def _hall_with_posts_beside(draw: Draw) -> Draft:
    """All of them beside the corridor."""
    posts = tuple(
        post(f"post_{i}", draw.between(0.6, 3.0), CAMERA_Y + (-1) ** i * draw.between(0.40, 0.8), draw.between(0.03, 0.12))
        for i in range(6)
    )
    return Draft((*posts, wall("far", draw.between(5.0, 9.0))), seconds=14.0)


def _doorway(draw: Draw) -> Draft:
    """Exactly 0.62 m wide, straight ahead: 1 cm more than the corridor on each side."""
    x, middle = draw.between(1.0, 1.6, "distance [m]"), CAMERA_Y + draw.between(-0.003, 0.003)
    depth = draw.between(0.05, 0.3, "depth [m]")
    jambs = tuple(
        Thing(name, Pose(x + depth / 2, middle + side * (0.31 + 1.0)), (depth, 2.0, 2.2))
        for name, side in (("left", 1), ("right", -1))
    )
    return Draft((*jambs, wall("far", x + draw.between(2.5, 4.0))), seconds=18.0)


def _passage(draw: Draw) -> Draft:
    """Between two walls, 0.8 to 1.5 m apart."""
    half = draw.between(0.40, 0.75, "half width [m]")
    sides = tuple(
        wall(name, 2.0, CAMERA_Y + side * half, side * pi / 2, length=8.0) for name, side in (("left", 1), ("right", -1))
    )
    return Draft((*sides, wall("end", draw.between(3.0, 6.0))), seconds=14.0)


def _bumps(draw: Draw) -> Draft:
    """Sills and cables that pitch the robot by up to two degrees."""
    bumps = tuple((draw.between(at, at + 2.0), draw.between(-0.035, 0.035, "bump [rad]")) for at in (0.5, 3.0, 5.5, 8.0))
    return Draft((wall("far", draw.between(2.2, 6.0)),), faults=CameraFaults(bumps=bumps), seconds=14.0)


FAMILIES = {
    "hall": _hall, "hall_with_posts_beside": _hall_with_posts_beside, "doorway": _doorway, "passage": _passage, "bumps": _bumps,
}
