# SPDX-License-Identifier: BSD-3-Clause
"""The closed form == a naive drive in small steps."""
from math import hypot, inf, isfinite, pi

import numpy as np
import pytest

from safety_control_cloud import core
from shapes import Shape, distance, random_shape, random_twist

STEPS = 900
ROUNDING = 2e-4  # [m] of the naive drive, whose steps are chords


def naive_drive(twist, point, duration):
    """(STEPS + 1, 2) the point in the robot's frame, from driving the robot through the world step by step."""
    forward, left, turning = twist
    step = duration / STEPS
    heading = turning * step * (np.arange(STEPS) + 0.5)
    steps = step * np.column_stack(
        [forward * np.cos(heading) - left * np.sin(heading), forward * np.sin(heading) + left * np.cos(heading)]
    )
    position = np.vstack([(0, 0), np.cumsum(steps, axis=0)])
    heading = turning * step * np.arange(STEPS + 1)
    x, y = (np.array(point) - position).T
    return np.column_stack([x * np.cos(heading) + y * np.sin(heading), y * np.cos(heading) - x * np.sin(heading)])


def duration_of(twist):
    """[s] a full turn, or 8 m."""
    turn = 2 * pi / abs(twist[2]) if twist[2] else inf
    drive = 8 / hypot(*twist[:2]) if hypot(*twist[:2]) else inf
    return min(turn, drive, 1e6)


def random_point(random, twist):
    """Anywhere, or where a drive of up to two seconds leads near the robot."""
    point = random.uniform(-3, 3, 2)
    if random.random() < 0.5:
        (point,) = core.moved([point / 3], twist, -random.uniform(0, 2))
    return tuple(map(float, point))


def disagreement(shape, twist, point):
    """What the naive drive says against the closed form, or None; and whether contact only grazes."""
    duration = duration_of(twist)
    clearance = distance(shape, naive_drive(twist, point, duration)) - shape.margin
    step = hypot(twist[0] - twist[2] * point[1], twist[1] + twist[2] * point[0]) * duration / STEPS  # [m]
    (time,) = core.time_to_contact(shape.footprint(), twist, [point], horizon=duration)
    if not isfinite(time):
        return ("sees none" if clearance.min() < -ROUNDING else None), False
    at = time / duration * STEPS
    if clearance[: int(at)].min(initial=inf) < -ROUNDING:
        return "sees it too late", False
    around = clearance[max(0, int(at) - 1) : int(at) + 3]
    if around.min() > step / 2 + ROUNDING:
        return "sees one where there is none", False
    return None, around.min() > 0


def test_a_point_moves_as_in_a_naive_drive():
    random = np.random.default_rng(7)
    for _ in range(200):
        twist, point = random_twist(random), tuple(random.uniform(-3, 3, 2))
        duration = duration_of(twist)
        (end,) = core.moved([point], twist, duration)
        assert end == pytest.approx(naive_drive(twist, point, duration)[-1], abs=ROUNDING)


@pytest.mark.slow
def test_the_closed_form_agrees_with_a_naive_drive_on_ten_thousand_scenes():
    random = np.random.default_rng(20261121)
    grazes, contacts = 0, 0
    for number in range(10_000):
        shape, twist = random_shape(random), random_twist(random)
        point = random_point(random, twist)
        problem, is_graze = disagreement(shape, twist, point)
        assert problem is None, f"scene {number}: the closed form {problem}: {shape}, {twist}, {point}"
        grazes += is_graze
        contacts += isfinite(core.time_to_contact(shape.footprint(), twist, [point])[0])
    assert 3_000 < contacts < 8_000, "the scenes should be worth the name"
    assert grazes < 0.02 * contacts
