# SPDX-License-Identifier: BSD-3-Clause
"""Mode guard on many bags: the rows are what scripts/replay --mode guard says of each."""
from __future__ import annotations

import json
import math
import weakref
from typing import Any, Dict, List, Mapping

import numpy as np
import pytest
from drives import SECOND, camera, depth, write_drive, write_drive2, write_mcap
from guard_answers import SENSORS, told
from guard_drives import at, camera_placed, commanded, driven_at_wall, hall_with_wall, moved, scan, touched
from judge_rows import judged, rows_in

from safety_control_cloud.replay.bags import opened
from safety_control_cloud.replay.guard.inputs import inputs_in
from safety_control_cloud.replay.guard.reading import Reading

GUARD = {"mode": "guard"}
BUMPERS = {"switches": [{"name": name, "type": "bumper", "topic": name, "side": name} for name in ("front", "rear")]}
PLANAR = (("x", "linear", 0), ("y", "linear", 1), ("turn", "angular", 2))


def stamped() -> List[Any]:
    records = [record for record in driven_at_wall(sensors=["laser"]) if record.topic != "/cmd_vel"]
    return [*records, *(commanded(0.1 * n + 0.05, 0.2, stamp=0.1 * n + 0.04 - 2.0 * (n > 15)) for n in range(2, 29))]


def by_depth_image() -> List[Any]:
    records = [camera_placed(), *(commanded(0.1 * n + 0.01, 0.2, 0.1 * n) for n in range(1, 15))]
    for number in range(15):
        picture = np.full((48, 64), 3000 - 180 * number, np.uint16)
        records += [depth(0.1 * number, picture), camera(0.1 * number, 64, 48, 50.0)]
    return records


def by_tf() -> List[Any]:
    drive = driven_at_wall()
    moving = [moved(record.time / SECOND, at(record.time / SECOND)) for record in drive if record.topic == "/odom"]
    return [record for record in drive if record.topic != "/odom"] + moving


def with_gaps() -> List[Any]:
    return [record for record in driven_at_wall(gap=4.0, sensors=["laser"])
            if not (record.topic == "/cmd_vel" and 1.0 * SECOND < record.time < 2.0 * SECOND)
            and not (record.topic == "/scan" and record.time > 2.2 * SECOND)]


DRIVES: Dict[str, Any] = {
    "camera": (write_drive, driven_at_wall(), {}),
    "laser": (write_drive, driven_at_wall(sensors=["laser"]), {}),
    "both": (write_drive, driven_at_wall(sensors=("camera", "laser")), {}),
    "both by the settings": (write_drive, driven_at_wall(sensors=("camera", "laser")), {"sensors": SENSORS}),
    "one of both by the settings": (write_drive, driven_at_wall(sensors=("camera", "laser")), {"input": "cloud"}),
    "stamped commands": (write_drive2, stamped(), {}),
    "mcap": (write_mcap, driven_at_wall(sensors=["laser"]), {"margin": 0.1}),
    "switches": (write_drive, [*driven_at_wall(gap=4.0), touched(1.5, True, "/front"), touched(2.0, False, "/front")], BUMPERS),
    "no odometry": (write_drive, [record for record in driven_at_wall() if record.topic != "/odom"], {}),
    "odometry by TF": (write_drive, by_tf(), {"odom_frame": "odom"}),
    "depth images": (write_drive, by_depth_image(), {}),
    "gaps": (write_drive, with_gaps(), {}),
    "no number wanted": (write_drive, [*driven_at_wall(), commanded(1.2, math.nan), commanded(1.3, math.inf)], {}),
}


def as_replayed(row: Mapping[str, Any]) -> Dict[str, Any]:
    """In the words of --json."""
    same = ("asked_by", "factor", "cause", "reason", "stuck", "differs")
    driven = [finite(row[f"driven_{part}"]) for part, _, _ in PLANAR]
    return {
        **{name: row[name] for name in same}, "time": row["time"] / 1e9, "sensor": row["sensor"] or "",
        "wanted": [finite(row[f"wanted_{part}"]) for part, _, _ in PLANAR],
        "given": [finite(row[f"given_{part}"]) for part, _, _ in PLANAR], "driven": None if driven[0] is None else driven,
        "time_to_contact": finite(row["time_to_contact"]), "point": None if row["x"] is None else [row["x"], row["y"]]}


def finite(value: Any) -> Any:
    return value if value is not None and math.isfinite(value) else None


def planar(answer: Mapping[str, Any]) -> Dict[str, Any]:
    return {**answer, **{name: [answer[name][kind][place] for _, kind, place in PLANAR] for name in ("wanted", "given")}}


