# SPDX-License-Identifier: BSD-3-Clause
"""scripts/judge --mode guard as a user runs it."""
from __future__ import annotations

import html
import json
import re
import shlex
from pathlib import Path
from typing import Any, Dict, List

import pyarrow.parquet as pq
import pytest
from drives import write_drive, write_drive2
from guard_answers import told
from guard_drives import commanded, driven_at_wall
from judge_rows import judge

VISIBLE = ("number", "time", "asked_by", "wanted_x", "given_x", "given_turn", "factor", "cause", "sensor")


@pytest.fixture(scope="module")
def drives(tmp_path_factory) -> Path:
    """With a camera that both modes look at."""
    folder = tmp_path_factory.mktemp("drives") / "Fahrt über 走廊"
    folder.mkdir()
    for number in range(3):
        write_drive(folder / f"{number} é.bag", driven_at_wall(2.6, gap=0.9 + 0.4 * number, sensors=("camera", "laser")))
    write_drive2(folder / "zwei", driven_at_wall(1.0))
    return folder


def bag_rows(out: Path) -> Dict[str, Dict[str, Any]]:
    return {Path(row["path"]).name: row for row in pq.read_table(out / "guard" / "bags.parquet").to_pylist()}


def written(out: Path) -> Dict[str, int]:
    return {str(file.relative_to(out)): file.stat().st_mtime_ns for file in out.glob("**/*-*.parquet")}


def test_a_folder_is_judged_in_both_modes_one_after_the_other_and_each_once(tmp_path, drives):
    out = tmp_path / "out"
    judge(drives, "--out", out)
    by_drive, bags = written(out), (out / "bags.parquet").read_bytes()
    assert len(by_drive) == 4

    first = judge(drives, "--mode", "guard", "--out", out)
    by_both, guarded = written(out), (out / "guard" / "bags.parquet").read_bytes()
    again, back = judge(drives, "--param", "mode=guard", "--out", out), judge(drives, "--out", out)

    assert len(by_both) == 8 and {name: by_both[name] for name in by_drive} == by_drive
    assert written(out) == by_both and first.stdout == again.stdout and "30 clouds" not in first.stdout and "clouds" in back.stdout
    assert ((out / "bags.parquet").read_bytes(), (out / "guard" / "bags.parquet").read_bytes()) == (bags, guarded)
    rows = bag_rows(out)
    assert sorted(rows) == ["0 é.bag", "1 é.bag", "2 é.bag", "zwei"] and all(row["status"] == "judged" for row in rows.values())
    assert rows["0 é.bag"]["stopped"] > 0 == rows["2 é.bag"]["stopped"]
    answers = pq.read_table(out / "guard" / "answers")
    assert answers.num_rows == sum(row["answers"] for row in rows.values())
    assert pq.read_table(out / "clouds").num_rows == sum(pq.read_table(out / "bags.parquet").column("clouds").to_pylist())


def test_two_processes_write_what_one_does(tmp_path, drives):
    for jobs in (1, 2):
        judge(drives, drives / "0 é.bag", "--mode", "guard", "--out", tmp_path / str(jobs), "--jobs", jobs)

    one, two = ({name: pq.read_table(tmp_path / jobs / name).to_pylist() for name in written(tmp_path / jobs)} for jobs in "12")
    assert one == two and len(one) == 4 and bag_rows(tmp_path / "1") == bag_rows(tmp_path / "2")


