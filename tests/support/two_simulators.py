# SPDX-License-Identifier: BSD-3-Clause
"""The shapes of a world as Gazebo and as MuJoCo have them: name: (kind, full lengths in x, y, z, corner and centre in the world)."""
from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest

from safety_control_cloud.simulation import robot
from safety_control_cloud.simulation.gl import mujoco
from safety_control_cloud.simulation.world import World

KINDS = {mujoco.mjtGeom.mjGEOM_BOX: "box", mujoco.mjtGeom.mjGEOM_CYLINDER: "cylinder", mujoco.mjtGeom.mjGEOM_PLANE: "plane"}


def numbers(text: str) -> tuple[float, ...]:
    return tuple(map(float, text.split()))


def turned(place, x, y):
    """The point (x, y) of a place's frame, in the frame of the place; a place is (x, y, z, yaw)."""
    c, s = np.cos(place[3]), np.sin(place[3])
    return place[0] + c * x - s * y, place[1] + s * x + c * y


def shapes_in_gazebo(sdf: str, tag: str) -> dict:
    """Of every collision or visual."""
    shapes = {}
    for model in ElementTree.fromstring(sdf).iter("model"):
        outer = numbers(model.find("pose").text)
        for part in model.iter(tag):
            inner = numbers(part.find("pose").text)
            assert outer[3:5] == inner[3:5] == (0, 0)
            form = part.find("geometry")[0]
            if form.tag == "cylinder":
                radius = float(form.find("radius").text)
                size = (2 * radius, 2 * radius, float(form.find("length").text))
            else:
                size = numbers(form.find("size").text)
            place = (*turned((*outer[:3], outer[5]), *inner[:2]), outer[2] + inner[2], outer[5] + inner[5])
            shapes[part.get("name")] = (form.tag, size, place)
    return shapes


def shapes_in_mujoco(world: World) -> dict:
    """Of every geom but the robot's and the boxes that can be dropped."""
    shapes = {}
    for geom in range(world.model.ngeom):
        body = world.model.body(world.model.geom_bodyid[geom]).name
        if body == robot.BODY or body.startswith("dropped_box"):
            continue
        kind = KINDS[mujoco.mjtGeom(world.model.geom_type[geom])]
        size = 2 * world.model.geom_size[geom]
        size = {"box": size, "plane": size[:2], "cylinder": (size[0], size[0], size[1])}[kind]
        turn = world.data.geom_xmat[geom].reshape(3, 3)
        assert turn[2, 2] == pytest.approx(1)
        place = (*world.data.geom_xpos[geom], np.arctan2(turn[1, 0], turn[0, 0]))
        shapes[world.model.geom(geom).name] = (kind, tuple(size), place)
    return shapes


def assert_same_shapes(gazebos: dict, mujocos: dict) -> None:
    assert set(gazebos) == set(mujocos)
    for shape, (kind, size, place) in mujocos.items():
        assert gazebos[shape][0] == kind
        assert gazebos[shape][1] == pytest.approx(size, abs=1e-6)
        assert gazebos[shape][2] == pytest.approx(place, abs=1e-6)
