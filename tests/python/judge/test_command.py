# SPDX-License-Identifier: BSD-3-Clause
"""The command as a user runs it: bags in, Parquet out."""
from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Dict, List

import pyarrow.parquet as pq
import pytest
from drives import wall, write_drive, write_drive2
from judge_rows import COMMAND, judge

from safety_control_cloud.judge.command import interrupt_behind


def bag_rows(out: Path) -> Dict[str, Dict[str, Any]]:
    return {Path(row["path"]).name: row for row in pq.read_table(out / "bags.parquet").to_pylist()}


def written(out: Path) -> Dict[str, int]:
    return {file.name: file.stat().st_mtime_ns for file in out.glob("clouds/*")}


@pytest.fixture
def drives(tmp_path) -> Path:
    folder = tmp_path / "drives"
    (folder / "deep").mkdir(parents=True)
    for number in range(3):
        write_drive(folder / f"{number}.bag", [wall(0.1 * n, 1.5 - 0.1 * n - 0.2 * number) for n in range(8)])
    write_drive2(folder / "deep" / "ros2", [wall(0.1 * n, 0.9) for n in range(8)])
    return folder


def test_a_folder_of_bags_gives_a_row_for_each_and_one_for_each_cloud(tmp_path, drives):
    result = judge(drives, "--out", tmp_path / "out")

    rows = bag_rows(tmp_path / "out")
    assert sorted(rows) == ["0.bag", "1.bag", "2.bag", "ros2"] and {row["clouds"] for row in rows.values()} == {8}
    assert dict(rows["0.bag"]["zones"]) == {"Safe": 5, "Warning": 3}
    clouds = pq.read_table(tmp_path / "out" / "clouds")
    assert clouds.num_rows == 32 and set(clouds.column("bag").to_pylist()) == {row["bag"] for row in rows.values()}
    assert "4 bags, 32 clouds, 0 silences" in result.stdout


def test_globs_are_understood_where_no_shell_has_done_it(tmp_path, drives):
    judge(f"{drives}/[01].bag", f"{drives}/*/*", "--out", tmp_path / "out")

    assert sorted(bag_rows(tmp_path / "out")) == ["0.bag", "1.bag", "ros2"]


def test_what_has_been_judged_is_not_judged_again(tmp_path, drives):
    judge(drives, "--out", tmp_path / "out")
    before = written(tmp_path / "out")
    write_drive(drives / "new.bag", [wall(0.0, 0.3)])
    (drives / "0.bag").rename(drives / "renamed.bag")

    judge(drives, "--out", tmp_path / "out")

    after = written(tmp_path / "out")
    assert {name: after[name] for name in before} == before and len(after) == len(before) + 1
    assert sorted(bag_rows(tmp_path / "out")) == ["1.bag", "2.bag", "new.bag", "renamed.bag", "ros2"]


def test_a_bag_that_has_changed_is_judged_anew(tmp_path, drives):
    judge(drives / "0.bag", "--out", tmp_path / "out")
    old = bag_rows(tmp_path / "out")["0.bag"]
    write_drive(tmp_path / "other.bag", [wall(0.1 * n, 0.3) for n in range(8)]).rename(drives / "0.bag")

    judge(drives / "0.bag", "--out", tmp_path / "out")

    new = bag_rows(tmp_path / "out")["0.bag"]
    assert new["bag"] != old["bag"] and dict(new["zones"]) == {"Danger": 8}


def test_other_settings_and_other_topics_are_judged_for_themselves(tmp_path, drives):
    for arguments in ([], ["--param", "danger_distance=0.95"], ["--topic", "/camera/depth/points"]):
        judge(drives / "0.bag", "--out", tmp_path / "out", *arguments)

    assert len(written(tmp_path / "out")) == 3


