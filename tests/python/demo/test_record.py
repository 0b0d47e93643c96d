# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import pytest

from safety_control_cloud.demo.record import Approach, Sample


def approach(*zones_and_speeds: tuple[str, float], contacts=frozenset()) -> Approach:
    samples = [Sample(0.05 * turn, zone, 0.48, speed, speed) for turn, (zone, speed) in enumerate(zones_and_speeds)]
    return Approach(tuple(samples), contacts)


GOOD = (("Safe", 0.2), ("Safe", 0.2), ("Warning", 0.1), ("Danger", 0.05), ("Danger", 0.0))


def test_a_robot_that_came_to_stand_in_danger_and_touched_nothing_did_well():
    drive = approach(*GOOD)
    assert drive.problem is None
    assert drive.zones == ("Safe", "Warning", "Danger")
    assert drive.stood_at == pytest.approx(0.48)


def test_a_robot_that_touched_something_did_not():
    assert "cabinet_left" in approach(*GOOD, contacts=frozenset({"cabinet_left"})).problem


@pytest.mark.parametrize("end", [("Safe", 0.2), ("Warning", 0.0), ("Danger", 0.05)])
def test_a_robot_that_does_not_stand_in_danger_at_the_end_did_not(end):
    assert "did not come to stand" in approach(("Safe", 0.2), end).problem


def test_a_silent_node_did_not():
    assert "said nothing" in approach().problem
