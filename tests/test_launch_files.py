# SPDX-License-Identifier: BSD-3-Clause
"""Launch files find what they need wherever they lie: robot_upstart copies them to /etc/ros."""
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml

LAUNCH = Path(__file__).resolve().parent.parent / "safety_control_cloud" / "launch"

FILES = sorted(path.name for path in LAUNCH.glob("safety_control*.launch"))

pytestmark = pytest.mark.skipif(shutil.which("roslaunch") is None, reason="roslaunch is not installed")


@pytest.mark.parametrize("file", FILES)
def test_a_copy_elsewhere_starts_the_same(file, tmp_path):
    shutil.copy(LAUNCH / file, tmp_path / file)
    told = [
        subprocess.run(["roslaunch", "--dump-params", folder / file], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        for folder in (LAUNCH, tmp_path)
    ]
    assert told[1].returncode == 0, told[1].stderr
    assert yaml.safe_load(told[1].stdout) == yaml.safe_load(told[0].stdout)


@pytest.mark.parametrize("file", FILES)
def test_in_a_namespace_its_topics_are_those_of_the_robot_there(file, tmp_path):
    """What is remapped must be named as the node names it, without a leading slash."""
    robot = tmp_path / "robot.launch"
    robot.write_text(
        f'<launch><group ns="robot1"><include file="{LAUNCH / file}"><arg name="cloud" value="cam/points"/></include></group></launch>')
    told = subprocess.run(["roslaunch", "--args", "/robot1/safety_control_cloud", robot], stdout=subprocess.PIPE, text=True).stdout
    assert "ROS_NAMESPACE=" in told and " camera/depth/points:=cam/points " in told
    assert not any(word.startswith("/") for word in told.split() if ":=" in word)


@pytest.mark.parametrize("manager, starts", [
    ("", "/safety_control_node "), ("camera/manager", "/nodelet load safety_control_cloud/SafetyControlNodelet camera/manager ")])
def test_the_guard_is_a_process_of_its_own_or_in_the_drivers(manager, starts):
    told = subprocess.run(["roslaunch", "--args", "/safety_control_cloud", LAUNCH / "guard.launch", f"manager:={manager}"],
                          stdout=subprocess.PIPE, text=True).stdout
    assert starts in told and " cmd_vel:=mobile_base/commands/velocity " in told


@pytest.mark.parametrize("file", sorted(path.name for path in LAUNCH.glob("*.launch")))
def test_every_argument_says_what_it_is(file):
    given = [arg for arg in ElementTree.parse(LAUNCH / file).getroot().findall("arg") if "value" not in arg.attrib]
    assert [arg.get("name") for arg in given if not arg.get("doc")] == []


def test_the_view_in_a_namespace_is_of_the_robot_there(tmp_path):
    robot = tmp_path / "robot.launch"
    robot.write_text(f'''<launch><group ns="robot1"><include file="{LAUNCH / "view.launch"}">
        <arg name="cloud" value="cam/points"/><arg name="node" value="watch"/><arg name="odometry" value="odom"/></include></group></launch>''')
    told = subprocess.run(["roslaunch", "--args", "/robot1/safety_view", robot], stdout=subprocess.PIPE, text=True).stdout
    assert " --node watch --odometry=odom " in told and " camera/depth/points:=cam/points " in told
    assert not any(":=/" in word or word.startswith("/") for word in told.split() if ":=" in word)


def test_the_view_of_a_robot_alone_is_of_the_node_as_it_is_called_by_default():
    told = subprocess.run(["roslaunch", "--args", "/safety_view", LAUNCH / "view.launch"], stdout=subprocess.PIPE, text=True).stdout
    assert " --node safety_control_cloud --odometry= " in told and " camera/depth/points:=camera/depth/points " in told
