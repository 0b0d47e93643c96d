# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

from math import inf, nan

import numpy as np
from matplotlib.image import imread

from safety_control_cloud.demo.picture import draw
from safety_control_cloud.demo.record import Approach, Sample


def samples(start: float) -> tuple[Sample, ...]:
    ways = np.linspace(2.5, 0.48, 60)
    zones = ["Safe" if way > 1 else "Warning" if way > 0.5 else "Danger" for way in ways]
    seen = enumerate(zip(zones, ways))
    return tuple(Sample(start + 0.2 * turn, zone, float(way), 0.1, 0.1) for turn, (zone, way) in seen)


def test_a_drive_becomes_a_picture(tmp_path):
    views = {"Safe": np.full((48, 64, 3), 200, np.uint8)}
    draw([Approach(samples(3.0), frozenset(), views), Approach(samples(20.0))], "cabinet", tmp_path / "run.png")
    picture = imread(tmp_path / "run.png")
    assert picture.shape[:2] == (900, 1200)
    assert picture[..., :3].std() > 0.05  # not blank


def test_a_drive_through_open_space_and_blindness_becomes_a_picture_too(tmp_path):
    open_space = (Sample(0.0, "Safe", inf, 0.2, 0.2), Sample(0.1, "Danger", nan, 0.0, 0.0))
    draw([Approach(open_space)], "hall", tmp_path / "run.png")
    assert (tmp_path / "run.png").is_file()
