# SPDX-License-Identifier: BSD-3-Clause
"""How much of a wish is let through."""
from dataclasses import replace
from functools import partial
from math import cos, inf, pi, sin

import numpy as np
import pytest

from base import Base
from safety_control_cloud import core
from shapes import random_shape

at_once = partial(
    core.Law, sensor_period=0, latency=0, base_reaction=0, linear_deceleration=1, angular_deceleration=pi / 2, escape_speed=0.1
)
AT_ONCE, WITHOUT_NOISE = at_once(), at_once(noise=0)
LONG_ROBOT = core.Footprint([(-2, -0.1), (0, -0.1), (0, 0.1), (-2, 0.1)])
ROUND = core.Footprint(radius=0.2, margin=0.05)


def given(footprint, law, points, wanted, **more):
    return core.limited(wanted, core.limit(footprint, law, points, wanted, **more).factor)


def test_a_point_ahead_leaves_the_speed_from_which_one_stops_before_it():
    assert given(LONG_ROBOT, AT_ONCE, [(0.5, 0)], (2, 0, 0))[0] == pytest.approx(1)


def test_the_reaction_time_costs_speed():
    law = core.Law(
        sensor_period=0, latency=0.2, base_reaction=0, linear_deceleration=1, angular_deceleration=pi / 2
    )
    assert given(LONG_ROBOT, law, [(0.5, 0)], (2, 0, 0))[0] == pytest.approx(0.82, abs=0.005)


@pytest.mark.parametrize("speed, is_free", [(1, False), (-1, True)])
def test_a_point_inside_the_front_lets_only_backward_pass(speed, is_free):
    limit = core.limit(LONG_ROBOT, AT_ONCE, [(-0.05, 0)], (speed, 0, 0))
    assert (limit.factor, limit.is_escape) == ((pytest.approx(0.1), True) if is_free else (0, False))


@pytest.mark.parametrize("turning, is_free", [(1, False), (-1, True)])
def test_a_point_inside_the_right_flank_lets_only_turning_right_pass(turning, is_free):
    assert (core.limit(LONG_ROBOT, AT_ONCE, [(-1, -0.09)], (0, 0, turning)).factor > 0) == is_free


def test_a_point_beside_the_tail_limits_turning_toward_it():
    assert given(LONG_ROBOT, AT_ONCE, [(-1, -1.1)], (0, 0, pi))[2] == pytest.approx(pi / 2, rel=0.05)
    assert given(LONG_ROBOT, AT_ONCE, [(-1, -1.1)], (0, 0, -pi))[2] == -pi


@pytest.mark.parametrize("heading", np.arange(16) * pi / 8)
def test_an_omnidirectional_robot_keeps_its_direction(heading):
    wanted = (2 * cos(heading), 2 * sin(heading), 0)
    forward, left, turning = given(ROUND, WITHOUT_NOISE, [(0.75 * cos(heading), 0.75 * sin(heading))], wanted)
    assert (forward, left) == pytest.approx((cos(heading), sin(heading)))
    assert turning == 0


def test_a_safe_wish_passes_equal_in_every_bit():
    wanted = (0.1 + 0.2, -0.0, 5e-324)
    limit = core.limit(ROUND, core.Law(), [(3, 3)], wanted)
    assert np.array(core.limited(wanted, limit.factor)).tobytes() == np.array(wanted).tobytes()


def test_a_round_robot_turns_freely_where_it_just_fits():
    wall = [(0.25 * cos(angle), 0.25 * sin(angle)) for angle in np.linspace(0, 2 * pi, 50)]
    assert core.limit(ROUND, core.Law(), wall, (0, 0, 3)).factor == 1


def test_a_wish_to_stand_is_never_limited():
    assert core.limit(ROUND, core.Law(), [(0, 0)], (0, 0, 0)).factor == 1


@pytest.mark.parametrize("wanted", [(np.nan, 0, 0), (0, np.inf, 0), (0, 0, 1e300)])
def test_a_wish_that_is_no_motion_stands(wanted):
    for footprint in (ROUND, LONG_ROBOT):
        assert core.limit(footprint, core.Law(), [(9, 9)], wanted).factor == 0


def test_a_point_that_is_not_finite_stops_the_robot():
    assert core.limit(ROUND, core.Law(), [(np.nan, 0)], (0.1, 0, 0)).factor == 0


def test_fewer_points_than_an_obstacle_has_are_none():
    law = core.Law(min_points=3)
    assert core.limit(ROUND, law, [(0.3, 0), (0.31, 0)], (0.5, 0, 0)).factor == 1
    assert core.limit(ROUND, law, [(0.3, 0), (0.31, 0), (0.6, 0)], (0.5, 0, 0)).point == 2


def test_obstacles_that_may_approach_are_kept_farther_away():
    wanted = (0.2, 0, 0)
    assert core.limit(ROUND, core.Law(), [(0.45, 0)], wanted).factor == 1
    assert 0 < core.limit(ROUND, core.Law(obstacle_speed=0.3), [(0.45, 0)], wanted).factor < 0.8
    assert core.limit(ROUND, core.Law(obstacle_speed=0.3), [(0.30, 0)], wanted).factor == 0


