# SPDX-License-Identifier: BSD-3-Clause
"""What turtlebot.urdf tells gazebo_ros' plugins is what they read, and what the robot is elsewhere."""
import re
from math import radians
from pathlib import Path
from xml.etree import ElementTree

import pytest

from safety_control_cloud.simulation.base import WHEEL_RADIUS, WHEEL_SEPARATION
from safety_control_cloud.simulation.sensor import Xtion

ROOT = Path(__file__).parents[3]
URDF = ElementTree.parse(ROOT / "safety_control_cloud/urdf/turtlebot.urdf").getroot()
STANDINS = ROOT / "tests/platforms/standins/gazebo_ros/src"  # they refuse what the real plugins do not read
SOURCES = {"libgazebo_ros_openni_kinect.so": "depth_camera.cpp", "libgazebo_ros_diff_drive.so": "differential_drive.cpp"}
PLUGINS = {plugin.get("filename"): plugin for plugin in URDF.iter("plugin")}
SENSOR = next(URDF.iter("sensor"))
WHEELS = PLUGINS["libgazebo_ros_diff_drive.so"]
CAMERA = PLUGINS["libgazebo_ros_openni_kinect.so"]


def number(element, tag):
    return float(element.find(tag).text)


def test_the_plugins_are_gazebo_ros_own():
    assert set(PLUGINS) == set(SOURCES)


@pytest.mark.parametrize("plugin, source", SOURCES.items())
def test_every_parameter_is_one_that_the_plugin_reads(plugin, source):
    known = re.search(r"KNOWN = \{(.*?)\}", (STANDINS / source).read_text(), re.DOTALL).group(1)
    told = {parameter.tag for parameter in PLUGINS[plugin]}
    assert told and told - set(re.findall(r'"(\w+)"', known)) == set()


def test_gazebos_wheels_are_the_kobukis():
    assert number(WHEELS, "wheelSeparation") == WHEEL_SEPARATION
    assert number(WHEELS, "wheelDiameter") == 2 * WHEEL_RADIUS
    joints = {joint.get("name") for joint in URDF.iter("joint") if joint.get("type") == "continuous"}
    assert {WHEELS.find("leftJoint").text, WHEELS.find("rightJoint").text} == joints


def test_gazebos_wheels_obey_at_once_the_node_that_has_the_drivers_limits():
    pytest.importorskip("roslib")
    from safety_control_cloud.gazebo_ros import WHEELS_TOPIC

    assert number(WHEELS, "wheelAcceleration") == 0
    assert WHEELS.find("robotNamespace").text + WHEELS.find("commandTopic").text == WHEELS_TOPIC


def test_gazebos_camera_is_the_xtion():
    xtion = Xtion()
    assert number(SENSOR, "camera/horizontal_fov") == pytest.approx(xtion.horizontal_view)
    assert xtion.horizontal_view == radians(60)
    assert (number(SENSOR, "camera/image/width"), number(SENSOR, "camera/image/height")) == (xtion.width, xtion.height)
    assert number(SENSOR, "update_rate") == number(CAMERA, "updateRate") == xtion.rate
    assert (number(SENSOR, "camera/clip/near"), number(SENSOR, "camera/clip/far")) == xtion.clip
    assert number(CAMERA, "pointCloudCutoff") == xtion.nearest
    assert number(CAMERA, "pointCloudCutoffMax") == xtion.farthest


def test_gazebos_camera_stands_in_the_depth_frame_and_names_the_optical_one():
    assert next(tag.get("reference") for tag in URDF.iter("gazebo") if SENSOR in tag) == "camera_depth_frame"
    assert CAMERA.find("frameName").text == "camera_depth_optical_frame"


def test_the_cameras_topics_are_those_of_its_driver():
    topics = {tag: f"/{CAMERA.find('cameraName').text}/{CAMERA.find(tag).text}" for tag in (
        "pointCloudTopicName", "depthImageTopicName", "depthImageCameraInfoTopicName", "imageTopicName", "cameraInfoTopicName")}
    assert list(topics.values()) == [
        "/camera/depth/points", "/camera/depth/image_raw", "/camera/depth/camera_info", "/camera/rgb/image_raw",
        "/camera/rgb/camera_info"]