def test_a_bag_that_cannot_be_read_costs_its_own_row_alone(tmp_path, drives):
    whole = (drives / "0.bag").read_bytes()
    (drives / "cut.bag").write_bytes(whole[:-100])
    (drives / "text.bag").write_text("not a bag")
    (drives / "empty.bag").touch()
    broken = bytearray(whole)
    broken[len(whole) // 2 : len(whole) // 2 + 2000] = bytes(2000)
    (drives / "holes.bag").write_bytes(broken)

    result = judge(drives, drives / "missing.bag", "--out", tmp_path / "out", code=1)

    rows = bag_rows(tmp_path / "out")
    unreadable = {name for name, row in rows.items() if row["status"] == "error"}
    assert unreadable == {"cut.bag", "text.bag", "empty.bag", "holes.bag", "missing.bag"}
    assert all(name in rows[name]["error"] for name in unreadable) and len(rows) == 9
    assert rows["holes.bag"]["bag"] != rows["0.bag"]["bag"]
    assert "5 could not be read" in result.stdout and "Traceback" not in result.stderr


def test_comparing_two_settings_shows_where_they_differ_and_how_to_look(tmp_path, drives):
    (tmp_path / "a.yaml").write_text("danger_distance: 0.5\n")
    (tmp_path / "b.yaml").write_text("danger_distance: 0.85\n")

    result = judge(drives / "0.bag", "--out", tmp_path / "out", "--param", "x_max=1.9", "--compare", tmp_path / "a.yaml", tmp_path / "b.yaml")

    assert "0.bag /camera/depth/points cloud" in result.stdout and "Warning, SEEN, 0.1 m/s -> Danger, SEEN, 0 m/s" in result.stdout
    command = next(line for line in result.stdout.splitlines() if line.strip().startswith("scripts/replay")).split()
    assert command[-4:] == ["--settings", str(tmp_path / "b.yaml"), "--param", "x_max=1.9"]
    shown = subprocess.run([sys.executable, "-m", "safety_control_cloud.replay", *command[1:]], capture_output=True, text=True, timeout=60)
    assert shown.returncode == 0 and "Danger" in shown.stdout


@pytest.mark.parametrize("arguments, says", [
    ([], "BAG"), (["x.bag", "--jobs", "0"], "not above 0"), (["x.bag", "--param", "x"], "NAME=VALUE"),
    (["x.bag", "--param", "danger_distnce=1"], "no parameter danger_distnce"),
    (["x.bag", "--param", "danger_distance=near"], "danger_distance cannot be 'near'"),
    (["x.bag", "--param", "danger_distance=-1"], "danger_distance"), (["x.bag", "--settings", "none.yaml"], "none.yaml"),
    ([__file__, "--out", "/proc/nowhere"], "judge: --out /proc/nowhere: "),
    ([__file__, "--out", __file__], f"judge: --out {__file__}: File exists\n"),
    ([__file__, "--out", "/tmp", "--report", __file__], f"judge: --report {__file__}: File exists\n"), (["nope.bag"], "judge: nope.bag: no such file\n"),
    (["nope.bag", "no*pe.bag"], "judge: no*pe.bag: nothing has such a name, or no bag in it\n"),
    (["x.bag", "--mode", "guard", "--param", "mode=drive"], "--mode guard and --param mode=drive are two")])
def test_wrong_usage_is_exit_code_2_and_named(arguments, says):
    result = judge(*arguments, code=2)

    assert says in result.stderr and "Traceback" not in result.stderr


def test_a_folder_without_bags_is_nothing_to_judge_unless_another_has_some(tmp_path, drives):
    (tmp_path / "empty").mkdir()
    assert judge(tmp_path / "empty", code=2).stderr == f"judge: {tmp_path}/empty: no bag in it\n"
    result = judge(tmp_path / "empty", drives / "0.bag", "--out", tmp_path / "out", code=1)
    assert f"{tmp_path}/empty: no bag in it" in bag_rows(tmp_path / "out")["empty"]["error"]
    assert "1 could not be read" in result.stdout


@pytest.mark.parametrize("interrupt", [KeyboardInterrupt(), SystemExit(143), None])
def test_an_interrupt_is_not_hidden_by_what_it_broke(interrupt):
    try:
        try:
            raise interrupt or OSError("disk full")
        finally:
            raise RuntimeError("release unlocked lock")
    except RuntimeError as error:
        assert interrupt_behind(error) is interrupt


@pytest.mark.parametrize("number, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_an_interrupted_run_keeps_what_was_judged_and_goes_on_where_it_was(tmp_path, number, code):
    folder = tmp_path / "many"
    folder.mkdir()
    for bag in range(40):
        write_drive(folder / f"{bag:02}.bag", [wall(0.05 * n, 1.5 - 0.001 * bag) for n in range(200)])
    out = tmp_path / "out"
    running = subprocess.Popen([*COMMAND, str(folder), "--out", str(out)], stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline and len(written(out)) < 5:
        time.sleep(0.02)

    running.send_signal(number)

    assert (running.wait(30), running.stderr.read()) == (code, "")
    kept = written(out)
    assert 5 <= len(kept) < 40 and len(bag_rows(out)) >= 4 and not children_of(running.pid)
    assert not list(out.rglob("*.part")) and all(name.endswith(".parquet") for name in kept)
    judge(folder, "--out", out)
    after = written(out)
    assert len(after) == 40
    assert {name: after[name] for name in kept} == kept


def children_of(pid: int) -> List[int]:
    listing = subprocess.run(["ps", "-o", "pid=", "--ppid", str(pid)], capture_output=True, text=True).stdout
    return [int(child) for child in listing.split() if os.path.exists(f"/proc/{child}")]
