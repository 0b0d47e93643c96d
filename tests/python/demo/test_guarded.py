# SPDX-License-Identifier: BSD-3-Clause
"""The demo of the guard, without ROS's processes: what is drawn, and what is asked for."""
from __future__ import annotations

import pytest

from safety_control_cloud.demo.__main__ import main
from safety_control_cloud.simulation.base import Pose, Velocity
from safety_control_cloud.simulation.furniture import furniture_of
from safety_control_cloud.simulation.world_files import world_file
from safety_control_cloud.trials.guarded.drawing import Spot, draw


def test_the_way_in_the_playground_is_drawn(tmp_path):
    from safety_control_cloud.demo.guarded import _blocks, _rude

    furniture = furniture_of(world_file("playground"))
    assert {one.round for one in _blocks(furniture)} == {False, True}
    driver, spots = _rude(furniture, 1), []
    for i in range(200):
        wanted = driver.wants(0.05 * i, Pose(0.01 * i, 0.0, 0.0), Velocity(0.2))
        factor = float(i % 40 > 20)
        spots.append(Spot(0.05 * i, Pose(0.01 * i), wanted, Velocity(factor * wanted.linear, factor * wanted.angular), factor))
    assert any(spot.is_stopped for spot in spots)
    draw(tmp_path / "a.png", "a title", spots, _blocks(furniture), None, [(1.0, 0.0)])
    assert (tmp_path / "a.png").stat().st_size > 30_000


@pytest.mark.parametrize("option", ["--patience", "--seconds"])
@pytest.mark.parametrize("text", ["-1", "0", "nan", "inf"])
def test_a_time_that_nobody_can_wait_is_refused(option, text, capsys, tmp_path):
    with pytest.raises(SystemExit) as ended:
        main(["guard", "--simulator", "gazebo", "--out", str(tmp_path), option, text])
    assert ended.value.code == 2
    assert f"argument {option}: {text} is not " in capsys.readouterr().err


def test_a_seed_of_which_no_random_numbers_come_is_refused(capsys, tmp_path):
    with pytest.raises(SystemExit) as ended:
        main(["guard", "--out", str(tmp_path), "--seed", "-5"])
    assert ended.value.code == 2 and "argument --seed: -5 is below 0" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--seconds", "--seed"])
def test_what_is_the_guards_is_refused_without_him(option, capsys, tmp_path):
    with pytest.raises(SystemExit) as ended:
        main(["--out", str(tmp_path), option, "1"])
    assert ended.value.code == 2 and f"{option} goes with guard" in capsys.readouterr().err


def test_the_guard_is_shown_in_mujoco_alone(capsys, tmp_path):
    with pytest.raises(SystemExit) as ended:
        main(["guard", "--simulator", "gazebo", "--out", str(tmp_path)])
    assert ended.value.code == 2
    assert "mujoco" in capsys.readouterr().err
