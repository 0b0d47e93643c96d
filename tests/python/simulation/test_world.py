# SPDX-License-Identifier: BSD-3-Clause
from math import pi

import pytest

from rooms import FLOOR, box, room, wall_at
from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.simulation.hull import Rectangle
from safety_control_cloud.simulation.robot import BODY_RADIUS
from safety_control_cloud.simulation.world import BOX_SIDE, World
from safety_control_cloud.simulation.world_files import world_file, world_names

MOVABLE = '<body name="cart" mocap="true" pos="3 0 0.5"><geom name="cart" type="box" size="0.2 0.2 0.5"/></body>'


def test_the_worlds_are_those_the_readme_names():
    assert world_names() == ("cabinet", "closed_cabinet", "hall", "playground", "posts")


@pytest.mark.parametrize("name", world_names())
def test_every_world_starts_with_the_robot_touching_nothing(name):
    world = World.load(name)
    assert world.contacts() == ()
    assert world.clearance() > 0.5


@pytest.mark.parametrize("name, front", [("cabinet", 2.5), ("closed_cabinet", 2.5), ("hall", 20.0)])
def test_the_robot_starts_with_the_front_straight_ahead(name, front):
    world = World.load(name)
    assert world.start == Pose()
    assert world.site("front")[:2] == (front, 0.0)


def test_in_the_playground_the_robot_is_turned_to_the_bookshelf_on_its_left():
    world = World.load("playground")
    assert world.start.yaw == pytest.approx(pi / 2)
    assert world.site("front")[:2] == (0.0, 1.135)


def test_a_users_own_mjcf_file_is_a_world(tmp_path):
    own = tmp_path / "kitchen.xml"
    own.write_text(f"<mujoco><worldbody>{FLOOR}{wall_at(1.0)}</worldbody></mujoco>")
    world = World.load(own)
    assert world.start == Pose()
    assert world.clearance(2.0) == pytest.approx(1.0 - BODY_RADIUS, abs=1e-6)


def test_an_unknown_world_is_refused_with_those_there_are():
    with pytest.raises(FileNotFoundError, match="cabinet, closed_cabinet, hall"):
        world_file("cabnet")


@pytest.mark.parametrize("x, touching", [(0.80, False), (0.83, True)])
def test_the_robot_touches_a_wall_when_its_round_body_reaches_it(x, touching):
    world = room(wall_at(1.0))
    world.place_robot(Pose(x))
    assert bool(world.contacts()) == touching
    assert (world.clearance() < 0) == touching


def test_a_contact_says_what_where_and_how_deep():
    world = room(wall_at(1.0))
    world.place_robot(Pose(0.83))
    contact = max(world.contacts(), key=lambda one: one.depth)
    assert contact.obstacle == "wall"
    assert contact.point[0] == pytest.approx(1.0, abs=0.02)
    assert contact.depth == pytest.approx(0.008, abs=0.0005)


def test_the_floor_is_no_obstacle():
    world = room()
    world.place_robot(Pose(), -0.0127)  # rocking as far back as it does
    assert world.contacts() == ()


def test_a_table_top_touches_the_tower_though_the_kobuki_fits_below():
    world = room('<geom name="table" type="box" pos="0.6 0 0.35" size="0.5 1 0.01"/>')
    world.place_robot(Pose())
    assert {contact.obstacle for contact in world.contacts()} == {"table"}


def test_a_movable_thing_moves_and_touches():
    world = room(MOVABLE)
    assert world.movable == ("cart",)
    assert world.clearance(5.0) == pytest.approx(3.0 - 0.2 - BODY_RADIUS, abs=1e-6)
    world.move("cart", Pose(0.37))
    assert [contact.obstacle for contact in world.contacts()]


def test_furniture_that_is_not_movable_is_refused():
    world = room('<body name="shelf"><geom type="box" size="1 1 1" pos="4 0 1"/></body>')
    with pytest.raises(ValueError, match="shelf cannot be moved"):
        world.move("shelf", Pose())


def test_a_dropped_box_stands_on_the_floor_where_it_was_dropped():
    world = room()
    world.drop_box(1.0, 0.0)
    assert world.clearance(2.0) == pytest.approx(1.0 - BOX_SIDE / 2 - BODY_RADIUS, abs=1e-6)
    world.clear_boxes()
    assert world.clearance(2.0) == 2.0


def test_a_ninth_box_takes_the_place_of_the_first():
    world = room()
    world.drop_box(0.5, 0.0)
    near = world.clearance(5.0)
    for _ in range(8):
        world.drop_box(4.0, 0.0)
    assert world.clearance(5.0) > near + 3


def test_worlds_from_text_may_use_the_scenery():
    thing = box("b", 2, 0, (0.1, 0.1, 0.1))
    world = World.from_xml(f'<mujoco><include file="_scenery.xml"/><worldbody>{thing}</worldbody></mujoco>')
    assert world.clearance(5.0) == pytest.approx(2 - 0.1 - BODY_RADIUS, abs=1e-6)


@pytest.mark.parametrize("x, y, touches", [(0.24, 0.0, True), (0.26, 0.0, False), (-0.33, 0.23, True), (-0.1, 0.26, False)])
def test_a_robot_with_another_hull_touches_things_with_that(x, y, touches):
    post = f'<geom name="post" type="cylinder" size="0.05 0.5" pos="{x} {y} 0.5"/>'
    world = World.from_xml(f"<mujoco><worldbody>{post}</worldbody></mujoco>", hull=Rectangle(-0.3, 0.2, 0.2))
    assert bool(world.contacts()) == touches
    assert (world.clearance() < 0) == touches


def test_a_contacts_normal_leads_from_the_robot_into_the_obstacle():
    for x, y in ((0.2, 0.0), (0.0, -0.2)):
        world = World.from_xml(f'<mujoco><worldbody><geom type="cylinder" size="0.05 0.5" pos="{x} {y} 0.5"/></worldbody></mujoco>')
        contact = world.contacts()[0]
        assert contact.normal == pytest.approx((x / 0.2, y / 0.2, 0.0), abs=0.02)
