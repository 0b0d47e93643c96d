# SPDX-License-Identifier: BSD-3-Clause
"""The judge's core in its own process and the real node, asked about the same bags, cloud by cloud."""
from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List, Sequence

import numpy as np
import pytest
from drives import SECOND, camera, depth, packed, placed, wall, write_drive, write_drive2
from recordings import TOPIC, wall_at, write_mcap, write_ros1, write_ros2
from judge_rows import rows_of

SHARED = Path(__file__).resolve().parents[4] / "shared"
TIMELESS = {"source_timeout": 10.0, "stamp_tolerance": 0.0}  # as scripts/replay has it: it does not wait
SAME = ("zone", "cause", "reason", "nearest", "inside", "returns", "total", "speed")


def replayed(bag: Path, folder: Path, *arguments: str) -> List[Dict[str, Any]]:
    """By the real node."""
    answers = folder / "answers.json"
    command = [sys.executable, "-m", "safety_control_cloud.replay", bag, "--json", answers, *arguments]
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300)
    assert result.returncode == 0, result.stderr
    return json.loads(answers.read_text())


def said(row: Dict[str, Any]) -> Dict[str, Any]:
    """How many returns there were lately depends on when the node got its clouds, which is not the bag's time."""
    reason = re.sub(r"lately there were \d+", "lately there were more", row["reason"])
    return {**{name: row[name] for name in SAME}, "reason": reason}


def assert_same(bag: Path, folder: Path, *topic: str, **settings: Any) -> List[Dict[str, Any]]:
    words = [f"--param={name}={value}" for name, value in settings.items()]
    node = replayed(bag, folder, *(("--topic", *topic) if topic else ()), *words)
    ours = rows_of(bag, {**TIMELESS, **settings}, topic)
    assert [said(row) for row in ours] == [said(row) for row in node]
    points = [None if row["x"] is None else [row[name] for name in "xyz"] for row in ours]
    assert points == [row["nearest_point"] for row in node]
    assert [round(row["stamp"] / 1e9, 6) for row in ours] == [round(row["stamp"], 6) for row in node]
    return ours


def mixed() -> List[Any]:
    """Walls at all distances, one lost from sight, malformed clouds, stamps in disorder and twice the same."""
    lost = wall_at(3.0, 8 * SECOND)
    lost.points[:, 0] += 2.0
    near = [wall_at(0.2 + 0.05 * number, 10 * SECOND + number * SECOND // 20) for number in range(40)]
    malformed = [wall_at(1.5, 9 * SECOND, fields=[]), wall_at(1.5, 9 * SECOND, point_step=13),
                 wall_at(1.5, 3 * SECOND, width=2**31), wall_at(0.9, 4 * SECOND), wall_at(0.9, 4 * SECOND)]
    return [wall_at(0.45, 7 * SECOND), lost, *near, *malformed, *near[::-1]]


@pytest.mark.parametrize("write, name", [(write_ros1, "drive.bag"), (write_ros2, "drive"), (write_mcap, "drive")])
def test_every_kind_of_bag_is_judged_as_by_the_node(tmp_path, write, name):
    rows = assert_same(write(tmp_path / name, {TOPIC: mixed()}), tmp_path)

    assert {"SEEN", "NEAR_LOSS", "UNREADABLE"} <= {row["cause"] for row in rows}


def test_settings_mean_the_same(tmp_path):
    bag = write_ros1(tmp_path / "drive.bag", {TOPIC: mixed()})

    assert_same(bag, tmp_path, release_clouds=3, danger_distance=0.7, min_points=4, near_loss_distance=0.0)


def test_a_frozen_camera_is_found_as_by_the_node(tmp_path):
    bag = write_ros1(tmp_path / "drive.bag", {TOPIC: [wall_at(0.8 if n < 3 else 0.7, n * SECOND) for n in range(1, 9)]})

    rows = assert_same(bag, tmp_path, frozen_clouds=3)
    assert [row["cause"] for row in rows].count("FROZEN") == 4


@pytest.mark.parametrize("bag", ["layouts/cows_fields_not_in_offset_order.bag", "lidar/luminar_5_clouds.bag"])
def test_recorded_bags_are_judged_as_by_the_node(tmp_path, bag):
    if not (SHARED / "data" / bag).exists():
        pytest.skip(f"no recorded clouds: {SHARED / 'data'} is not there")

    assert_same(SHARED / "data" / bag, tmp_path)


@pytest.mark.slow
def test_recorded_clouds_are_judged_as_by_the_node(tmp_path):
    pcds = sorted((SHARED / "data").rglob("*.pcd"))
    if not pcds:
        pytest.skip(f"no recorded clouds: {SHARED / 'data'} is not there")
    bag, tool = tmp_path / "all.bag", SHARED / "tools" / "pcd2bag.py"
    subprocess.run([sys.executable, tool, bag, "native", "camera", TOPIC, *pcds], check=True)

    assert len(assert_same(bag, tmp_path)) == len(pcds)


def pictures() -> List[np.ndarray]:
    """[mm] a wall that comes nearer, a hole in its middle at the end."""
    made = [np.full((48, 64), 1600 - 150 * number, np.uint16) for number in range(8)]
    made[7][20:30, 20:40] = 0
    return made


@pytest.mark.parametrize("unit", [np.uint16, np.float32])
@pytest.mark.parametrize("pack", [depth, packed])
@pytest.mark.parametrize("write", [write_drive, write_drive2])
def test_depth_images_are_judged_as_by_the_node(tmp_path, write, pack, unit):
    records = []
    for number, picture in enumerate(pictures()):
        given = picture if unit is np.uint16 else (picture / np.float32(1000)).astype(np.float32)
        late = 0.02 if number % 2 else -0.02  # the CameraInfo comes after its image, or before
        records += [pack(0.1 * number, given), camera(0.1 * number, 64, 48, 50.0, late)]
    records.append(pack(2.0, pictures()[0]))  # its CameraInfo never comes

    rows = assert_same(write(tmp_path / "depth.bag" if write is write_drive else tmp_path / "depth", records), tmp_path)

    assert [row["zone"] for row in rows[::2]] == ["Safe", "Safe", "Danger" if rows[4]["nearest"] < 0.5 else "Warning", "Warning"][: len(rows[::2])]


def test_a_moving_camera_is_where_the_bags_transforms_say(tmp_path):
    records = [placed(-1.0, (0.1, 0.0, 0.3), (-0.5, 0.5, -0.5, 0.5), static=True, parent="tower")]
    records += [wall(0.2 * n + 0.15, 1.6 - 0.1 * n) for n in range(10)]
    bag = write_drive(tmp_path / "moving.bag", records)

    rows = assert_same(bag, tmp_path, target_frame="tower")
    assert {row["cause"] for row in rows} <= {"SEEN"} and rows[0]["nearest"] == pytest.approx(1.7)

    nowhere = assert_same(bag, tmp_path, target_frame="elsewhere")
    assert {row["cause"] for row in nowhere} == {"NO_TRANSFORM"}
