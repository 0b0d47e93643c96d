# SPDX-License-Identifier: BSD-3-Clause
"""rviz's robot and MuJoCo's robot are one and the same, and both are the TurtleBot of the public descriptions."""
from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from rooms import room
from safety_control_cloud.simulation import hull, robot
from safety_control_cloud.simulation.base import WHEEL_RADIUS, WHEEL_SEPARATION
from safety_control_cloud.simulation.sensor import Xtion

URDF = ElementTree.parse(Path(__file__).parents[3] / "safety_control_cloud/urdf/turtlebot.urdf").getroot()


def numbers(text: str) -> tuple[float, ...]:
    return tuple(map(float, text.split()))


def joint_origin(child: str, what: str = "xyz") -> tuple[float, ...]:
    """[m] or [rad] of link `child` in its parent."""
    joint = next(joint for joint in URDF.iter("joint") if joint.find("child").get("link") == child)
    return numbers(joint.find("origin").get(what))


def test_rviz_shows_the_depth_camera_where_it_looks_from():
    above_footprint = np.add(joint_origin("base_link"), joint_origin("camera_depth_frame"))
    assert above_footprint == pytest.approx(Xtion().mount)
    assert joint_origin("camera_depth_optical_frame", "rpy") == pytest.approx((-np.pi / 2, 0, -np.pi / 2))


def test_both_robots_have_the_same_body():
    link = next(link for link in URDF.iter("link") if link.get("name") == "base_link")
    for part in (link.find("visual"), link.find("collision")):
        cylinder = part.find("geometry/cylinder")
        assert float(cylinder.get("radius")) == robot.BODY_RADIUS
        assert float(cylinder.get("length")) == robot.BODY_HEIGHT
        assert numbers(part.find("origin").get("xyz"))[2] + hull.BASE_LINK == pytest.approx(robot.BODY_CENTRE)
    assert joint_origin("base_link") == (0, 0, hull.BASE_LINK)


def test_both_robots_have_the_same_wheels_and_stand_on_them():
    for side, y in (("left", WHEEL_SEPARATION / 2), ("right", -WHEEL_SEPARATION / 2)):
        at = joint_origin(f"wheel_{side}_link")
        assert at[:2] == (0, y)
        assert at[2] + hull.BASE_LINK == pytest.approx(WHEEL_RADIUS)


def test_the_plates_of_both_robots_are_as_high():
    plates = [visual for visual in URDF.iter("visual")
              if (disc := visual.find("geometry/cylinder")) is not None
              and float(disc.get("radius")) == robot.PLATE_RADIUS]
    assert {numbers(plate.find("origin").get("xyz"))[:2] for plate in plates} == {(robot.PLATE_X, 0)}
    heights = [numbers(plate.find("origin").get("xyz"))[2] for plate in plates]
    assert np.add(heights, hull.BASE_LINK) == pytest.approx(robot.PLATES)


def test_the_robot_has_the_kobukis_hull():
    model = room().model
    kobuki = model.geom(robot.PREFIX + "kobuki")
    assert kobuki.size[:2] == pytest.approx((0.178, 0.109 / 2))
    assert model.body(robot.BODY).mass[0] == pytest.approx(2.4 + 1.0)


def test_the_poles_of_both_robots_stand_in_the_same_places_out_of_the_xtions_view():
    poles = [numbers(visual.find("origin").get("xyz")) for visual in URDF.iter("visual")
             if (rod := visual.find("geometry/cylinder")) is not None
             and float(rod.get("radius")) == robot.POLE_RADIUS]
    radius = 0.9 * robot.PLATE_RADIUS
    places = [(robot.PLATE_X + radius * np.cos(angle), radius * np.sin(angle)) for angle in robot.POLES]
    assert np.array(poles)[:, :2] == pytest.approx(np.array(places), abs=1e-4)
    camera = Xtion().mount
    for x, y in places:
        assert abs(np.arctan2(y - camera[1], x - camera[0])) > Xtion().horizontal_view / 2 + np.radians(3)


def test_the_plates_of_both_robots_lie_out_of_the_xtions_view():
    camera, edge = Xtion().mount, robot.PLATE_X + robot.PLATE_RADIUS
    for height in robot.PLATES:
        assert abs(np.arctan2(height - camera[2], edge - camera[0])) > Xtion().vertical_view / 2 + np.radians(1)
