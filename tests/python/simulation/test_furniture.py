# SPDX-License-Identifier: BSD-3-Clause
from math import pi

import pytest

from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.simulation.furniture import GREY, Place, furniture_of

BOX = '<geom name="box" type="box" size="0.1 0.2 0.3"/>'


@pytest.fixture
def furniture(tmp_path):
    def read(worldbody: str, rest: str = ""):
        file = tmp_path / "world.xml"
        file.write_text(f"<mujoco>{rest}<worldbody>{worldbody}</worldbody></mujoco>")
        return furniture_of(file)

    return read


def test_angles_are_degrees_unless_the_file_says_radian(furniture):
    turned = BOX.replace("<geom", '<geom euler="0 0 90"')
    assert furniture(turned).things[0].shapes[0].place.yaw == pytest.approx(pi / 2)
    in_radians = furniture(turned, '<compiler angle="radian"/>')
    assert in_radians.things[0].shapes[0].place.yaw == pytest.approx(90)


def test_what_stands_in_a_body_in_a_body_stands_where_both_lead(furniture):
    body = f'<body name="table" pos="1 0 0" euler="0 0 90"><body pos="2 0 0.5" euler="0 0 90">{BOX}</body></body>'
    (thing,) = furniture(body).things
    (shape,) = thing.shapes
    place = thing.place.of(shape.place)
    assert (place.x, place.y, place.z, place.yaw) == pytest.approx((1, 2, 0.5, pi))


def test_a_colour_is_the_geoms_own_or_its_materials(furniture):
    material = '<asset><material name="red" rgba="1 0 0 1"/></asset>'
    own = BOX.replace("/>", ' rgba="0 1 0 1" material="red"/>')
    by_material = BOX.replace("/>", ' material="red"/>')
    colours = [thing.shapes[0].colour for thing in furniture(own + by_material + BOX, material).things]
    assert colours == [(0, 1, 0, 1), (1, 0, 0, 1), GREY]


def test_without_a_start_the_robot_stands_at_the_origin(furniture):
    assert furniture(BOX).start == Pose()
    assert furniture('<site name="start" pos="1 2 0"/>').start == Pose(1, 2, 0)


@pytest.mark.parametrize(
    "worldbody, rest, reason",
    [
        ('<geom name="ball" type="sphere" size="0.1"/>', "", "ball: only a box, a cylinder or a plane"),
        ('<geom name="ball" size="0.1"/>', "", "not a sphere"),
        ('<geom name="post" type="cylinder" size="0.1" fromto="0 0 0 0 0 1"/>', "", "post: only a box"),
        ('<geom name="rod" type="cylinder" size="0.1 1" quat="1 0 1 0"/>', "", "rod: only what stands upright"),
        (BOX.replace("<geom", '<geom euler="0 10 0"'), "", "box: only what stands upright"),
        (BOX, "<default><geom/></default>", "<default> is not understood"),
    ],
)
def test_what_is_not_understood_is_refused_and_not_passed_over(furniture, worldbody, rest, reason):
    with pytest.raises(ValueError, match=reason):
        furniture(worldbody, rest)


def test_a_place_in_a_place_turns_with_it():
    assert Place(1, 1, 0, pi / 2).of(Place(1, 0)) == Place(pytest.approx(1), 2, 0, pi / 2)
