# SPDX-License-Identifier: BSD-3-Clause
"""What must hold in every scene."""
from dataclasses import replace
from math import inf, pi

import numpy as np
from hypothesis import assume, given, settings, strategies as st

from safety_control_cloud import core
from shapes import Corners, Shape, random_shape, random_twist

LAW = core.Law()
seeds = st.integers(0, 2**32 - 1)


def scene(seed, count=6):
    """A shape, a wanted twist, (N, 2) points that are not in the shape's margin from the start, and who was asked."""
    random = np.random.default_rng(seed)
    shape, wanted = random_shape(random), random_twist(random)
    points = random.uniform(-3, 3, (count, 2))
    clear = shape.footprint().signed_distance(points) > shape.margin + 1e-3
    return shape, wanted, points[clear], random


def times(shape: Shape, twist, points, widening=0.0):
    return core.time_to_contact(shape.footprint(), twist, points, widening)


def factor(shape: Shape, points, wanted, **more):
    return core.limit(shape.footprint(), LAW, points, wanted, **more).factor


def mapped(shape: Shape, place) -> Shape:
    """The same shape elsewhere: `place` maps (N, 2) to (N, 2)."""
    corners: Corners = tuple(map(tuple, place(np.array(shape.corners)))) if shape.corners else ()
    return replace(shape, corners=corners)


def assert_same_times(first, second):
    """Of two (shape, twist, points). What only grazes may be missed in one by rounding, but not if it is widened."""
    for one, other in ((first, second), (second, first)):
        assert (times(*one, widening=1e-7) <= times(*other) + 1e-6).all()


@given(seeds, st.floats(0.01, 1))
def test_scaling_down_never_turns_safe_to_unsafe(seed, share):
    shape, wanted, points, _ = scene(seed)
    assume(factor(shape, points, wanted) == 1)
    assert factor(shape, points, core.limited(wanted, share)) == 1


@given(seeds)
def test_what_is_let_through_is_let_through_again(seed):
    shape, wanted, points, _ = scene(seed)
    allowed = factor(shape, points, wanted)
    assume(allowed > 0)
    assert factor(shape, points, core.limited(wanted, 0.999 * allowed)) == 1


@given(seeds, st.booleans())
def test_more_points_never_mean_a_faster_robot(seed, is_moving):
    shape, wanted, _, random = scene(seed)
    points = random.uniform(-1.5, 1.5, (8, 2))  # some of them inside the margin
    under_way = [random_twist(random)] if is_moving else []
    factors = [factor(shape, points[:count], wanted, under_way=under_way) for count in range(9)]
    assert factors == sorted(factors, reverse=True)


@given(seeds)
def test_a_longer_wait_for_data_never_means_a_faster_robot(seed):
    shape, wanted, points, _ = scene(seed)
    factors = [factor(shape, points, wanted, age=age) for age in (0, 0.1, 0.3, 1)]
    assert factors == sorted(factors, reverse=True)


@settings(max_examples=30)
@given(seeds)
def test_a_mirrored_scene_has_the_same_times(seed):
    shape, (forward, left, turning), points, _ = scene(seed, count=200)
    mirrored = mapped(shape, lambda corners: corners * (1, -1))
    assert_same_times(
        (shape, (forward, left, turning), points), (mirrored, (forward, -left, -turning), points * (1, -1))
    )


@settings(max_examples=30)
@given(seeds, st.floats(-pi, pi))
def test_a_scene_seen_from_a_robot_whose_front_is_elsewhere_has_the_same_times(seed, angle):
    shape, (forward, left, turning), points, _ = scene(seed, count=200)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    velocity = np.array([forward, left]) @ turn
    turned = mapped(shape, lambda corners: corners @ turn)
    assert_same_times((shape, (forward, left, turning), points), (turned, (*velocity, turning), points @ turn))


@settings(max_examples=30)
@given(seeds)
def test_times_are_continuous_through_driving_straight(seed):
    shape, (forward, left, _), points, _ = scene(seed, count=200)
    assume(abs(forward) + abs(left) > 0.1)
    near = points[times(shape, (forward, left, 1e-9), points) < 100]  # later, an arc comes back
    for turning in (1e-9, -1e-9, 1e-12, -1e-300, 5e-324):
        assert_same_times((shape, (forward, left, 0), near), (shape, (forward, left, turning), near))


@given(seeds, st.floats(0, 0.5))
def test_a_wider_margin_is_touched_no_later(seed, widening):
    shape, twist, points, _ = scene(seed, count=50)
    wider = core.time_to_contact(shape.footprint(), twist, points, widening)
    assert (wider <= times(shape, twist, points) + 1e-9).all()


@given(seeds, st.floats(0.01, 0.5))
def test_cells_are_touched_no_later_than_the_first_of_their_points(seed, cell):
    shape, twist, points, _ = scene(seed, count=200)
    cells, counts, widening = core.reduced(points, cell)
    assert sum(counts) == len(points)
    assert widening <= cell * 2**-0.5 + 1e-12
    first = core.time_to_contact(shape.footprint(), twist, cells, widening + 1e-12).min(initial=inf)
    assert first <= times(shape, twist, points).min(initial=inf) + 1e-9
