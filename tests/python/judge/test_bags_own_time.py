# SPDX-License-Identifier: BSD-3-Clause
"""Where the time between the clouds decides, the node is played the bag as fast as it was recorded."""
from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from itertools import groupby
from pathlib import Path
from typing import Any, List

import pytest
from drives import placed, wall, write_drive
from judge_rows import rows_of

LIVE = Path(__file__).with_name("live.py")
TOPIC = "/camera/depth/points"


def said_by_the_node(bag: Path, **settings: Any) -> List[list]:
    words = [f"_{name}:={value}" for name, value in settings.items()]
    result = subprocess.run([sys.executable, LIVE, bag, *words], capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, result.stderr
    states = [state for state in json.loads(result.stdout.splitlines()[-1]) if state[2] != "NO_CLOUD"]
    while states and states[-1][2] == "SILENT":
        states.pop()  # the bag has ended
    return without_repetitions(states)


def said_by_the_judge(bag: Path, **settings: Any) -> List[list]:
    told: List[list] = []
    for row in rows_of(bag, settings):
        stamp = told[-1][0] if row["stamp"] is None else row["stamp"]
        told.append([stamp, *(row[name] for name in ("zone", "cause", "nearest", "speed", "inside", "returns", "total"))])
    return without_repetitions(told)


def without_repetitions(states: List[list]) -> List[list]:
    """The node repeats its state when nothing new comes."""
    return [list(key) for key, _ in groupby(map(tuple, states))]


def eventful() -> List[Any]:
    """Ten clouds a second: two in disorder, an old one, one of the future, a silence, and a second camera for a while."""
    drive = [wall(0.0, 1.5), wall(0.1, 1.45, age=0.05), wall(0.2, 1.4, age=0.25), wall(0.3, 1.3), wall(0.4, 1.2, age=5.0),
             wall(0.5, 1.1, age=-3.0), wall(0.6, 1.05), wall(0.7, 0.9)]
    after_silence = [wall(1.6 + 0.1 * n, 1.5 - 0.02 * n) for n in range(5)]
    other = [wall(2.15 + 0.1 * n, 0.7, source="/other") for n in range(3)]
    beside = [wall(2.1 + 0.1 * n, 1.4) for n in range(5)]
    return [*drive, *after_silence, *other, *beside, *(wall(3.4 + 0.1 * n, 0.8 - 0.02 * n) for n in range(3))]


@pytest.mark.slow
def test_silences_ages_disorder_and_second_cameras_are_judged_as_the_node_does_live(tmp_path):
    bag = write_drive(tmp_path / "eventful.bag", eventful())
    settings = {"release_clouds": 3, "near_loss_distance": 0.0}

    judged = said_by_the_judge(bag, **settings)

    assert {"SEEN", "STALE", "FUTURE", "SILENT", "TWO_SOURCES"} == {state[2] for state in judged}
    assert judged == said_by_the_node(bag, **settings)


@pytest.mark.slow
def test_a_camera_that_moves_is_placed_as_the_node_does_live(tmp_path):
    still = placed(-0.5, (0.1, 0.0, 0.3), (-0.5, 0.5, -0.5, 0.5), static=True, parent="mast")
    turning = [placed(0.05 * n, (0.01 * n, 0.0, 0.0), (0.0, 0.0, 0.01 * n, (1 - (0.01 * n) ** 2) ** 0.5), parent="base")
               for n in range(20)]
    chain = [mast(record) for record in turning]
    walls = [wall(0.33 + 0.1 * n, 1.6 - 0.1 * n, age=0.03) for n in range(9)]  # the last ones beyond the transforms
    bag = write_drive(tmp_path / "moving.bag", [still, *chain, *walls])

    judged = said_by_the_judge(bag, target_frame="base")

    assert {state[2] for state in judged} == {"SEEN", "NO_TRANSFORM"}
    assert judged == said_by_the_node(bag, target_frame="base")


def mast(record: Any) -> Any:
    """The same transform, of the mast in the base."""
    def make(store: Any) -> Any:
        message = record.make(store)
        message.transforms[0].child_frame_id = "mast"
        return message
    return replace(record, make=make)


def test_a_silence_has_a_row_of_its_own_that_says_how_long_it_was(tmp_path):
    rows = rows_of(write_drive(tmp_path / "gap.bag", [wall(0.0, 1.5), wall(2.0, 1.5)]))

    assert [(row["number"], row["cause"], row["speed"]) for row in rows] == [(0, "SEEN", 0.2), (0, "SILENT", 0.0), (1, "SEEN", 0.2)]
    assert rows[1]["reason"] == "no cloud for 2.000 s" and rows[1]["time"] - rows[0]["time"] == 500_000_000


def test_a_camera_that_dies_before_the_bag_ends_is_silent_to_its_end(tmp_path):
    still = [placed(0.1 * n, (0, 0, 0), (0, 0, 0, 1)) for n in range(30)]

    rows = rows_of(write_drive(tmp_path / "dies.bag", [wall(0.0, 1.5), *still]))

    assert [row["cause"] for row in rows] == ["SEEN", "SILENT"] and rows[1]["reason"] == "no cloud for 2.900 s"


def test_clouds_as_seldom_as_the_timeout_allows_are_no_silence(tmp_path):
    rows = rows_of(write_drive(tmp_path / "seldom.bag", [wall(0.5 * n, 1.5) for n in range(4)]))

    assert [row["cause"] for row in rows] == ["SEEN"] * 4
