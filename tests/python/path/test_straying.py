# SPDX-License-Identifier: BSD-3-Clause
"""How far a base leaves the path it is judged on == a base driven in small steps, at most."""
import numpy as np
import pytest

from base import Base
from safety_control_cloud import core
from shapes import random_shape, random_twist
from ways import RESOLUTION, body_points, corners_in_world, drive, poses_on_path

def strayed(shape, law, under_way, wanted, factor, brakes_after):
    """[m] how far some moment of a drive lies from the nearest moment of the path."""
    share, widening = core.straying(shape.footprint(), law, under_way, wanted, factor, factor)
    most = max(factor, share)
    braking = max(np.hypot(*wanted[:2]) / law.linear_deceleration, abs(wanted[2]) / law.angular_deceleration)
    reaction = law.sensor_period + law.latency + law.base_reaction
    corners = body_points(shape)
    path = corners_in_world(poses_on_path(wanted, most * reaction + most**2 * braking / 2), corners)
    driven = corners_in_world(drive(Base(law, twist=under_way), core.limited(wanted, factor), brakes_after), corners)
    apart = [np.hypot(*(path - now).transpose(2, 0, 1)).max(axis=1).min() for now in driven[::5]]
    return max(apart), widening


def test_a_base_whose_axes_obey_each_at_a_rate_of_its_own_strays_no_farther_than_the_bound():
    random = np.random.default_rng(5)
    ratios = []
    for number in range(300):
        law = core.Law(
            linear_deceleration=random.uniform(0.2, 2), angular_deceleration=random.uniform(0.5, 4),
            sensor_period=random.uniform(0, 0.3), latency=random.uniform(0, 0.1),
        )  # fmt: skip
        shape, wanted, before = random_shape(random), random_twist(random), random_twist(random)
        wanted, before = (tuple(0.5 * np.array(twist)) for twist in (wanted, before))
        if random.random() < 0.5:
            before = tuple(random.uniform(0, 1) * np.array(wanted))
        factor = random.uniform(0.2, 1)
        brakes_after = random.uniform(0, 1) * (law.sensor_period) + law.latency + law.base_reaction
        apart, widening = strayed(shape, law, before, wanted, factor, brakes_after)
        assert apart <= widening + RESOLUTION + 0.01 * widening, (number, shape, law, before, wanted, factor)
        ratios.append((apart - RESOLUTION) / (widening + RESOLUTION))
    assert max(ratios) > 0.3, "a bound of no use"
    print(f"strayed / bound: median {np.median(ratios):.2f}, most {max(ratios):.2f}")


def test_who_drives_straight_or_turns_in_place_from_rest_does_not_stray():
    footprint, law = core.Footprint(radius=0.2), core.Law()
    for wanted in ((0.5, 0, 0), (-0.3, 0.4, 0), (0, 0, 2)):
        assert core.straying(footprint, law, (0, 0, 0), wanted)[1] == 0


def test_who_slows_down_along_the_path_brings_no_more_than_its_two_axes():
    footprint, law = core.Footprint(radius=0.2), core.Law()
    share, widening = core.straying(footprint, law, (0.4, 0, 0), (0.2, 0, 0))
    assert (share, widening) == (pytest.approx(2), 0)
