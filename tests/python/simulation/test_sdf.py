# SPDX-License-Identifier: BSD-3-Clause
"""Gazebo's worlds have the shapes of MuJoCo's, which compiles the same files by itself."""
from __future__ import annotations

from math import pi
from pathlib import Path
from xml.etree import ElementTree

import pytest
from two_simulators import assert_same_shapes, numbers, shapes_in_gazebo, shapes_in_mujoco

from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.simulation.furniture import Place, Shape, Thing, furniture_of
from safety_control_cloud.simulation.sdf import to_model, to_world, write_world
from safety_control_cloud.simulation.world import World
from safety_control_cloud.simulation.world_files import world_file, world_names

URDF = Path(__file__).parents[3] / "safety_control_cloud/urdf/turtlebot.urdf"


@pytest.mark.parametrize("tag", ["collision", "visual"])
@pytest.mark.parametrize("name", world_names())
def test_gazebos_world_has_the_shapes_of_mujocos(name, tag):
    gazebos = shapes_in_gazebo(to_world(furniture_of(world_file(name)), "file:///robot"), tag)
    assert_same_shapes(gazebos, shapes_in_mujoco(World.load(name)))


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
