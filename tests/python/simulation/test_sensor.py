# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
import pytest

from safety_control_cloud.simulation.sensor import (
    POINT, Xtion, fill_cloud, fill_colour, millimetres, new_cloud, noisy, points, returned, with_strays,
)

SMALL = Xtion(width=4, height=2)


def test_the_sensor_has_the_xtions_lens():
    xtion = Xtion()
    assert xtion.focal == pytest.approx(554.26, abs=0.005)
    assert xtion.centre == (319.5, 239.5)


@pytest.mark.parametrize("distance, millimetres_off", [(1.0, 1.7), (2.0, 6.7), (3.0, 14.9)])
def test_the_depth_scatters_as_a_disparity_sensors_does(distance, millimetres_off):
    depth = np.full((480, 640), distance, np.float32)
    off = noisy(depth, np.random.default_rng(1)) - distance
    assert 1000 * off.std() == pytest.approx(millimetres_off, abs=0.15)
    assert abs(1000 * off.mean()) < 0.2 * millimetres_off


def test_the_same_seed_scatters_the_same_way():
    depth = np.full((48, 64), 2.0, np.float32)
    first, again, other = (noisy(depth, np.random.default_rng(seed)) for seed in (7, 7, 8))
    assert (first == again).all() and (first != other).any()


def test_nothing_is_returned_at_or_below_0_4_m_and_at_or_beyond_5_m():
    depth = np.array([[0.39, 0.4, 0.401, 1.0], [4.999, 5.0, 5.1, 8.0]], np.float32)
    seen = np.isfinite(returned(depth, SMALL))
    assert seen.tolist() == [[False, False, True, True], [True, False, False, False]]


def test_a_cloud_is_laid_out_as_the_driver_does():
    assert POINT.itemsize == 32
    assert {name: POINT.fields[name][1] for name in POINT.names} == {"x": 0, "y": 4, "z": 8, "rgb": 16}


def test_a_pixel_without_return_is_nan_in_all_three_coordinates():
    depth = np.array([[1, np.nan, 1, 1], [1, 1, 1, 1]], np.float32)
    cloud = new_cloud(SMALL)
    fill_cloud(cloud, depth, SMALL)
    assert np.isnan([cloud[0, 1][axis] for axis in "xyz"]).all()
    assert np.isfinite(cloud["z"]).sum() == 7


def test_the_filled_cloud_and_the_points_are_the_same():
    depth = np.random.default_rng(0).uniform(0.5, 4, (480, 640)).astype(np.float32)
    cloud = new_cloud(Xtion())
    fill_cloud(cloud, depth, Xtion())
    assert (np.stack([cloud[axis] for axis in "xyz"], axis=-1) == points(depth, Xtion())).all()


def test_colour_is_packed_as_pcl_does():
    colour = np.zeros((2, 4, 3), np.uint8)
    colour[1, 2] = (0x12, 0x34, 0x56)
    cloud = new_cloud(SMALL)
    fill_colour(cloud, colour)
    assert cloud["rgb"].view(np.uint32)[1, 2] == 0x123456


def test_a_depth_image_in_millimetres_has_0_where_nothing_returned():
    assert millimetres(np.array([[1.2345, np.nan]], np.float32)).tolist() == [[1234, 0]]


def test_a_share_of_what_is_too_near_returns_any_depth_in_the_range_and_the_rest_is_as_measured():
    sensor = Xtion(stray=0.1)
    depth = np.full((200, 300), 0.2, np.float32)
    depth[:, 150:] = 1.0
    depth[:50] = 7.0
    measured = np.where(depth == 1.0, depth, np.float32(np.nan))

    marred = with_strays(measured, depth, sensor, np.random.default_rng(1))

    near = depth < 0.4
    np.testing.assert_array_equal(marred[~near], measured[~near])
    stray = marred[near & np.isfinite(marred)]
    assert 0.09 < len(stray) / near.sum() < 0.11 and stray.min() > 0.4 and stray.max() < 5.0 and np.ptp(stray) > 4.5
    assert np.isfinite(with_strays(measured, depth, sensor, np.random.default_rng(2))).sum() > 0
