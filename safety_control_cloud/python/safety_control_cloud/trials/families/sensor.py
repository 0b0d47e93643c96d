# SPDX-License-Identifier: BSD-3-Clause
"""Cameras that fail, before a wall or a post."""
from __future__ import annotations

from math import inf, radians

from ..camera_faults import CameraFaults, Spell
from ..things import Thing, post, wall
from .draft import Draft, Draw, background


def _dropouts(draw: Draw) -> Draft:
    """No clouds for 0.1 to 2 s, three times."""
    spells = tuple(Spell(draw.between(start, start + 3.0), draw.between(0.1, 2.0, "dropout [s]")) for start in (0.5, 4.0, 7.5))
    return Draft(_in_the_way(draw), faults=CameraFaults(dropouts=spells))


def _camera_dies(draw: Draw) -> Draft:
    """And never comes again."""
    return Draft(_in_the_way(draw), faults=CameraFaults(dropouts=(Spell(draw.between(1.0, 6.0, "at [s]"), inf),)), seconds=14.0)


def _frozen(draw: Draw) -> Draft:
    """The camera repeats its last picture with new stamps; the node has been told to look for that."""
    frozen = Spell(draw.between(0.5, 6.0, "at [s]"), inf)
    return Draft(_in_the_way(draw), faults=CameraFaults(frozen=frozen), settings=(("frozen_clouds", 5),), seconds=14.0)


def _late(draw: Draw) -> Draft:
    """Every cloud comes 50 to 400 ms late."""
    least = draw.between(0.05, 0.25, "least [s]")
    return Draft(_in_the_way(draw), faults=CameraFaults(lateness=(least, draw.between(least, 0.4, "most [s]"))))


def _skewed_clock(draw: Draw) -> Draft:
    """The camera's clock is off, from the start or from some moment on."""
    skew = draw.sign() * draw.between(0.1, 4.0, "skew [s]")
    start = 0.0 if draw.chance(0.5) else draw.between(1.0, 5.0)
    return Draft(_in_the_way(draw), faults=CameraFaults(skew=skew, skewed_from=start))


def _speckle(draw: Draw) -> Draft:
    """Pixels that return any depth."""
    return Draft(_in_the_way(draw), faults=CameraFaults(speckle=10 ** draw.between(-5.5, -3.0, "log10 of the share")))


def _flying_pixels(draw: Draw) -> Draft:
    """Posts beside the way, and at their edges depths at which there is nothing."""
    beside = tuple(
        post(f"beside_{i}", draw.between(0.8, 2.0), side * draw.between(0.45, 0.6), 0.06) for i, side in enumerate((1, -1))
    )
    return Draft((*beside, *_in_the_way(draw)), faults=CameraFaults(flying=draw.between(0.1, 0.8, "share")))


def _in_the_way(draw: Draw) -> tuple[Thing, ...]:
    distance = draw.between(1.0, 2.2, "distance [m]")
    if draw.chance(0.5):
        return (wall("wall", distance, yaw=radians(draw.between(-40, 40))),)
    return (post("post", distance, draw.between(-0.15, 0.15), draw.between(0.03, 0.1)), *background(draw, 3.0))


FAMILIES = {
    "dropouts": _dropouts, "camera_dies": _camera_dies, "frozen": _frozen, "late": _late, "skewed_clock": _skewed_clock,
    "speckle": _speckle, "flying_pixels": _flying_pixels,
}