def test_comparing_two_guards_shows_what_each_gives_first_and_how_to_look(tmp_path, drives):
    (tmp_path / "now.yaml").write_text("mode: guard\n")
    (tmp_path / "wide margin.yaml").write_text("mode: guard\nmargin: 0.1\n")

    result = judge(drives, "--out", tmp_path / "out", "--topic", "/scan", "--topic", "/camera/depth/points", "--param", "sensor_period=0.2",
                   "--compare", tmp_path / "now.yaml", tmp_path / "wide margin.yaml", "--report", tmp_path / "page", code=1)  # one of them has no laser

    assert "are guarded differently" in result.stdout or "is guarded differently" in result.stdout
    lines = result.stdout.splitlines()
    place, line = next((number, line) for number, line in enumerate(lines) if line.strip().startswith("scripts/replay"))
    assert lines[place - 1].startswith(str(drives / "0 é.bag")) and "Safe, SEEN, 0.300" in lines[place - 1].partition(" -> ")[0]
    words = shlex.split(line)[1:]
    replayed = told(tmp_path, *words)
    at = float(lines[place - 1].partition("first at ")[2].partition(" s:")[0])
    shown = [one for one in replayed if abs(one["time"] - replayed[0]["time"] - at) < 1e-3]
    assert shown and shown[-1]["given"] != shown[-1]["wanted"]
    assert "wide margin.yaml" in line and "sensor_period=0.2" in line and words.count("--topic") == 2
    assert_page((tmp_path / "page" / "index.html").read_text(), words)


def assert_page(text: str, command: List[str]) -> None:
    """It has bags, stops and changes, and needs nothing but itself."""
    assert text.count('class="timelines"') == text.count('class="error"') == 2 and "Danger from" in text and "What changes" in text
    shown = [shlex.split(html.unescape(found))[1:] for found in re.findall(r"<code>(scripts/replay .*?)</code>", text)]
    assert {Path(words[words.index("--settings") + 1]).name for words in shown} == {"now.yaml", "wide margin.yaml"}
    assert command in shown and "<script" not in text and "http" not in text


def test_bags_that_differ_in_nothing_are_not_told(tmp_path, drives):
    (tmp_path / "now.yaml").write_text("mode: guard\n")
    (tmp_path / "free.yaml").write_text("mode: guard\nwarning_distance: 1.3\n")

    result = judge(drives / "2 é.bag", "--out", tmp_path / "out", "--compare", tmp_path / "now.yaml", tmp_path / "free.yaml")

    assert "0 bags are guarded differently" in result.stdout


def test_a_bag_of_no_commands_costs_its_own_row(tmp_path):
    write_drive(tmp_path / "none.bag", [record for record in driven_at_wall(1.0) if record.topic != "/cmd_vel"])
    write_drive(tmp_path / "two.bag", [*driven_at_wall(1.0), commanded(0.5, 0.1, topic="/joy/cmd_vel")])
    write_drive(tmp_path / "empty.bag", [])
    (tmp_path / "cut.bag").write_bytes((tmp_path / "two.bag").read_bytes()[:-100])

    result = judge(tmp_path, "--mode", "guard", "--out", tmp_path / "out", code=1)

    errors = {name: row["error"] for name, row in bag_rows(tmp_path / "out").items() if row["status"] == "error"}
    assert sorted(errors) == ["cut.bag", "empty.bag", "none.bag", "two.bag"]
    assert "a guard has nothing to guard" in errors["none.bag"] and "say which by --cmd-vel" in errors["two.bag"]
    assert "4 could not be read to the end" in result.stdout and "Traceback" not in result.stderr
    judge(tmp_path / "two.bag", "--mode", "guard", "--cmd-vel", "joy/cmd_vel", "--out", tmp_path / "out")
    assert bag_rows(tmp_path / "out")["two.bag"]["commands"] == 1


@pytest.mark.parametrize("arguments, says", [
    (["--cmd-vel", "/cmd_vel"], "--cmd-vel and --odom are of --mode guard"),
    (["--compare", "drive.yaml", "guard.yaml"], "drive.yaml and guard.yaml are of two modes: --mode says which"),
    (["--mode", "guard", "--param", "odom_frame=odom", "--odom", "/odom"], "either odom_frame or --odom"),
    (["--mode", "guard", "--param", "command_type=text"], "command_type")])
def test_what_does_not_fit_the_mode_is_told_in_a_line(tmp_path, monkeypatch, arguments, says):
    monkeypatch.chdir(tmp_path)
    Path("drive.yaml").write_text("{}\n")
    Path("guard.yaml").write_text(json.dumps({"mode": "guard"}))

    result = judge("x.bag", *arguments, code=2)

    assert says in result.stderr and len(result.stderr.splitlines()) == 1
