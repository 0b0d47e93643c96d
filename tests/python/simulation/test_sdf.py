# SPDX-License-Identifier: BSD-3-Clause
"""Gazebo's worlds have the shapes of MuJoCo's, which compiles the same files by itself."""
from __future__ import annotations

from math import pi
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from safety_control_cloud.simulation import robot
from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.simulation.furniture import Place, Shape, Thing, furniture_of
from safety_control_cloud.simulation.gl import mujoco
from safety_control_cloud.simulation.sdf import to_model, to_world, write_world
from safety_control_cloud.simulation.world import World
from safety_control_cloud.simulation.world_files import world_file, world_names

URDF = Path(__file__).parents[3] / "safety_control_cloud/urdf/turtlebot.urdf"
KINDS = {mujoco.mjtGeom.mjGEOM_BOX: "box", mujoco.mjtGeom.mjGEOM_CYLINDER: "cylinder", mujoco.mjtGeom.mjGEOM_PLANE: "plane"}


def numbers(text: str) -> tuple[float, ...]:
    return tuple(map(float, text.split()))


def turned(place, x, y):
    """The point (x, y) of a place's frame, in the frame of the place; a place is (x, y, z, yaw)."""
    c, s = np.cos(place[3]), np.sin(place[3])
    return place[0] + c * x - s * y, place[1] + s * x + c * y


def gazebos_shapes(sdf: str, tag: str) -> dict:
    """name: (kind, full lengths in x, y, z, corner and centre in the world) of every collision or visual."""
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


def mujocos_shapes(name: str) -> dict:
    world, shapes = World.load(name), {}
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


@pytest.mark.parametrize("tag", ["collision", "visual"])
@pytest.mark.parametrize("name", world_names())
def test_gazebos_world_has_the_shapes_of_mujocos(name, tag):
    ours = gazebos_shapes(to_world(furniture_of(world_file(name)), "file:///robot"), tag)
    theirs = mujocos_shapes(name)
    assert set(ours) == set(theirs)
    for shape, (kind, size, place) in theirs.items():
        assert ours[shape][0] == kind
        assert ours[shape][1] == pytest.approx(size, abs=1e-6)
        assert ours[shape][2] == pytest.approx(place, abs=1e-6)


@pytest.mark.parametrize("name", world_names())
def test_gazebos_robot_starts_where_mujocos_does(name):
    include = ElementTree.fromstring(to_world(furniture_of(world_file(name)), "file:///robot")).find("world/include")
    x, y, z, roll, pitch, yaw = numbers(include.find("pose").text)
    start = World.load(name).start
    assert (x, y, yaw) == pytest.approx((start.x, start.y, start.yaw))
    assert (z, roll, pitch) == (0, 0, 0)


def test_a_thing_of_many_shapes_is_one_static_model_that_can_be_moved_as_a_whole():
    board = Shape("board", "box", (0.5, 0.1, 0.01), Place(0.2, 0, 0.4), (1, 0, 0, 1))
    model = to_model(Thing("shelf", Place(1, 2, 0, pi / 2), (board, board)))
    assert model.get("name") == "shelf" and model.find("static").text == "true"
    assert numbers(model.find("pose").text) == pytest.approx((1, 2, 0, 0, 0, pi / 2))
    assert len(model.findall("link")) == 1 and len(model.findall("link/collision")) == 2
    assert model.find("link/visual/material/diffuse").text == "1 0 0 1"


def test_the_robot_is_written_beside_the_world_with_pictures_of_the_size_asked_for(tmp_path):
    furniture = furniture_of(world_file("hall"))
    world = write_world(furniture, URDF, (320, 240), 0.5, tmp_path)
    root = ElementTree.parse(world).getroot()
    assert float(root.find("world/physics/real_time_update_rate").text) == pytest.approx(500)
    robot_folder = Path(root.find("world/include/uri").text[len("file://"):])
    named = ElementTree.parse(robot_folder / "model.config").find("sdf").text
    image = next(ElementTree.parse(robot_folder / named).iter("image"))
    assert (image.find("width").text, image.find("height").text) == ("320", "240")
    assert furniture.start == Pose()
