# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from rich.console import Console

from safety_control_cloud.trials import names
from safety_control_cloud.trials.command import run
from safety_control_cloud.trials.families import FAMILIES, scenario_of
from safety_control_cloud.trials.options import options
from safety_control_cloud.trials.telling import tell


def test_every_family_can_be_asked_for_by_name():
    assert names.FAMILIES == tuple(FAMILIES)


def test_a_drive_to_replay_is_named_by_family_and_seed():
    assert options(["--replay", "wall:7"]).replay == ("wall", 7)


@pytest.mark.parametrize(
    "arguments", [["--replay", "wall"], ["--replay", "nowhere:1"], ["--jobs", "0"], ["--video", "a.gif"], ["--family", "x"],
                  ["--rrd", "a.rrd"], ["--view"], ["--strays", "0"], ["--replay", "wall:1", "--strays", "2"], ["--replay", "wall:1", "--rrd", "a.txt"],
                  ["--seed", "-5"], ["--replay", "wall:1", "--json", "a.json"], ["--replay", "wall:1", "--report", "a"],
                  ["--replay", "wall:1", "--episodes", "5"], ["--replay", "wall:1", "--seed", "5"], ["--replay", "wall:1", "--family", "wall"],
                  ["--replay", "wall:1", "--video", "a.mp4"]]
)
def test_what_cannot_be_driven_is_refused(arguments, capsys):
    with pytest.raises(SystemExit) as ended:
        options(arguments)
    assert ended.value.code == 2
    assert "usage" in capsys.readouterr().err


@pytest.mark.parametrize(
    "arguments", [["--report", "/proc/nowhere"], ["--report", "{file}"], ["--json", "/nowhere/a.json"], ["--json", "/"],
                  ["--replay", "wall:1", "--video", "/nowhere/a.gif"], ["--replay", "wall:1", "--rrd", "/proc/a.rrd"]])
def test_what_cannot_be_written_is_refused_before_the_drives(arguments, capsys, tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(SystemExit) as ended:
        options([word.format(file=tmp_path / "file") for word in arguments])
    assert ended.value.code == 2
    assert "cannot write" in capsys.readouterr().err.splitlines()[-1]


@pytest.mark.parametrize("command", [
    ["-m", "safety_control_cloud.demo", "--out", "/proc/nowhere"],
    [str(Path(__file__).resolve().parents[2] / "benchmarks"), "--json", "/nowhere/a.json"]])
def test_demo_and_bench_too_refuse_it_at_once(command):
    result = subprocess.run([sys.executable, *command], capture_output=True, text=True, timeout=60)
    assert result.returncode == 2 and "cannot write" in result.stderr.splitlines()[-1]


@pytest.mark.parametrize("option", ["--repetitions", "--clouds"])
def test_nothing_is_measured_less_than_once(option):
    bench = Path(__file__).resolve().parents[2] / "benchmarks"
    result = subprocess.run([sys.executable, bench, option, "0"], capture_output=True, text=True, timeout=60)
    assert result.returncode == 2 and result.stderr.splitlines()[-1].endswith(f"argument {option}: 0 is not above 0")


def test_who_interrupts_it_is_told_of_the_drives_that_were_done(monkeypatch, capsys, tmp_path):
    from safety_control_cloud.trials import run as running

    def interrupted(jobs, drive, crew):
        yield jobs[0], drive(jobs[0])
        raise KeyboardInterrupt

    monkeypatch.setattr(running, "shared_out", interrupted)
    given = options(["--family", "wall", "--episodes", "2", "--method", "ours", "--jobs", "1", "--json", str(tmp_path / "out.json")])
    with pytest.raises(KeyboardInterrupt):
        run(given)
    told = capsys.readouterr()
    assert "in 1 drives" in told.out and "interrupted: 1 of 2 drives" in told.err
    assert len(json.loads((tmp_path / "out.json").read_text())["episodes"]) == 1


def test_a_drive_is_told_and_filmed(tmp_path):
    console = Console(record=True, width=130)
    tell(scenario_of("wall_in_the_blind_zone", 1), ["tutorial"], tmp_path / "out.gif", console)
    told = console.export_text()
    assert "wall_in_the_blind_zone:1" in told and "end" in told
    assert (tmp_path / "out.gif").stat().st_size > 10_000


def test_a_wall_too_near_to_return_anything_is_free_to_the_tutorial_and_a_stray_is_an_obstacle(capsys):
    told = []
    for strays in ("0", "0.1"):
        assert run(options(["--replay", "wall_in_the_blind_zone:1", "--method", "tutorial", "--strays", strays])) == 0
        told.append("ran into wall" in capsys.readouterr().out)
    assert told == [True, False]
