# SPDX-License-Identifier: BSD-3-Clause
"""Clouds that are well-formed and show nothing, or too little, or the same for ever."""
import numpy as np
import pytest
from robot import AGAIN, GRACE, ONE_CLOUD, SANITIZED
from scenes import HEIGHT, WIDTH, always, cloud_of, hall, hall_with, kerb, pixels_of, points_of, post, wall

NOWHERE = np.full((HEIGHT, WIDTH, 3), np.nan, np.float32)
LATE = GRACE if SANITIZED else 0.0  # [s] by which a sanitizer's node may be with clouds of 20 MB, beside other work


@pytest.mark.parametrize(
    "cloud",
    [
        pytest.param(cloud_of(NOWHERE), id="all_nan"),
        pytest.param(cloud_of(NOWHERE, is_dense=True), id="all_nan_and_claims_to_be_dense"),
        pytest.param(cloud_of(NOWHERE[:0]), id="no_rows"),
        pytest.param(cloud_of(np.zeros((0, 3), np.float32)), id="no_points"),
        pytest.param(cloud_of(np.zeros_like(NOWHERE)), id="zeros"),
        pytest.param(cloud_of(np.full_like(NOWHERE, np.inf)), id="all_infinite"),
        pytest.param(cloud_of(np.where(np.arange(HEIGHT)[:, None, None] < 118, np.nan, points_of())), id="a_strip"),
    ],
)
def test_a_camera_without_returns_is_blind(robot, cloud):
    robot.camera.show(always(cloud))
    robot.stops("BLIND")
    robot.camera.show(hall())
    robot.drives()


def test_an_obstacle_stops_the_robot_and_lets_it_go(robot):
    robot.camera.show(hall(wall(0.45)))
    assert abs(robot.stops("SEEN").nearest - 0.45) < 0.01
    robot.camera.show(hall())
    robot.drives()


def test_a_kerb_lower_than_the_corridor_slows_the_robot_and_stops_it(robot):
    robot.camera.show(hall(kerb(0.72)))
    assert abs(robot.slows("LOW_OBSTACLE").nearest - 0.72) < 0.01
    robot.camera.show(hall(kerb(0.62)))
    assert abs(robot.stops("LOW_OBSTACLE").nearest - 0.62) < 0.01
    robot.camera.show(hall())
    robot.drives()


@pytest.mark.parametrize("zoom", [1, 2, 4, 8])
def test_a_low_kerb_is_seen_at_any_resolution(robot, zoom):
    robot.camera.show(always(cloud_of(points_of(kerb(0.72, height=0.035), width=zoom * WIDTH, height=zoom * HEIGHT))))
    robot.slows("LOW_OBSTACLE", within=ONE_CLOUD + LATE)
    robot.camera.show(hall())
    robot.drives(within=AGAIN + LATE)


def test_a_near_obstacle_that_becomes_a_hole_of_nan_is_still_there(robot):
    robot.camera.show(hall(post(0.6)))
    robot.drives(0.1)
    robot.camera.show(hall_with(np.nan, pixels_of(post(0.6)), post(0.6)))
    robot.stops("NEAR_LOSS")
    robot.camera.show(hall())
    robot.drives()


def test_a_near_obstacle_that_becomes_a_hole_of_minus_infinity_is_too_close(robot):
    robot.camera.show(hall(post(0.6)))
    robot.drives(0.1)
    robot.camera.show(hall_with(-np.inf, pixels_of(post(0.6)), post(0.6)))
    assert robot.stops("SEEN").nearest == 0.0
    robot.camera.show(hall())
    robot.drives()


def test_a_post_that_slides_into_the_blind_zone_is_still_there(robot):
    for distance in (0.7, 0.6, 0.55):
        robot.camera.show(hall(post(distance)))
        robot.drives(0.1)
    robot.camera.show(hall(post(0.35)))  # returns nothing, and hides the floor
    robot.stops("NEAR_LOSS")
    robot.camera.show(hall())
    robot.drives()


def test_one_noise_point_is_an_obstacle_as_the_tutorial_has_it(robot):
    noise = hall()
    noise_at(noise, 0.45)
    robot.camera.show(noise)
    robot.stops("SEEN")
    robot.camera.show(hall())
    robot.drives()


@pytest.mark.with_parameters(min_points=5)
def test_one_noise_point_is_none_where_five_make_an_obstacle(robot):
    noise = hall()
    noise_at(noise, 0.45)
    robot.camera.show(noise)
    robot.drives()
    robot.camera.show(hall(post(0.45)))
    robot.stops("SEEN")


def noise_at(view, distance):
    for cloud in view:
        points = np.frombuffer(cloud.data, np.float32).reshape(HEIGHT, WIDTH, -1).copy()
        points[HEIGHT // 2, WIDTH // 2, :3] = 0.0, 0.0, distance
        cloud.data = points.tobytes()


@pytest.mark.with_parameters(frozen_clouds=5)
def test_a_camera_that_repeats_its_cloud_for_ever_is_frozen(robot):
    robot.camera.show(hall()[:1])
    robot.stops("FROZEN", within=0.6)  # five clouds
    robot.camera.show(hall())
    robot.drives()
