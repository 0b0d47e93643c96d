# SPDX-License-Identifier: BSD-3-Clause
"""The depth camera against walls whose distance can be computed by hand."""
from math import atan, cos, degrees, pi, radians, sin, tan

import numpy as np
import pytest

from rooms import box, room, wall_at
from safety_control_cloud.simulation.base import RESTING_PITCH, Pose
from safety_control_cloud.simulation.camera import Camera
from safety_control_cloud.simulation.sensor import Xtion, points, rays
from safety_control_cloud.simulation.world import World

MOUNT = Xtion().mount
SIZES = [Xtion(), Xtion(width=320, height=240)]
ABOVE_FLOOR = slice(0, 10)  # rows


def seen(world, pose=Pose(), pitch=0.0, seed=None):
    world.place_robot(pose, pitch)
    camera = Camera(world)
    try:
        return camera.depth(None if seed is None else np.random.default_rng(seed))
    finally:
        camera.close()


@pytest.mark.parametrize("xtion", SIZES, ids=["VGA", "QVGA"])
@pytest.mark.parametrize("front", [0.35, 0.5, 1.0, 1.887, 3.3, 4.8])
def test_a_wall_ahead_is_seen_at_its_distance_within_1_mm(front, xtion):
    depth = seen(room(wall_at(front), xtion=xtion))
    assert abs(depth[: xtion.height // 2] - (front - MOUNT[0])).max() < 0.001


def test_a_wall_seen_askew_is_flat_within_1_mm():
    yaw, front = radians(30), 2.0
    xtion = Xtion()
    depth = seen(room(wall_at(front)), Pose(0, 0, yaw))
    eye_x = MOUNT[0] * cos(yaw) - MOUNT[1] * sin(yaw)
    across, _ = rays(xtion)
    along_x = cos(yaw) + sin(yaw) * across  # of the ray of depth 1, in odom's x
    expected = (front - eye_x) / along_x
    visible = expected < 4.9
    assert abs(depth[ABOVE_FLOOR] - expected)[:, visible].max() < 0.001


def test_a_round_post_is_as_near_as_it_stands_within_1_mm():
    radius, x = 0.5, 2.0
    post = f'<geom type="cylinder" size="{radius} 1" pos="{x} {MOUNT[1]} 1"/>'
    depth = seen(room(post))
    assert np.nanmin(depth[:240]) == pytest.approx(x - radius - MOUNT[0], abs=0.001)


def test_the_floor_lies_0_297_m_below_the_camera_and_begins_0_686_m_ahead():
    depth = seen(room())
    height = points(depth, Xtion())[..., 1]
    assert abs(height[np.isfinite(depth)] - MOUNT[2]).max() < 0.001
    assert np.nanmin(depth) == pytest.approx(0.686, abs=0.002)


def test_the_resting_robot_sees_the_floor_8_mm_lower_per_metre():
    depth = seen(room(), pitch=RESTING_PITCH)
    column = points(depth, Xtion())[:, 320]
    column = column[np.isfinite(column[:, 2])]
    slope, _ = np.polyfit(column[:, 2], column[:, 1], 1)
    assert 1000 * slope == pytest.approx(8.0, abs=0.1)


def test_a_wall_on_the_left_is_on_the_left_of_the_picture():
    depth = seen(room(box("left", 2, 1.0, (0.1, 0.5, 1))))
    returns = np.isfinite(depth[: 240])
    assert returns[:, :320].any() and not returns[:, 320:].any()


def test_turning_left_moves_what_is_ahead_to_the_right():
    depth = seen(room(box("ahead", 3, 0, (0.1, 0.2, 1))), Pose(0, 0, radians(15)))
    columns = np.flatnonzero(np.isfinite(depth[100]))
    assert columns.min() > 400


@pytest.mark.parametrize("front, returns", [(0.25, False), (0.32, True), (4.88, True), (4.95, False)])
def test_the_sensor_returns_nothing_nearer_than_0_4_and_farther_than_5_m(front, returns):
    depth = seen(room(wall_at(front)))
    assert np.isfinite(depth[ABOVE_FLOOR]).all() == returns
    assert np.isfinite(depth[ABOVE_FLOOR]).any() == returns


@pytest.mark.parametrize("distance, millimetres_off", [(1.0, 1.7), (2.0, 6.7), (3.0, 14.9)])
def test_a_wall_is_measured_with_the_xtions_noise(distance, millimetres_off):
    depth = seen(room(wall_at(distance + MOUNT[0])), seed=3)
    assert 1000 * np.std(depth[:100]) == pytest.approx(millimetres_off, abs=0.15)


def test_the_view_is_60_degrees_wide():
    xtion = Xtion()
    across, _ = rays(xtion)
    assert degrees(2 * atan(across[-1] * xtion.width / (xtion.width - 1))) == pytest.approx(60.0, abs=0.01)
    half_width = 2.0 * tan(pi / 6)
    just_inside = box("edge", 2.0 + MOUNT[0] + 0.05, MOUNT[1] + half_width, (0.05, 0.01, 2))
    assert np.isfinite(seen(room(just_inside))[0, :10]).any()


def test_the_robot_sees_nothing_of_itself():
    depth = seen(room(wall_at(4.0)))
    assert np.isfinite(depth).all()  # a plate or a pole would be too near to return
    assert depth.min() > 0.6


def test_the_colour_camera_sees_farther_than_the_depth_is_measured():
    world = room('<geom type="box" size="0.1 5 5" pos="12 0 5" rgba="1 0 0 1"/>')
    camera = Camera(world)
    seen = camera.picture()
    camera.close()
    colour, depth = seen.colour, seen.depth
    assert not np.isfinite(depth[200]).any()
    red, _, blue = colour[200, 320].astype(int)
    assert red > 50 and red > 2 * blue


@pytest.mark.parametrize("name", ["cabinet", "hall"])
def test_a_picture_is_the_depth_and_the_colour_that_are_taken_one_by_one(name):
    camera = Camera(World.load(name))
    seen = camera.picture(np.random.default_rng(5))
    depth, colour = camera.depth(np.random.default_rng(5)), camera.colour()
    camera.close()
    assert np.array_equal(seen.depth, depth, equal_nan=True)
    assert np.array_equal(seen.colour, colour)


def test_wherever_somebody_drives_the_floor_reaches_the_horizon():
    world = World.load("hall")
    world.place_robot(Pose(130, -130, radians(-45)))  # looks away from the middle of the world
    camera = Camera(world)
    seen = camera.picture()
    camera.close()
    below_the_horizon = seen.colour[245:].astype(int)
    red, blue = below_the_horizon[..., 0], below_the_horizon[..., 2]
    assert (red > blue).all()  # the sky is blue
