# SPDX-License-Identifier: BSD-3-Clause
import sys

import pytest

pytest.importorskip("roslib")

from safety_control_cloud import gazebo_ros  # noqa: E402
from safety_control_cloud.commands import gazebo_turtlebot  # noqa: E402


def told(capsys, *arguments):
    assert gazebo_turtlebot.main(["gazebo_turtlebot", *arguments]) == 2
    return capsys.readouterr().err


def test_a_world_that_is_not_there_is_told_in_a_line(capsys):
    said = told(capsys, "--world", "nonsense")
    assert said.startswith("gazebo_turtlebot: no world 'nonsense'") and said.count("\n") == 1


def test_without_gazebo_ros_one_line_says_what_to_install(capsys, monkeypatch):
    monkeypatch.delitem(sys.modules, "safety_control_cloud.nodes.gazebo_turtlebot", raising=False)
    monkeypatch.setitem(sys.modules, "gazebo_msgs", None)
    assert told(capsys) == f"gazebo_turtlebot: {gazebo_ros.MISSING}\n"
