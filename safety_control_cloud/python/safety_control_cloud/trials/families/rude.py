# SPDX-License-Identifier: BSD-3-Clause
"""Where somebody tries to hit things: they stand on all sides of the robot, behind it too."""
from __future__ import annotations

from math import cos, hypot, pi, sin

from ...simulation.base import Pose
from ...simulation.hull import BODY_RADIUS, Rectangle
from ..things import Path, Thing, post, wall
from .draft import Draft, Draw

SECONDS = 16.0
DOORWAY = 0.75  # [m]
STEPS_FASTER = 2.4  # times the walker, of his feet in mid-stride: 1 + 2 pi stride / step


def _boxes(draw: Draw) -> Draft:
    return _among(draw, _boxes_around(draw, 5))


def _posts(draw: Draw) -> Draft:
    """2 to 10 cm."""
    return _among(draw, _posts_around(draw, 7))


def _room(draw: Draw) -> Draft:
    """Four walls."""
    half = draw.between(1.2, 2.2, "half side [m]")
    return _among(draw, _walls_around(draw, half))


def _doorway(draw: Draw) -> Draft:
    """0.75 m, ahead; and a wall farther on."""
    x, y = draw.between(0.9, 1.8, "distance [m]"), draw.between(-0.3, 0.3, "beside [m]")
    depth = draw.between(0.05, 0.25)
    jambs = tuple(Thing(name, Pose(x + depth / 2, y + side * (DOORWAY / 2 + 0.75)), (depth, 1.5, 2.2))
                  for name, side in (("left_jamb", 1), ("right_jamb", -1)))
    return _among(draw, (*jambs, wall("far", x + draw.between(1.5, 2.5))))


def _people(draw: Draw) -> Draft:
    """Who stand."""
    return _among(draw, tuple(leg for i in range(4) for leg in _person(draw, f"person_{i}", *_place(draw, 0.3))))


def _walkers(draw: Draw) -> Draft:
    """Who walk slowly across the room, and the guard has been told how fast their feet may come."""
    speed = draw.between(0.1, 0.25, "speed [m/s]")
    people = []
    for i in range(2):
        (x, y), begins = _place(draw, 0.5), draw.between(0.0, 4.0)
        to_x, to_y = _place(draw, 0.5)
        lasts = hypot(to_x - x, to_y - y) / speed
        times = [begins + lasts * share for share in (0.0, 1.0)]
        people += _person(draw, f"walker_{i}", x, y, ((times[0], 0.0, 0.0), (times[1], to_x - x, to_y - y)))
    return _among(draw, tuple(people), settings=(("obstacle_speed", round(STEPS_FASTER * speed, 3)),))


def _mixed(draw: Draw) -> Draft:
    return _among(draw, (*_walls_around(draw, draw.between(1.8, 2.6)), *_boxes_around(draw, 2), *_posts_around(draw, 3)))


def _among(draw: Draw, things: tuple[Thing, ...], settings: tuple[tuple[str, float | str], ...] = ()) -> Draft:
    hull = hull_of(draw)
    return Draft(things, hull=hull, settings=(*settings, *settings_for(hull)), odometry=draw.chance(0.75), seconds=SECONDS)


def hull_of(draw: Draw) -> Rectangle | None:
    """As often the TurtleBot's own circle as a rectangle, longer behind than before its wheels."""
    if draw.chance(0.5):
        return None
    return Rectangle(-draw.between(0.15, 0.35, "back [m]"), draw.between(0.15, 0.24, "front [m]"),
                     draw.between(0.15, 0.25, "half width [m]"))


def settings_for(hull: Rectangle | None) -> tuple[tuple[str, float | str], ...]:
    mode = ("mode", "guard")
    if hull is None:
        return mode, ("radius", BODY_RADIUS)
    return mode, ("footprint", str([[round(x, 4), round(y, 4)] for x, y in hull.corners]))


def _place(draw: Draw, clear: float) -> tuple[float, float]:
    """x, y [m] with nothing nearer to the robot's start than its hull and `clear`."""
    distance, angle = draw.between(0.45 + clear, 2.4), draw.between(-pi, pi)
    return distance * cos(angle), distance * sin(angle)


def _boxes_around(draw: Draw, most: int) -> tuple[Thing, ...]:
    made = []
    for i in range(draw.one_of(*range(2, most + 1))):
        x, y = _place(draw, 0.4)
        size = (draw.between(0.1, 0.6), draw.between(0.1, 0.6), draw.between(0.15, 1.2))
        made.append(Thing(f"box_{i}", Pose(x, y, draw.between(-pi, pi)), size))
    return tuple(made)


def _posts_around(draw: Draw, most: int) -> tuple[Thing, ...]:
    return tuple(post(f"post_{i}", *_place(draw, 0.15), draw.between(0.02, 0.10)) for i in range(draw.one_of(*range(3, most + 1))))


def _walls_around(draw: Draw, half: float) -> tuple[Thing, ...]:
    turn = draw.between(-pi, pi)
    return tuple(wall(f"wall_{i}", half * cos(turn + i * pi / 2), half * sin(turn + i * pi / 2), turn + i * pi / 2, length=2 * half)
                 for i in range(4))


def _person(draw: Draw, name: str, x: float, y: float, way: tuple[tuple[float, float, float], ...] = ()) -> tuple[Thing, ...]:
    """Two legs, that walk along `way`: time [s], and x, y [m] from (x, y)."""
    diameter, apart, heading = draw.between(0.09, 0.15), draw.between(0.10, 0.16), draw.between(-pi, pi)
    legs = []
    for side in (-0.5, 0.5):
        foot = (x - side * apart * sin(heading), y + side * apart * cos(heading))
        moved = tuple((time, foot[0] + dx, foot[1] + dy) for time, dx, dy in way)
        path = Path(moved, stride=0.15, phase=pi * (side > 0)) if way else None
        legs.append(Thing(f"{name}_{'left' if side > 0 else 'right'}", Pose(*foot), (diameter, diameter, 0.85), round=True, path=path))
    return tuple(legs)


FAMILIES = {
    "rude_boxes": _boxes, "rude_posts": _posts, "rude_room": _room, "rude_doorway": _doorway, "rude_people": _people,
    "rude_walkers": _walkers, "rude_mixed": _mixed,
}
