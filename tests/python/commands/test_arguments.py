# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be is refused while arguments are read, before a master is asked."""
import sys

import pytest

from safety_control_cloud.commands import gazebo_world, turtlebot_sim, view_node


@pytest.mark.parametrize("option, text, reason", [
    ("--world", "nonsense", "no world 'nonsense'"),
    *(("--camera-rate", text, f"{text} is not a number above 0") for text in ("-3", "0", "nan", "inf")),
    ("--camera-rate", "200", "200 is more than 100"),
    ("--size", "0x480", "0 is not above 0"), ("--size", "640x-4", "-4 is not above 0"), ("--size", "640", "invalid picture_size value: '640'"),
    ("--size", "10000000x10000000", "10000000x10000000 is more than 4096x4096"), ("--seed", "-5", "-5 is below 0"),
    *(("--rate", text, f"{text} is not 0 or a number above") for text in ("-1", "nan", "inf")),
])
def test_what_cannot_be_simulated_is_refused(option, text, reason, capsys):
    with pytest.raises(SystemExit) as ended:
        turtlebot_sim.parser().parse_args([option, text])
    assert ended.value.code == 2
    assert f"argument {option}: {reason}" in capsys.readouterr().err


@pytest.mark.parametrize("command", [gazebo_world, view_node])
def test_a_rate_below_zero_is_refused(command, capsys):
    with pytest.raises(SystemExit) as ended:
        command.main(["command", "--rate", "-1", "--rrd", "a.txt"])  # neither knows such a file: none of them starts
    assert ended.value.code == 2
    assert "argument --rate: -1 is not " in capsys.readouterr().err


def test_as_fast_as_it_goes_can_be_simulated_in_a_world_of_the_users(tmp_path, monkeypatch):
    (tmp_path / "mine.xml").touch()
    monkeypatch.chdir(tmp_path)
    given = turtlebot_sim.parser().parse_args(["--rate", "0", "--world", "mine.xml"])
    assert (given.rate, given.world) == (0.0, str(tmp_path / "mine.xml"))


def test_a_world_that_mujoco_cannot_read_is_told_in_a_line_before_a_master_is_asked(tmp_path, capsys):
    pytest.importorskip("rospy")
    (tmp_path / "a.yaml").write_text("a: b\n")
    assert turtlebot_sim.main(["turtlebot_sim", "--world", str(tmp_path / "a.yaml")]) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"turtlebot_sim: cannot simulate {tmp_path}/a.yaml: ") and said.count("\n") == 1


def test_without_mujoco_one_line_says_who_installs_it(monkeypatch, capsys):
    pytest.importorskip("rospy")
    for name in [name for name in sys.modules if name.startswith("safety_control_cloud.simulation") or name.endswith("nodes.turtlebot_sim")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "mujoco", None)
    assert turtlebot_sim.main(["turtlebot_sim"]) == 2
    assert capsys.readouterr().err == "turtlebot_sim: this needs MuJoCo, which scripts/setup installs beside the package\n"
