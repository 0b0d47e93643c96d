# SPDX-License-Identifier: BSD-3-Clause
"""Where somebody drives to a goal, as one should: nothing is to be taken from that."""
from __future__ import annotations

from math import cos, radians, sin

from ...simulation.base import Pose
from ..things import Thing, post, wall
from .draft import Draft, Draw
from .rude import DOORWAY, hull_of, settings_for

SECONDS = 60.0  # enough for twice the way


def _doorway(draw: Draw) -> Draft:
    """0.75 m wide, not straight ahead."""
    x, y = draw.between(1.4, 2.0, "distance [m]"), draw.between(-0.5, 0.5, "beside [m]")
    yaw, depth = radians(draw.between(-15, 15, "yaw [deg]")), draw.between(0.05, 0.25, "depth [m]")

    def at(ahead: float, left: float) -> tuple[float, float]:
        return x + ahead * cos(yaw) - left * sin(yaw), y + ahead * sin(yaw) + left * cos(yaw)

    jambs = tuple(Thing(name, Pose(*at(depth / 2, side * (DOORWAY / 2 + 1.0)), yaw), (depth, 2.0, 2.2))
                  for name, side in (("left_jamb", 1), ("right_jamb", -1)))
    return _along(draw, jambs, (at(-0.8, 0.0), at(0.8, 0.0), at(draw.between(1.2, 1.8), draw.between(-0.3, 0.3))))


def _posts(draw: Draw) -> Draft:
    """A slalom: each post is passed a hull's half width and 25 to 40 cm from its side."""
    things, route, x, side = [], [], 0.0, draw.sign()
    for i in range(3):
        x, side = x + draw.between(1.2, 1.6), -side
        things.append(post(f"post_{i}", x, 0.0, draw.between(0.03, 0.10)))
        route.append((x, side * (0.25 + draw.between(0.25, 0.40, "clear [m]"))))
    return _along(draw, tuple(things), (*route, (x + 1.0, 0.0)))


def _passage(draw: Draw) -> Draft:
    """Between two walls, 0.9 to 1.3 m apart, and to a wall at its end."""
    half, length = draw.between(0.45, 0.65, "half width [m]"), draw.between(3.0, 4.0)
    sides = tuple(Thing(name, Pose(0.5 + length / 2, side * (half + 0.05)), (length, 0.1, 2.2)) for name, side in (("left", 1), ("right", -1)))
    return _along(draw, (*sides, wall("end", length + 0.5)), ((0.6, 0.0), (length - 0.4, 0.0)))


def _along(draw: Draw, things: tuple[Thing, ...], route: tuple[tuple[float, float], ...]) -> Draft:
    hull = hull_of(draw)
    return Draft(things, hull=hull, settings=settings_for(hull), route=route, odometry=draw.chance(0.75), seconds=SECONDS,
                 start=Pose(0.0, draw.between(-0.15, 0.15) if things[0].round else 0.0, draw.between(-0.3, 0.3)))


FAMILIES = {"polite_doorway": _doorway, "polite_posts": _posts, "polite_passage": _passage}
