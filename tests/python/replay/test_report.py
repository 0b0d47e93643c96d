# SPDX-License-Identifier: BSD-3-Clause
import json
from dataclasses import replace

import pytest
from matplotlib.image import imread
from rich.console import Console

from safety_control_cloud import core
from safety_control_cloud.replay.lockstep import Answer
from safety_control_cloud.replay.plot import write_plot
from safety_control_cloud.replay.report import summary_of, table_of, write_json
from safety_control_cloud.replay.silence import silences

SEEN = Answer(1_600_000_000_000_000_001, "Warning", "SEEN", "nearest obstacle at 0.754 m", 0.754, (0.1, 0.2, 0.754),
              7, 80, 100, 0.1)
FREE = replace(SEEN, stamp=SEEN.stamp + 10**8, zone="Safe", nearest=None, nearest_point=None, inside=0, speed=0.2)
BLIND = replace(FREE, stamp=FREE.stamp + 10**8, zone="Danger", cause="BLIND", reason="0 returns of [100] points",
                returns=0, speed=0.0)


def printed(*answers: Answer, width: int = 200) -> list:
    console = Console(width=width)
    with console.capture() as capture:
        console.print(table_of(answers, "drive.bag [1]"))
    return capture.get().splitlines()


def test_the_table_has_a_row_for_every_cloud():
    rows = [" ".join(line.split()) for line in printed(SEEN, FREE, BLIND) if line[:1].isdigit()]

    assert rows == [
        "1600000000.000000001 Warning SEEN 0.754 7/80/100 0.1",
        "1600000000.100000001 Safe SEEN free 0/80/100 0.2",
        "1600000000.200000001 Danger BLIND: 0 returns of [100] points - 0/0/100 0.0",
        "3 clouds: Safe 1, Warning 1, Danger 1",
    ]


def test_a_terminal_of_80_columns_shows_every_column_whole():
    full = replace(SEEN, zone="Warning", cause="UNREADABLE", inside=307200, returns=307200, total=307200)

    line = next(line for line in printed(full, width=80) if line.startswith("1600000000"))

    assert line.split() == ["1600000000.000000001", "Warning", "UNREADABLE:", "0.754", "307200/307200/307200", "0.1"]


def test_names_and_units_in_brackets_are_printed_as_they_are():
    text = "\n".join(printed(SEEN))

    assert all(words in text for words in ("drive.bag [1]", "[s]", "[m]", "[m/s]"))


def test_the_summary_counts_the_zones():
    assert summary_of([SEEN, FREE, FREE]) == "3 clouds: Safe 2, Warning 1, Danger 0"
    assert summary_of([BLIND]) == "1 cloud: Safe 0, Warning 0, Danger 1"


def test_json_says_null_where_there_is_no_distance_and_the_cause_says_why(tmp_path):
    write_json([SEEN, FREE, BLIND], tmp_path / "answers.json")

    seen, free, blind = json.loads((tmp_path / "answers.json").read_text())
    assert seen == {
        "stamp": 1_600_000_000.0, "zone": "Warning", "cause": "SEEN", "reason": "nearest obstacle at 0.754 m",
        "nearest": 0.754, "nearest_point": [0.1, 0.2, 0.754], "inside": 7, "returns": 80, "total": 100, "speed": 0.1,
        "time": 0.0, "topic": ""}
    assert (free["nearest"], free["nearest_point"], free["cause"]) == (None, None, "SEEN")
    assert (blind["nearest"], blind["nearest_point"], blind["cause"]) == (None, None, "BLIND")


@pytest.mark.parametrize("answers", [[SEEN], [BLIND], [FREE, FREE], [SEEN, FREE, BLIND], [SEEN] * 200])
def test_every_replay_can_be_drawn(tmp_path, answers):
    write_plot(answers, tmp_path / "plot.png", "drive.bag", core.Settings())

    picture = imread(tmp_path / "plot.png")
    assert picture.shape[:2] == (840, 1500) and picture.std() > 0.05


def test_of_several_topics_each_row_names_its_own_and_each_is_summed_up():
    left, right = replace(SEEN, topic="/left"), replace(FREE, topic="/right")

    lines = printed(left, right, left)

    rows = [" ".join(line.split()) for line in lines if line[:1].isdigit()]
    assert [row.split()[1] for row in rows] == ["/left", "/right", "/left"]
    assert summary_of([left, right, left]).splitlines() == [
        "/left: 2 clouds: Safe 0, Warning 2, Danger 0", "/right: 1 cloud: Safe 1, Warning 0, Danger 0"]


def test_silences_are_those_of_each_topic(tmp_path):
    often = [replace(SEEN, topic="/left", time=number * 10**9) for number in range(4)]
    rare = [replace(SEEN, topic="/right", time=number * 10**9) for number in (0, 3)]

    found = silences([*often, *rare], 4 * 10**9, 1.5)

    assert [(one.topic, one.after, one.start, one.end) for one in found] == [("/right", 0, 1_500_000_000, 3 * 10**9)]


@pytest.mark.parametrize("right", [[SEEN], [SEEN, FREE, BLIND], [SEEN] * 5])
def test_topics_are_drawn_beside_each_other(tmp_path, right):
    answers = [*(replace(one, topic="/left") for one in (SEEN, FREE, BLIND)), *(replace(one, topic="/right") for one in right)]

    write_plot(answers, tmp_path / "plot.png", "drive.bag", core.Settings(), silences(answers, 10**12, 0.5))

    assert imread(tmp_path / "plot.png").shape[:2] == (840, 2100)
