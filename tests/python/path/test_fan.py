# SPDX-License-Identifier: BSD-3-Clause
"""How far a base leaves the fan of arcs it is judged on == a base driven in small steps, at most."""
import numpy as np
import pytest

from base import Base
from safety_control_cloud import core
from shapes import random_shape
from ways import RESOLUTION, body_points, corners_in_world, drive, poses_on_path


class Capricious(Base):
    """Each axis obeys, from moment to moment, at the law's rate or many times faster."""

    def __init__(self, law, twist, random):
        super().__init__(law, twist=twist)
        self.random, self.slow, self.rates, self.until = random, law, (1.0, 1.0), 0.0

    def next_twist(self, dt):
        if self.time >= self.until:
            self.rates = self.random.choice([1.0, 1.0, 3.0, 1000.0], 2)
            self.until = self.time + self.random.choice([0.05, 0.2, 9.0])
        self.law = core.Law(
            linear_deceleration=self.slow.linear_deceleration * self.rates[0], latency=self.slow.latency,
            angular_deceleration=self.slow.angular_deceleration * self.rates[1],
        )  # fmt: skip
        return super().next_twist(dt)


def strayed(random, shape, law, under_way, wanted, factors, factor, brakes_after):
    """[m] how far some moment of a drive lies from the nearest moment of the arcs, the bound, and straying()'s."""
    fan = core.fan(shape.footprint(), law, under_way, wanted, *factors)
    if fan is None:
        return None
    share, arcs, widening = fan
    most = max(factors[1], share)
    braking = max(np.hypot(*wanted[:2]) / law.linear_deceleration, abs(wanted[2]) / law.angular_deceleration)
    way = most * (law.sensor_period + law.latency + law.base_reaction) + most**2 * braking / 2
    corners = body_points(shape)
    paths = np.concatenate([corners_in_world(poses_on_path(arc, way), corners) for arc in arcs])
    driven = corners_in_world(
        drive(Capricious(law, under_way, random), core.limited(wanted, factor), brakes_after), corners)
    apart = [np.hypot(*(paths - now).transpose(2, 0, 1)).max(axis=1).min() for now in driven[::5]]
    return max(apart), widening, core.straying(shape.footprint(), law, under_way, wanted, *factors)[1]


def random_drive(random):
    law = core.Law(
        linear_deceleration=random.uniform(0.2, 2), angular_deceleration=random.uniform(0.5, 5),
        sensor_period=random.uniform(0, 0.3), latency=random.uniform(0, 0.1),
    )  # fmt: skip
    heading = random.choice([0, 0, np.pi, random.uniform(-np.pi, np.pi)])
    speed, turning = random.uniform(0.05, 0.7), random.uniform(-1.5, 1.5) * random.choice([0, 1, 1])
    wanted = (speed * np.cos(heading), speed * np.sin(heading), turning)
    share = random.choice([0, 1, random.uniform(0, 2)])
    old = turning * share if random.random() < 0.3 or share == 0 else random.uniform(-1.5, 1.5) * random.choice([0, 1])
    across = random.choice([0, 0, random.uniform(-0.02, 0.02)])
    under_way = (share * wanted[0] - across * np.sin(heading), share * wanted[1] + across * np.cos(heading), old)
    least, most = random.choice([(1.0, 1.0), (0.7, 1.0), (0.34, 0.49), (0.0, 0.03), (0.0, 1.0)], axis=0)
    brakes_after = random.uniform(0, 1) * law.sensor_period + law.latency + law.base_reaction
    return law, under_way, wanted, (least, most), random.uniform(least, most), brakes_after


def test_a_base_whose_axes_obey_each_as_fast_as_it_likes_strays_no_farther_than_the_bound():
    random = np.random.default_rng(7)
    ratios, gains = [], []
    for number in range(400):
        shape, drawn = random_shape(random), random_drive(random)
        found = strayed(random, shape, *drawn)
        if found is None:
            continue
        apart, widening, to_both_sides = found
        assert apart <= widening + 2 * RESOLUTION + 0.01 * widening, (number, shape, drawn)
        ratios.append((apart - RESOLUTION) / (widening + RESOLUTION))
        gains.append(widening < to_both_sides)
    assert len(ratios) > 300
    assert max(ratios) > 0.2, "a bound of no use"
    assert np.mean(gains) > 0.2, "it is hardly ever the lesser one"
    print(f"strayed / bound: median {np.median(ratios):.2f}, most {max(ratios):.2f}; the lesser in {np.mean(gains):.2f}")


def test_of_straight_ways_nothing_is_left():
    share, arcs, widening = core.fan(core.Footprint(radius=0.2), core.Law(), (0.15, 0, 0), (0.3, 0, 0))
    assert (share, widening) == (pytest.approx(0.5), 0)
    assert all(tuple(arc) == (0.3, 0.0, 0.0) for arc in arcs)


@pytest.mark.parametrize("under_way, wanted", [
    ((-0.1, 0, 0), (0.3, 0, 0)), ((0.1, 0.1, 0), (0.3, 0, 0)), ((0, 0, 1), (0.3, 0, 0)), ((0.1, 0, 0), (0, 0, 1)),
])  # fmt: skip
def test_who_does_not_drive_in_the_same_direction_has_none(under_way, wanted):
    assert core.fan(core.Footprint(radius=0.2), core.Law(), under_way, wanted) is None


def test_who_turns_away_from_a_post_beside_him_is_not_stopped_for_it():
    """At half a metre a second straight on, and the wish to go on around it."""
    long = core.Footprint([(0.3, -0.2), (-0.3, -0.2), (-0.3, 0.2), (0.3, 0.2)], margin=0.05)
    for beside in np.linspace(-0.3, 0.1, 5):
        limit = core.limit(long, core.Law(), [(beside, -0.48)], (0.5, 0, -0.47), under_way=[(0.5, 0, 0)])
        assert limit.factor == 1.0, beside
