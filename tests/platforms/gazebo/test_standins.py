# SPDX-License-Identifier: BSD-3-Clause
"""The stand-ins of gazebo_ros' plugins refuse a parameter that the real ones do not read: a test with them tests the model."""
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest

rospkg = pytest.importorskip("rospkg", reason="no stand-ins of gazebo_ros: no ROS")

from safety_control_cloud.ros_session import executable_of, roscore  # noqa: E402

URDF = Path(__file__).parents[3] / "safety_control_cloud/urdf/turtlebot.urdf"
SECONDS = 60  # that Gazebo may take to come up


def standins_are_here():
    try:
        return "stand-in" in rospkg.RosPack().get_manifest("gazebo_ros").description
    except rospkg.ResourceNotFound:
        return False


pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not standins_are_here(), reason="no stand-ins of gazebo_ros: its own plugins, or none"),
]


def gazebo_with(urdf, monkeypatch):
    """How it ended (`timeout` says 124 if it did not by itself), and what it said."""
    monkeypatch.setenv("GAZEBO_MASTER_URI", "http://127.0.0.1:11399")
    with roscore():
        command = [executable_of("safety_control_cloud", "gazebo_world"), "--size", "64x48", "--urdf", urdf]
        return subprocess.run(["timeout", "-s", "INT", str(SECONDS), *command], stderr=subprocess.PIPE, text=True)


@pytest.mark.parametrize("plugin", ["libgazebo_ros_diff_drive.so", "libgazebo_ros_openni_kinect.so"])
def test_a_parameter_that_no_real_plugin_reads_ends_the_server(plugin, tmp_path, monkeypatch):
    robot = ElementTree.parse(URDF)
    found = next(one for one in robot.iter("plugin") if one.get("filename") == plugin)
    ElementTree.SubElement(found, "wheelSeperation").text = "0.23"
    robot.write(tmp_path / "robot.urdf")
    ended = gazebo_with(str(tmp_path / "robot.urdf"), monkeypatch)
    assert f"{plugin} does not know <wheelSeperation>" in ended.stderr
    assert ended.returncode == 1
