# SPDX-License-Identifier: BSD-3-Clause
"""Things that stand or hang in the robot's way."""
from __future__ import annotations

from math import cos, radians, sin

from ...simulation.base import Pose
from ..things import Thing, post, wall
from .draft import Draft, Draw, background


def _closed_cabinet(draw: Draw) -> Draft:
    return Draft((_box(draw, "cabinet", (0.45, 0.45, 1.02)), wall("background", 3.2)))


def _open_cabinet(draw: Draw) -> Draft:
    """Gazebo's cabinet, its open front toward the robot."""
    x, y, yaw = draw.between(1.2, 2.0, "distance [m]"), draw.between(-0.3, 0.3), radians(draw.between(-30, 30, "yaw [deg]"))

    def part(name: str, ahead: float, left: float, size: tuple[float, float, float], bottom: float = 0.0) -> Thing:
        place = Pose(x + ahead * cos(yaw) - left * sin(yaw), y + ahead * sin(yaw) + left * cos(yaw), yaw)
        return Thing(name, place, size, bottom)

    sides = [part(name, 0.225, left, (0.45, 0.02, 1.02)) for name, left in (("left", 0.215), ("right", -0.215))]
    boards = [part(f"board_{i}", 0.215, 0.0, (0.43, 0.41, 0.02), height) for i, height in enumerate((0.0, 0.50, 1.0))]
    return Draft((*sides, *boards, part("back", 0.44, 0.0, (0.02, 0.41, 1.02)), wall("background", 3.2)))


def _post(draw: Draw) -> Draft:
    """2 to 10 cm wide, anywhere in the corridor that the robot's body goes through."""
    diameter = draw.between(0.02, 0.10, "diameter [m]")
    y = draw.between(-0.17, 0.17, "beside [m]")
    return Draft((post("post", draw.between(0.9, 2.0, "distance [m]"), y, diameter), *background(draw)))


def _post_at_the_edge(draw: Draw) -> Draft:
    """Where the robot's body ends or just misses it."""
    y = draw.sign() * draw.between(0.17, 0.26, "beside [m]")
    return Draft((post("post", draw.between(0.9, 1.8), y, draw.between(0.02, 0.08, "diameter [m]")), *background(draw)))


def _post_in_the_blind_zone(draw: Draw) -> Draft:
    """There from the start: it has never been seen, only the floor before it has not been seen either."""
    y = draw.between(-0.15, 0.15, "beside [m]")
    diameter = draw.between(0.03, 0.10, "diameter [m]")
    x = draw.between(0.20, 0.28, "distance [m]") + diameter / 2
    return Draft((post("post", x, y, diameter), *background(draw, 2.0)), seconds=8.0)


def _low_box(draw: Draw) -> Draft:
    height = draw.between(0.12, 0.25, "height [m]")
    return Draft((_box(draw, "box", (0.3, draw.between(0.1, 0.5, "width [m]"), height)), *background(draw)))


def _kerb(draw: Draw) -> Draft:
    """Lower than the corridor, higher than the robot's ground clearance."""
    return Draft((_box(draw, "kerb", _kerb_size(draw)), *background(draw)))


def _kerb_in_a_lower_corridor(draw: Draw) -> Draft:
    """The camera looks over a kerb nearer than 0.6 m, so the robot has to stand before that."""
    settings = (("y_max", 0.26), ("danger_distance", 0.65), ("warning_distance", 1.15))
    return Draft((_box(draw, "kerb", _kerb_size(draw)), *background(draw)), settings=settings)


def _kerb_size(draw: Draw) -> tuple[float, float, float]:
    return 0.3, draw.between(0.2, 0.6, "width [m]"), draw.between(0.05, 0.085, "height [m]")


def _hanging_board(draw: Draw) -> Draft:
    """At the camera's height, nothing below it."""
    thickness, bottom = draw.between(0.03, 0.15, "thickness [m]"), draw.between(0.20, 0.36, "height [m]")
    size = (draw.between(0.02, 0.3), draw.between(0.1, 0.8, "width [m]"), thickness)
    place = Pose(draw.between(1.2, 2.0, "distance [m]"), draw.between(-0.15, 0.15), radians(draw.between(-20, 20)))
    return Draft((Thing("board", place, size, bottom), *background(draw)))


def _table(draw: Draw) -> Draft:
    """Its edge is all that stands in the way: the legs are beside the robot."""
    bottom = draw.between(0.28, 0.38, "height [m]")
    place = Pose(draw.between(1.6, 2.3, "distance [m]"), draw.between(-0.1, 0.1), radians(draw.between(-30, 30, "yaw [deg]")))
    top = Thing("table_top", place, (0.8, 1.2, 0.03), bottom)
    legs = []
    for name, ahead, left in (("fl", -0.35, 0.55), ("fr", -0.35, -0.55), ("bl", 0.35, 0.55), ("br", 0.35, -0.55)):
        x = place.x + ahead * cos(place.yaw) - left * sin(place.yaw)
        y = place.y + ahead * sin(place.yaw) + left * cos(place.yaw)
        legs.append(post(f"leg_{name}", x, y, 0.04, bottom))
    return Draft((top, *legs, *background(draw, 3.5)))


def _box(draw: Draw, name: str, size: tuple[float, float, float]) -> Thing:
    """Somewhere ahead where the robot would run into it."""
    place = Pose(draw.between(1.2, 2.0, "distance [m]") + size[0] / 2, draw.between(-0.15, 0.15, "beside [m]"),
                 radians(draw.between(-35, 35, "yaw [deg]")))
    return Thing(name, place, size)


FAMILIES = {
    "closed_cabinet": _closed_cabinet, "open_cabinet": _open_cabinet, "post": _post, "post_at_the_edge": _post_at_the_edge,
    "post_in_the_blind_zone": _post_in_the_blind_zone, "low_box": _low_box, "kerb": _kerb,
    "kerb_in_a_lower_corridor": _kerb_in_a_lower_corridor, "hanging_board": _hanging_board, "table": _table,
}
