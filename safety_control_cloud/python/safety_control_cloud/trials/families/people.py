# SPDX-License-Identifier: BSD-3-Clause
"""Somebody on two legs."""
from __future__ import annotations

from math import pi

from ...simulation.hull import BODY_RADIUS
from .draft import LEG, Draft, Draw, at_most_driven, background, legs, stops_at


def _crosses(draw: Draw) -> Draft:
    """From side to side ahead of the robot, at 0.3 to 1.5 m/s."""
    side, speed = draw.sign(), draw.between(0.3, 1.5, "speed [m/s]")
    begins = draw.between(0.5, 4.0)
    x = at_most_driven(begins + 2.0 / speed) + BODY_RADIUS + draw.between(0.25, 1.2, "from the hull [m]")
    way = ((begins, x, -side * 2.0), (begins + 4.0 / speed, x, side * 2.0))
    return Draft((*legs(draw, way, side * pi / 2), *background(draw, 3.5)))


def _crosses_close(draw: Draw) -> Draft:
    """From side to side, nearer to the robot than it can brake, or through the place where it would stand."""
    side, speed = draw.sign(), draw.between(0.3, 1.5, "speed [m/s]")
    begins = draw.between(0.5, 4.0)
    x = at_most_driven(begins + 2.0 / speed) + BODY_RADIUS + draw.between(-0.2, 0.25, "from the hull [m]")
    way = ((begins, x, -side * 2.0), (begins + 4.0 / speed, x, side * 2.0))
    return Draft((*legs(draw, way, side * pi / 2), *background(draw, 3.5)))


def _walks_up(draw: Draw) -> Draft:
    """Toward the robot, and stops where the camera cannot see: 0.28 to 0.4 m before it."""
    begins, speed = draw.between(0.5, 2.5), draw.between(0.4, 1.2, "speed [m/s]")
    stops, y = _before_the_robot(draw, 3.0, begins, speed, 0.135), draw.between(-0.12, 0.12)
    way = ((begins, 3.0, y), (begins + (3.0 - stops) / speed, stops, y))
    return Draft((*legs(draw, way, pi), *background(draw, 4.0)))


def _walks_up_and_leaves(draw: Draw) -> Draft:
    """Stands before the robot for a while, and goes away to the side."""
    begins, speed = draw.between(0.2, 1.0), draw.between(0.5, 1.2, "speed [m/s]")
    near, y, side = _before_the_robot(draw, 2.5, begins, speed, 0.4), draw.between(-0.1, 0.1), draw.sign()
    there = begins + (2.5 - near) / speed
    leaves = there + draw.between(1.0, 3.0)
    way = ((begins, 2.5, y), (there, near, y), (leaves, near, y), (leaves + 2.0 / speed, near + 0.2, y + side * 2.0))
    return Draft((*legs(draw, way, pi), *background(draw, 3.5)), seconds=18.0)


def _before_the_robot(draw: Draw, start: float, begins: float, speed: float, most: float) -> float:
    """x [m] of who comes from x = `start` and stops 2 cm to `most` [m] before a robot that stands by then."""
    return stops_at(start, begins, speed) + BODY_RADIUS + LEG + draw.between(0.02, most, "from the hull [m]")


def _stands(draw: Draw) -> Draft:
    """Two legs that do not move."""
    x, y = draw.between(0.9, 2.0, "distance [m]"), draw.between(-0.12, 0.12)
    return Draft((*legs(draw, ((0.0, x, y),), draw.between(-pi, pi)), *background(draw, 3.0)))


FAMILIES = {
    "person_crosses": _crosses, "person_crosses_close": _crosses_close, "person_walks_up": _walks_up,
    "person_walks_up_and_leaves": _walks_up_and_leaves, "person_stands": _stands,
}