@pytest.mark.parametrize("name", DRIVES)
def test_the_rows_are_the_answers_of_replay_in_every_bit(tmp_path, name):
    write, records, settings = DRIVES[name]
    bag = write(tmp_path / "drive.bag" if write is write_drive else tmp_path / "drive", records)
    (tmp_path / "guard.yaml").write_text(json.dumps(settings))

    answer = judged(bag, {**GUARD, **settings})

    rows, answers = rows_in(answer.files[0]), told(tmp_path, bag, "--settings", tmp_path / "guard.yaml")
    assert [as_replayed(row) for row in rows] == [planar(one) for one in answers] and len(rows) > 15
    assert [row["number"] for row in rows] == list(range(len(rows)))
    assert answer.rows[0].status == "judged" and answer.rows[0].answers == len(rows)


def test_a_bags_row_counts_its_commands_as_replay_does(tmp_path, capsys):
    bag = write_drive(tmp_path / "drive.bag", driven_at_wall(sensors=("camera", "laser")))

    (row,) = judged(bag, GUARD).rows

    told(tmp_path, bag)
    assert (f"{row.commands} commands: {row.passed} pass, {row.scaled} scaled, {row.stopped} stopped; "
            f"{row.early} before the first picture") in (said := capsys.readouterr().out)
    assert f"differs first at {(row.differs_at - row.start) / 1e9:.3f} s: " in said and f"for {row.differs_for:.1f} s in all" in said
    assert f"{row.differs_cause} by {row.differs_sensor}; for" in said
    assert 0.0 < row.stopped_for < row.differs_for and sum(row.causes.values()) == row.answers
    assert row.topics == ["/cmd_vel", "/odom", "/camera/depth/points", "/scan"]


def test_what_replay_tells_beside_its_table_stands_in_the_bags_row(tmp_path):
    always = [record if record.topic != "/scan" else scan(record.time / SECOND, hall_with_wall(4.0, record.time), age=5.0 * (number % 2))
              for number, record in enumerate(driven_at_wall(seconds=6.0, gap=4.0, sensors=["laser"]))]

    (row,) = judged(write_drive(tmp_path / "jumps.bag", always), {**GUARD, **BUMPERS}).rows

    assert "nothing of the switch front was recorded: it is taken for released" in row.warnings
    jumps = [words for words in row.warnings if "jump" in words]
    assert len(jumps) == 21 and jumps[-1].endswith("times more") and row.status == "judged"


def test_the_answers_before_the_damage_are_there(tmp_path):
    whole = write_drive(tmp_path / "whole.bag", driven_at_wall(sensors=["laser"]))
    content = bytearray(whole.read_bytes())
    cut = content.rindex(b"topic=/scan")
    content[cut - 400 : cut] = bytes(400)
    (tmp_path / "damaged.bag").write_bytes(content)

    before, after = judged(whole, GUARD), judged(tmp_path / "damaged.bag", GUARD)

    assert after.rows[0].status == "error" and "damaged.bag" in after.rows[0].error
    rows, all_rows = rows_in(after.files[0]), rows_in(before.files[0])
    assert [as_replayed(row) for row in rows] == [as_replayed(row) for row in all_rows[: len(rows)]]
    assert after.rows[0].answers == len(rows)


def test_topics_are_taken_by_their_names_and_make_another_answer(tmp_path):
    records = [*driven_at_wall(sensors=("camera", "laser")), *(commanded(0.1 * n, 0.05, topic="/joy/cmd_vel") for n in range(30))]
    bag = write_drive(tmp_path / "drive.bag", records)

    answer = judged(bag, GUARD, ["/scan"], cmd_vel="joy/cmd_vel", odom="/odom")

    assert answer.rows[0].topics == ["/joy/cmd_vel", "/odom", "/scan"] and answer.rows[0].commands + answer.rows[0].early == 30
    hashes = {judged(bag, {**GUARD, **given}, topics, cmd_vel="joy/cmd_vel").rows[0].settings
              for topics in ([], ["/scan"], ["/camera/depth/points"]) for given in ({}, {"input": "cloud"})}
    assert len({answer.rows[0].settings, *hashes}) == 7  # also an input that is given says which sensors there are


def test_no_answer_is_kept(tmp_path):
    bag, heard, alive = write_drive(tmp_path / "drive.bag", driven_at_wall()), [], []

    def hear(answer: Any) -> None:
        heard.append(weakref.ref(answer))
        alive.append(sum(one() is not None for one in heard))

    with opened([bag]) as bags:
        reading = Reading(bags, inputs_in(bags, GUARD), hear)
        for message in bags.messages(reading.topics):
            reading.take(message)
        reading.end()

    assert len(heard) > 60 and max(alive) <= 2
