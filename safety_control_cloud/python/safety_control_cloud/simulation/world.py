# SPDX-License-Identifier: BSD-3-Clause
"""A world in MuJoCo: an MJCF file's furniture, things that can be moved, and the TurtleBot among them."""
from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, sin
from pathlib import Path

import numpy as np

from . import robot
from .base import Pose
from .furniture import BOX_COLOUR, BOX_SIDE, BOXES
from .gl import mujoco
from .hull import Rectangle
from .mjcf import NATIVE_CCD, spec_of_file, spec_of_text
from .sensor import Xtion
from .world_files import START, world_file

_OUT_OF_SIGHT = -10.0  # [m] below the floor
_CAN_COLLIDE = 1


@dataclass(frozen=True)
class Contact:
    obstacle: str  # name of the geom, or of its body
    point: tuple[float, float, float]  # [m] in odom
    depth: float  # [m] how far the two overlap
    normal: tuple[float, float, float] = (0.0, 0.0, 0.0)  # of length 1, from the robot into the obstacle


class World:
    """Everything stands where it was last put: nothing falls or is pushed away. Takes the MjSpec over."""

    def __init__(self, spec: mujoco.MjSpec, xtion: Xtion = Xtion(), hull: Rectangle | None = None) -> None:
        self.xtion = xtion
        robot.add_turtlebot(spec, xtion, hull)
        self._boxes = [_add_box(spec, place) for place in range(BOXES)]
        self._dropped = 0
        self.model = spec.compile()
        self.model.opt.enableflags |= NATIVE_CCD
        _prepare_for_sensor(self.model, xtion)
        self.data = mujoco.MjData(self.model)
        self._joints = [self.model.joint(name).qposadr[0] for name in robot.JOINTS]
        self._body = self.model.body(robot.BODY).id
        self._hull = frozenset(
            geom for geom in range(self.model.ngeom)
            if self.model.geom_bodyid[geom] == self._body and self.model.geom_contype[geom]
        )
        self._obstacles = self._other_solid_geoms()
        self.start = self._start()
        self.place_robot(self.start)

    @classmethod
    def load(cls, name: str | Path = "cabinet", xtion: Xtion = Xtion()) -> World:
        """One of `world_names()`, or an MJCF file of the user's own."""
        return cls(spec_of_file(world_file(name)), xtion)

    @classmethod
    def from_xml(cls, text: str, xtion: Xtion = Xtion(), hull: Rectangle | None = None) -> World:
        """From MJCF in a string; it may include the worlds' own files, such as `_scenery.xml`."""
        return cls(spec_of_text(text), xtion, hull)

    def place_robot(self, pose: Pose, pitch: float = 0.0) -> None:
        self.data.qpos[self._joints] = (pose.x, pose.y, pose.yaw, pitch)
        self._update()

    def contacts(self) -> tuple[Contact, ...]:
        """Between the robot's hull and anything else but the floor, which the hull does not reach."""
        if not self.data.ncon:
            return ()  # slicing MuJoCo's contacts takes longer than finding them, also where there are none
        found = []
        for contact in self.data.contact[: self.data.ncon]:
            ours = self._hull.intersection(contact.geom)
            if ours and contact.dist < 0:
                away = -1.0 if contact.geom[1] in ours else 1.0  # MuJoCo's normal leads from the first geom to the second
                other = int(contact.geom[0] if contact.geom[1] in ours else contact.geom[1])
                found.append(Contact(self._name(other), tuple(map(float, contact.pos)), -float(contact.dist),
                                     tuple(away * float(side) for side in contact.frame[:3])))
        return tuple(found)

    def clearance(self, farthest: float = 1.0) -> float:
        """[m] from the robot's hull to the nearest obstacle; at most `farthest`, below 0 when they overlap."""
        return min(
            (mujoco.mj_geomDistance(self.model, self.data, ours, other, farthest, None)
             for ours in self._hull for other in self._obstacles),
            default=farthest,
        )

    @property
    def movable(self) -> tuple[str, ...]:
        """Names of the bodies that `move` can move: those with mocap="true" in the MJCF."""
        names = (self.model.body(body).name for body in range(self.model.nbody) if self.model.body_mocapid[body] >= 0)
        return tuple(name for name in names if name not in self._boxes)

    def move(self, name: str, pose: Pose, height: float | None = None) -> None:
        """Stand the movable `name` at `pose`; its origin stays as high as it was, or goes to `height` [m]."""
        place = self.model.body(name).mocapid[0]
        if place < 0:
            raise ValueError(f'{name} cannot be moved: its body needs mocap="true"')
        z = self.data.mocap_pos[place, 2] if height is None else height
        self.data.mocap_pos[place] = (pose.x, pose.y, z)
        self.data.mocap_quat[place] = (cos(pose.yaw / 2), 0, 0, sin(pose.yaw / 2))
        self._update()

    def drop_box(self, x: float, y: float) -> None:
        """Stand a box of BOX_SIDE on the floor, its centre above (x, y) [m]."""
        self.move(self._boxes[self._dropped % BOXES], Pose(x, y), BOX_SIDE / 2)
        self._dropped += 1

    def clear_boxes(self) -> None:
        for name in self._boxes:
            self.move(name, Pose(), _OUT_OF_SIGHT)
        self._dropped = 0

    def site(self, name: str) -> tuple[float, float, float]:
        """[m] in odom: a place that the MJCF marks, such as a cabinet's `front`. Raises KeyError."""
        return tuple(map(float, self.data.site(name).xpos))

    def _update(self) -> None:
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        mujoco.mj_camlight(self.model, self.data)
        mujoco.mj_collision(self.model, self.data)

    def _start(self) -> Pose:
        self._update()
        if mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_SITE, START) < 0:
            return Pose()
        site = self.data.site(START)
        return Pose(float(site.xpos[0]), float(site.xpos[1]), atan2(site.xmat[3], site.xmat[0]))

    def _other_solid_geoms(self) -> tuple[int, ...]:
        solid = (self.model.geom_contype | self.model.geom_conaffinity) & _CAN_COLLIDE
        plane = self.model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE
        ours = self.model.geom_bodyid == self._body
        return tuple(int(geom) for geom in np.flatnonzero((solid != 0) & ~plane & ~ours))

    def _name(self, geom: int) -> str:
        return self.model.geom(geom).name or self.model.body(self.model.geom_bodyid[geom]).name


def _prepare_for_sensor(model: mujoco.MjModel, xtion: Xtion) -> None:
    """What the file says of lengths and buffers gives way to what the sensor needs."""
    model.stat.extent = 1.0  # near and far are multiples of it
    model.vis.map.znear, model.vis.map.zfar = xtion.clip
    model.vis.global_.offwidth = max(xtion.width, model.vis.global_.offwidth)
    model.vis.global_.offheight = max(xtion.height, model.vis.global_.offheight)
    model.vis.quality.offsamples = 0  # smoothed edges would be depths at which there is nothing
    model.vis.quality.numslices = 128  # else a cylinder's flats lie up to 11 mm inside it


def _add_box(spec: mujoco.MjSpec, place: int) -> str:
    name = f"dropped_box_{place}"
    body = spec.worldbody.add_body(name=name, mocap=True, pos=(0, 0, _OUT_OF_SIGHT))
    half = BOX_SIDE / 2
    body.add_geom(name=name, type=mujoco.mjtGeom.mjGEOM_BOX, size=(half, half, half), rgba=BOX_COLOUR)
    return name
