# SPDX-License-Identifier: BSD-3-Clause
"""What comes into the robot's way from the side, or by its turning."""
from __future__ import annotations

from math import cos, radians, sin

from ...simulation.base import Pose
from ...simulation.hull import BODY_RADIUS
from ..camera_faults import Spell
from ..scenario import Turn
from ..things import Path, Thing, post, wall
from .draft import Draft, Draw, at_most_driven, background


def _slides_into_the_blind_zone(draw: Draw) -> Draft:
    """While the robot stands before a wall in Danger, a post slides in nearer than the camera sees, and the wall goes."""
    goes, speed = draw.between(4.5, 6.0), draw.between(0.3, 1.0, "speed [m/s]")
    diameter, side = draw.between(0.04, 0.12, "diameter [m]"), draw.sign()
    x, y = draw.between(0.23, 0.29, "distance [m]") + diameter / 2, draw.between(-0.12, 0.12)
    begins, away = draw.between(1.5, 2.5), side * 1.2
    slide = Path(((begins, x, away), (begins + abs(away - y) / speed, x, y)))
    gate = Path(((goes, 0.45, 0.0), (goes + 2.0, 0.45, 4.0)))
    thing = Thing("slider", Pose(), (diameter, diameter, 1.2), round=True, path=slide)
    return Draft((thing, Thing("gate", Pose(), (0.05, 2.0, 1.5), path=gate), *background(draw)))


def _slides_out_again(draw: Draw) -> Draft:
    """A post slides across before the robot and away: it must not stand for ever."""
    side, begins, crossing = draw.sign(), draw.between(0.5, 1.5), 2.4 / draw.between(0.4, 1.0, "speed [m/s]")
    x = at_most_driven(begins + crossing / 2) + BODY_RADIUS + draw.between(0.15, 0.5, "from the hull [m]")
    path = Path(((begins, x, -side * 1.2), (begins + crossing, x, side * 1.2)))
    thing = Thing("slider", Pose(), (0.1, 0.1, 1.2), round=True, path=path)
    return Draft((thing, *background(draw, 3.5)))


def _door_opens(draw: Draw) -> Draft:
    """A board across the way slides aside, what is behind it is free."""
    begins, x = draw.between(4.0, 7.0), draw.between(0.8, 1.4, "distance [m]")
    path = Path(((begins, x, 0.0), (begins + 2.0, x, 3.0)))
    return Draft((Thing("door", Pose(), (0.05, 1.6, 1.8), path=path), *background(draw, 3.5)))


def _turned_toward(draw: Draw) -> Draft:
    """Posts and a wall stand about, and somebody turns the robot while it drives."""
    turns = tuple(
        Turn(Spell(start, draw.between(0.4, 1.2)), draw.sign() * draw.between(0.4, 1.2, "rate [rad/s]"))
        for start in (draw.between(1.0, 3.0), draw.between(4.5, 6.5))
    )
    posts = tuple(
        post(f"post_{i}", draw.between(0.8, 1.8), side * draw.between(0.35, 0.9), draw.between(0.03, 0.10))
        for i, side in enumerate((-1, 1, draw.sign()))
    )
    return Draft((*posts, wall("background", draw.between(1.8, 3.0))), turns=turns)


def _turned_onto_a_near_post(draw: Draw) -> Draft:
    """It stands beside the camera's view, nearer than the camera can see, when the robot has been turned to it."""
    angle, side = radians(draw.between(45, 80, "angle [deg]")), draw.sign()
    diameter, reach = draw.between(0.03, 0.10, "diameter [m]"), draw.between(0.20, 0.28, "distance [m]")
    middle = reach + diameter / 2
    rate = draw.between(0.5, 1.2, "rate [rad/s]")
    turn = Turn(Spell(0.5, angle / rate), side * rate)
    thing = post("post", middle * cos(angle), side * middle * sin(angle), diameter)
    return Draft((thing, wall("around", -2.5), *background(draw, 2.0)), seconds=10.0, turns=(turn,))


def _shelf_slides_in(draw: Draw) -> Draft:
    """A hanging board comes across at the camera's height into a robot that drives, far enough ahead to be seen."""
    begins, side, x = draw.between(1.0, 3.0), draw.sign(), draw.between(1.4, 2.2, "distance [m]")
    speed = draw.between(0.2, 0.8, "speed [m/s]")
    path = Path(((begins, x, side * 1.5), (begins + 1.5 / speed, x, 0.0)))
    return Draft((Thing("shelf", Pose(), (0.3, 0.5, 0.05), draw.between(0.22, 0.36), path=path), *background(draw)))


FAMILIES = {
    "slides_into_the_blind_zone": _slides_into_the_blind_zone, "slides_out_again": _slides_out_again,
    "door_opens": _door_opens, "turned_toward": _turned_toward, "turned_onto_a_near_post": _turned_onto_a_near_post,
    "shelf_slides_in": _shelf_slides_in,
}
