# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces from which the camera gets nothing back."""
from __future__ import annotations

from dataclasses import replace
from math import radians

from ...simulation.base import Pose
from ..things import Surface, Thing, post, wall
from .draft import Draft, Draw, background

NEVER_RETURNS = "it never returns anything to the camera"


def _glass_wall(draw: Draw) -> Draft:
    """The camera sees what is behind it."""
    yaw = radians(draw.between(-40, 40, "yaw [deg]"))
    pane = wall("pane", draw.between(1.0, 1.8, "distance [m]"), yaw=yaw, length=3.0, surface=Surface.GLASS)
    return Draft((pane, *background(draw, 2.6)), limit=NEVER_RETURNS)


def _glass_with_a_frame(draw: Draw) -> Draft:
    """A pane between a rail at the camera's height and one on the floor."""
    x, yaw = draw.between(1.1, 1.9, "distance [m]"), radians(draw.between(-30, 30, "yaw [deg]"))
    pane = Thing("pane", Pose(x, 0.0, yaw), (0.01, 2.0, 1.8), surface=Surface.GLASS)
    rail = Thing("rail", Pose(x, 0.0, yaw), (0.04, 2.0, 0.05), draw.between(0.20, 0.40, "rail [m]"))
    return Draft((pane, rail, Thing("sill", Pose(x, 0.0, yaw), (0.04, 2.0, 0.08)), *background(draw, 2.8)))


def _black_wall(draw: Draw) -> Draft:
    """As wide as the view: the camera returns the floor before it and nothing else."""
    yaw = radians(draw.between(-40, 40, "yaw [deg]"))
    return Draft((wall("black", draw.between(1.0, 2.0, "distance [m]"), yaw=yaw, surface=Surface.BLACK),),
                 limit=NEVER_RETURNS)


def _black_box(draw: Draw) -> Draft:
    place = Pose(draw.between(1.2, 2.0, "distance [m]"), draw.between(-0.1, 0.1), radians(draw.between(-30, 30)))
    size = (0.4, draw.between(0.2, 0.6, "width [m]"), draw.between(0.3, 1.0, "height [m]"))
    return Draft((Thing("black", place, size, surface=Surface.BLACK), *background(draw, 3.0)), limit=NEVER_RETURNS)


def _black_post_with_a_bright_foot(draw: Draw) -> Draft:
    """Only its lowest 20 cm return."""
    x, y = draw.between(1.0, 1.8, "distance [m]"), draw.between(-0.15, 0.15)
    diameter = draw.between(0.05, 0.10, "diameter [m]")
    foot = post("foot", x, y, diameter, height=0.20)
    black = replace(post("black", x, y, diameter, height=1.0, surface=Surface.BLACK), bottom=0.20)
    return Draft((foot, black, *background(draw, 3.0)))


FAMILIES = {
    "glass_wall": _glass_wall, "glass_with_a_frame": _glass_with_a_frame, "black_wall": _black_wall,
    "black_box": _black_box, "black_post_with_a_bright_foot": _black_post_with_a_bright_foot,
}
