# SPDX-License-Identifier: BSD-3-Clause
import socket
import threading
import time

import pytest

pytest.importorskip("roslib")

from safety_control_cloud import gazebo_ros  # noqa: E402
from safety_control_cloud.commands import gazebo_world  # noqa: E402
from safety_control_cloud.processes import ProcessError  # noqa: E402


@pytest.fixture
def ran(monkeypatch):
    """The commands that would have been run."""
    commands = []
    monkeypatch.setattr(gazebo_ros, "gazebo_ros_executable", lambda name: f"/ros/{name}")
    monkeypatch.setattr(gazebo_world, "_run", lambda command: commands.append(command) or 0)
    return commands


@pytest.mark.parametrize("arguments", [["--window"], ["--urdf", "robot.urdf"]])
def test_without_gazebo_ros_one_line_says_what_to_install(arguments, monkeypatch, capsys):
    def missing(name):
        raise ProcessError(gazebo_ros.MISSING)

    monkeypatch.setattr(gazebo_ros, "gazebo_ros_executable", missing)
    assert gazebo_world.main(["gazebo_world", *arguments]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "apt-get install ros-noetic-gazebo-ros-pkgs" in said


def test_the_window_opens_when_gazebo_has_come_up(ran, monkeypatch):
    gazebo = socket.socket()
    gazebo.bind(("127.0.0.1", 0))
    monkeypatch.setenv("GAZEBO_MASTER_URI", "http://127.0.0.1:%d" % gazebo.getsockname()[1])
    up_at = time.monotonic() + 0.3
    threading.Timer(0.3, gazebo.listen).start()
    assert gazebo_world.main(["gazebo_world", "--window", "__name:=gazebo_window"]) == 0
    assert time.monotonic() >= up_at
    assert ran == [["/ros/gzclient", "__name:=gazebo_window"]]
    gazebo.close()


def test_a_window_for_which_no_gazebo_comes_up_says_so(ran, monkeypatch, capsys):
    monkeypatch.setattr(gazebo_world, "_PATIENCE", 0.0)
    monkeypatch.setenv("GAZEBO_MASTER_URI", "http://127.0.0.1:1")
    assert gazebo_world.main(["gazebo_world", "--window"]) == 2
    assert ran == [] and "no Gazebo answers at http://127.0.0.1:1" in capsys.readouterr().err


LYING = '<mujoco><worldbody><geom type="cylinder" size="1 1" euler="90 0 0"/></worldbody></mujoco>'


@pytest.mark.parametrize("mjcf, reason", [("", "no element found"), (LYING, "only what stands upright"), (None, "no world")])
def test_a_world_that_cannot_be_had_in_gazebo_is_refused_in_one_line(mjcf, reason, ran, tmp_path, capsys):
    world = tmp_path / "world.xml"
    if mjcf is not None:
        world.write_text(mjcf)
    assert gazebo_world.main(["gazebo_world", "--urdf", "robot.urdf", "--world", str(world)]) == 2
    said = capsys.readouterr().err
    assert ran == [] and said.count("\n") == 1 and reason in said