def test_little_more_than_what_is_given_would_not_be_safe():
    parts = []
    for seed in range(300):
        random = np.random.default_rng(seed)
        footprint = replace(random_shape(random), margin=0.05).footprint()
        points = random.uniform(-1.5, 1.5, (30, 2))
        points = points[footprint.signed_distance(points) > 0.1]
        wanted = (random.uniform(0.2, 0.7), 0, random.uniform(-1.2, 1.2))
        factor = core.limit(footprint, core.Law(), points, wanted).factor
        if 0.05 < factor < 1:
            more = [share for share in np.linspace(factor, 1, 100)
                    if core.limit(footprint, core.Law(), points, core.limited(wanted, share)).factor == 1]
            parts.append(factor / max(more, default=factor))
    assert len(parts) > 100
    assert min(parts) > 0.88 and np.median(parts) > 0.95


def test_a_motion_under_way_that_would_not_end_in_time_is_braked_at_once():
    wall = [(0.35, 0)]
    assert core.limit(ROUND, core.Law(), wall, (0.3, 0, 0)).factor > 0
    assert core.limit(ROUND, core.Law(), wall, (0.3, 0, 0), under_way=[(0.6, 0, 0)]).factor == 0


def test_turning_in_place_waits_until_the_robot_has_stopped_before_a_wall():
    corridor = [(0.35, y) for y in np.linspace(-1, 1, 50)]
    assert core.limit(ROUND, core.Law(), corridor, (0, 0, 1)).factor == 1
    assert core.limit(ROUND, core.Law(), corridor, (0, 0, 1), under_way=[(0.5, 0, 0)]).factor < 0.1


@pytest.mark.parametrize("away", [-0.1, -0.05, 0.0, 0.05])
@pytest.mark.parametrize("wanted", [(0.5, 0, 0), (0.5, 0, 0.2)])
def test_what_has_been_given_is_not_taken_away_for_noise(wanted, away):
    """Nor given again: a robot that only commands tell of would jerk before every wall."""
    law, under_way = core.Law(), []

    def factor_before_a_wall(nearer):
        wall = np.column_stack([np.full(200, 0.6 + away - nearer), np.linspace(-1, 1, 200)])
        return core.limit(ROUND, law, wall, wanted, under_way=under_way).factor

    for _ in range(20):
        factor = factor_before_a_wall(0.0)
        under_way = [core.limited(wanted, factor)]
    assert 0.6 < factor < 1
    for nearer in (law.noise, 2 * law.noise):
        assert factor_before_a_wall(nearer) > 0.99 * factor


def test_out_of_the_margin_the_fastest_point_keeps_to_the_escape_speed():
    backward = given(ROUND, core.Law(escape_speed=0.08), [(0.22, 0)], (-0.5, 0, 0))
    assert backward[0] == pytest.approx(-0.08)


def test_what_is_outside_the_margin_keeps_the_law_on_the_way_out():
    law = core.Law(escape_speed=0.3)
    free = core.limit(ROUND, law, [(0.22, 0)], (-0.5, 0, 0))
    behind = core.limit(ROUND, law, [(0.22, 0), (-0.3, 0)], (-0.5, 0, 0))
    assert 0 < behind.factor < free.factor
    assert behind.point == 1


def test_no_series_of_short_motions_creeps_toward_a_wall():
    """At an angle so flat that a single one comes nearer by less than the noise."""
    square, law = core.Footprint([(-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)], margin=0.05), core.Law(noise=0.02)
    wall = np.column_stack([np.linspace(-1, 1, 200), np.full(200, 0.22)])
    slow, fine = 0.01, core.Law(noise=0.02, escape_speed=0.01)
    for angle in np.radians([3, 10, 30, 90]):
        assert core.limit(square, fine, wall, (slow * cos(angle), slow * sin(angle), 0)).factor == 0
    assert core.limit(square, law, [(0, 0.22)], (0.1, 0, 0)).factor == 1
    assert core.limit(square, law, wall, (0.03, -0.09, 0)).factor == 1


def rude_drive(random, footprint, law, margin, wishes=25):
    """By somebody who wishes for anything: [m] the least clearance from the margin, and the way driven."""
    base, clearance, way = Base(law), inf, 0.0
    points = random.uniform(-2.5, 2.5, (40, 2))
    points = points[footprint.signed_distance(points) > margin + 0.02]
    for _ in range(wishes):
        wanted = tuple(random.uniform(-1, 1, 3) * random.choice([0, 0.7, 0.7], 3) * (1, 1, 2))
        for _ in range(random.integers(1, 40)):
            limit = core.limit(footprint, law, base.seen_from(points), wanted, under_way=base.under_way())
            base.command(core.limited(wanted, limit.factor))
            base.drive(law.sensor_period, dt=law.sensor_period / 10)
            clearance = min(clearance, footprint.signed_distance(base.seen_from(points)).min() - margin)
            way += law.sensor_period * np.hypot(*base.twist[:2])
    return clearance, way


@pytest.mark.slow
@pytest.mark.parametrize("noise, tolerance, least_way", [(0, 1e-4, 0.5), (0.01, 0.02, 2)])
def test_nobody_drives_a_robot_against_what_it_sees(noise, tolerance, least_way):
    """Without noise there is no way out of the margin, and no way into it; with noise it is used to get out."""
    clearances, ways = [], []
    for seed in range(40):
        random = np.random.default_rng(seed)
        footprint = replace(random_shape(random), margin=0.05).footprint()
        law = core.Law(linear_deceleration=0.8, base_reaction=0.05 * random.integers(0, 5), noise=noise)
        clearance, way = rude_drive(random, footprint, law, margin=0.05)
        assert clearance > -tolerance, f"seed {seed}"
        clearances.append(clearance)
        ways.append(way)
    print(f"least clearance {min(clearances):.5f} m, {np.mean(ways):.2f} m driven in the mean")
    assert np.mean(ways) > least_way
