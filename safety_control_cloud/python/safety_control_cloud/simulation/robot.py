# SPDX-License-Identifier: BSD-3-Clause
"""The TurtleBot's body for MuJoCo. `urdf/turtlebot.urdf` shows the same robot to rviz; a test compares the two."""
from __future__ import annotations

from math import cos, degrees, radians, sin, sqrt

from .base import WHEEL_RADIUS, WHEEL_SEPARATION
from .gl import mujoco
from .hull import BODY_CENTRE, BODY_HEIGHT, BODY_RADIUS, PLATES, TOWER_RADIUS, Rectangle
from .sensor import Xtion

PREFIX = "turtlebot/"
BODY = PREFIX + "body"
CAMERA = PREFIX + "xtion"
JOINTS = tuple(PREFIX + axis for axis in ("x", "y", "yaw", "pitch"))
GROUP = 5  # MuJoCo does not draw it unless asked: the Xtion looks out between the plates and sees none of the robot

BODY_MASS = 2.4  # [kg]
PLATE_RADIUS = 0.14  # [m]
PLATE_X = -0.02  # [m] of their centre; Gazebo draws the robot, and the Xtion is to look out between plates and poles
POLE_RADIUS = 0.006  # [m]
POLES = tuple(side * radians(angle) for angle in (75, 120, 165) for side in (1, -1))  # about the plates' centre
OPTICAL_TO_GL = (0.5, 0.5, -0.5, -0.5)  # w, x, y, z: MuJoCo's cameras look along -z with y up, the robot's nose is x
Z_TO_Y = (sqrt(0.5), -sqrt(0.5), 0, 0)  # w, x, y, z: MuJoCo's cylinders stand along z

_BLACK = (0.09, 0.09, 0.10, 1)
_WOOD = (0.24, 0.20, 0.17, 1)
_STEEL = (0.72, 0.73, 0.75, 1)


def add_turtlebot(spec: mujoco.MjSpec, xtion: Xtion, hull: Rectangle | None = None) -> None:
    """Put the robot at the world's origin, free to be placed by its four JOINTS [m, m, rad, rad].

    `hull`: in place of its own.
    """
    body = spec.worldbody.add_body(name=BODY)
    slide, hinge = mujoco.mjtJoint.mjJNT_SLIDE, mujoco.mjtJoint.mjJNT_HINGE
    kinds_and_axes = ((slide, (1, 0, 0)), (slide, (0, 1, 0)), (hinge, (0, 0, 1)), (hinge, (0, 1, 0)))
    for name, (kind, axis) in zip(JOINTS, kinds_and_axes):
        body.add_joint(name=name, type=kind, axis=axis)
    if hull:
        _add_box(body, hull)
    else:
        _add_hull(body)
    _add_looks(body, xtion)
    body.add_camera(name=CAMERA, pos=xtion.mount, quat=OPTICAL_TO_GL, fovy=degrees(xtion.vertical_view))


def _add_hull(body: mujoco.MjsBody) -> None:
    """The two cylinders that can touch something: the Kobuki, and the tower of plates upon it."""
    cylinder = mujoco.mjtGeom.mjGEOM_CYLINDER
    body.add_geom(
        name=PREFIX + "kobuki", type=cylinder, size=(BODY_RADIUS, BODY_HEIGHT / 2, 0), pos=(0, 0, BODY_CENTRE),
        mass=BODY_MASS, rgba=_BLACK, group=GROUP, contype=1, conaffinity=1,
    )
    low, high = PLATES[0], PLATES[-1]
    body.add_geom(
        name=PREFIX + "tower", type=cylinder, size=(TOWER_RADIUS, (high - low) / 2, 0), pos=(0, 0, (low + high) / 2),
        mass=1.0, rgba=(0, 0, 0, 0), group=GROUP, contype=1, conaffinity=1,
    )


def _add_box(body: mujoco.MjsBody, hull: Rectangle) -> None:
    low, high = BODY_CENTRE - BODY_HEIGHT / 2, PLATES[-1]
    body.add_geom(
        name=PREFIX + "hull", type=mujoco.mjtGeom.mjGEOM_BOX, mass=BODY_MASS, rgba=_BLACK, group=GROUP,
        size=((hull.front - hull.back) / 2, hull.half_width, (high - low) / 2),
        pos=((hull.front + hull.back) / 2, 0, (low + high) / 2), contype=1, conaffinity=1,
    )


def _add_looks(body: mujoco.MjsBody, xtion: Xtion) -> None:
    def add(kind: mujoco.mjtGeom, size, pos, colour, **turned) -> None:
        body.add_geom(
            type=kind, size=size, pos=pos, rgba=colour, mass=0, group=GROUP, contype=0, conaffinity=0, **turned)

    cylinder, box = mujoco.mjtGeom.mjGEOM_CYLINDER, mujoco.mjtGeom.mjGEOM_BOX
    for side in (-1, 1):
        add(cylinder, (WHEEL_RADIUS, 0.01, 0), (0, side * WHEEL_SEPARATION / 2, WHEEL_RADIUS), _BLACK, quat=Z_TO_Y)
    for height in PLATES:
        add(cylinder, (PLATE_RADIUS, 0.004, 0), (PLATE_X, 0, height), _WOOD)
    low, high = PLATES[0], PLATES[-1]
    for angle in POLES:
        at = PLATE_X + 0.9 * PLATE_RADIUS * cos(angle), 0.9 * PLATE_RADIUS * sin(angle), (low + high) / 2
        add(cylinder, (POLE_RADIUS, (high - low) / 2, 0), at, _STEEL)
    x, _, z = xtion.mount
    add(box, (0.018, 0.09, 0.014), (x - 0.01, 0, z), _BLACK)
    add(box, (0.02, 0.03, (z - PLATES[1]) / 2), (x - 0.01, 0, (z + PLATES[1]) / 2), _BLACK)
