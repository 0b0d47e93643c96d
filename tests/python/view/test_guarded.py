# SPDX-License-Identifier: BSD-3-Clause
"""What the viewer draws of the guard; without the viewer."""
from __future__ import annotations

import numpy as np
import pytest

from safety_control_cloud import core
from safety_control_cloud.view.guarded import OUTLINES, footprint_of, stopping_time, swept

MOTIONS = [(0.3, 0.0, 0.0), (0.3, 0.0, 0.4), (-0.2, 0.0, -1.0), (0.1, -0.2, 0.3), (0.0, 0.0, 2.0), (0.3, 0.0, 1e-7)]


@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("lasts", [0.0, 0.5, 3.0])
def test_the_way_is_that_of_the_core(motion, lasts, monkeypatch):
    monkeypatch.setattr("safety_control_cloud.view.guarded.stopping_time", lambda *_: lasts)
    settings = core.Settings(mode="guard", footprint="[[0, 0], [1, 0], [0.5, 1]]")

    for i, outline in enumerate(swept(settings, motion), 1):
        met = core.moved(outline[:2, :2].astype(float), motion, lasts * i / OUTLINES)
        assert np.allclose(met, [[0.0, 0.0], [1.0, 0.0]], atol=1e-5)


def test_a_footprint_is_a_circle_with_its_margin_or_its_corners_as_the_node_takes_them():
    circle = footprint_of(core.Settings(mode="guard", radius=0.2, margin=0.05))
    assert np.allclose(np.hypot(circle[:, 0], circle[:, 1]), 0.25) and np.array_equal(circle[0], circle[-1])

    corners = [[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.3, -0.2]]
    settings = core.Settings(mode="guard", footprint=str(corners))  # as rospy gives the parameter
    assert settings.problems() == []
    assert np.allclose(footprint_of(settings), [[x, y, 0.0] for x, y in [*corners, corners[0]]])


def test_what_is_swept_ends_where_the_robot_stands():
    settings = core.Settings(mode="guard")

    outlines = swept(settings, (0.36, 0.0, 0.0))

    assert len(outlines) == OUTLINES and stopping_time(settings, (0.36, 0.0, 0.0)) == pytest.approx(0.65)
    assert outlines[-1][:, 0].mean() - footprint_of(settings)[:, 0].mean() == pytest.approx(0.36 * 0.65)
    assert swept(settings, (0.0, 0.0, 0.0)) == []
