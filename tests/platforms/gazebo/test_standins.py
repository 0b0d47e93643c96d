# SPDX-License-Identifier: BSD-3-Clause
"""The stand-ins of gazebo_ros' plugins refuse a parameter that the real ones do not read: a test with them tests the model."""
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

rospkg = pytest.importorskip("rospkg", reason="no stand-ins of gazebo_ros: no ROS")

from safety_control_cloud.processes import process  # noqa: E402
from safety_control_cloud.ros_session import executable_of, roscore  # noqa: E402

URDF = Path(__file__).parents[3] / "safety_control_cloud/urdf/turtlebot.urdf"
SECONDS = 60  # that Gazebo may take to come up
# In a process of its own, for rospy keeps to its first master.
SPAWN_AND_DELETE = """
import rospy
from safety_control_cloud.nodes.gazebo_models import delete, spawn
from safety_control_cloud.simulation.furniture import Place, Shape, Thing
rospy.init_node("spawner", disable_rostime=True)
for number in range(150):
    spawn(Thing(f"box_{number}", Place(2.0, 0.0, 0.15), (Shape("box", "box", (0.15, 0.15, 0.15), Place()),)))
    delete(f"box_{number}")
"""


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


def test_models_come_and_go_while_the_robot_rests_on_its_wheels(monkeypatch):
    monkeypatch.setenv("GAZEBO_MASTER_URI", "http://127.0.0.1:11399")
    with roscore():
        with process([executable_of("safety_control_cloud", "gazebo_world"), "--rate", "0", "--size", "64x48", "--urdf", str(URDF)]) as gazebo:
            spawner = subprocess.run(["timeout", str(10 * SECONDS), sys.executable, "-c", SPAWN_AND_DELETE], stderr=subprocess.PIPE, text=True)
            assert spawner.returncode == 0, f"{spawner.stderr}\n{gazebo.output()}"
