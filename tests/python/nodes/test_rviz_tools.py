# SPDX-License-Identifier: BSD-3-Clause
"""What a click in rviz does to the simulator, and which one does nothing but say so."""
import math

import pytest
from geometry_msgs.msg import PointStamped, PoseWithCovarianceStamped

from safety_control_cloud.nodes import rviz_tools
from safety_control_cloud.simulation.base import Pose


@pytest.fixture
def rviz(monkeypatch):
    """(click, what was done, what was said)"""
    hearing, done, said = {}, [], []
    monkeypatch.setattr(rviz_tools.rospy, "Subscriber", lambda topic, kind, heard, **_: hearing.update({topic: heard}))
    monkeypatch.setattr(rviz_tools.rospy, "logwarn", lambda text, *parts: said.append(text % parts))
    rviz_tools.listen_to_rviz(done.append, lambda *point: done.append(point))
    return lambda topic, message: hearing[topic](message), done, said


def pose(x, frame="odom"):
    message = PoseWithCovarianceStamped()
    message.header.frame_id, message.pose.pose.position.x, message.pose.pose.orientation.w = frame, x, 1.0
    return message


def point(x, frame="odom"):
    message = PointStamped()
    message.header.frame_id, message.point.x = frame, x
    return message


def test_a_click_in_the_world_moves_the_robot_or_drops_a_box(rviz):
    click, done, said = rviz
    click("/initialpose", pose(1.0))
    click("/clicked_point", point(2.0))
    assert (done, said) == ([Pose(1.0, 0.0, 0.0), (2.0, 0.0)], [])


@pytest.mark.parametrize("topic, message, why", [
    ("/initialpose", pose(math.nan), "2D Pose Estimate was ignored: not every number of it is finite"),
    ("/clicked_point", point(math.inf), "Publish Point was ignored: not every number of it is finite"),
    ("/initialpose", pose(1.0, "map"), "in frame 'map' was ignored: choose odom as rviz's fixed frame"),
    ("/clicked_point", point(1.0, "camera_link"), "in frame 'camera_link' was ignored: choose odom"),
])
def test_a_click_that_is_no_place_in_the_world_is_ignored_and_says_so(rviz, topic, message, why):
    click, done, said = rviz
    click(topic, message)
    assert done == [] and len(said) == 1 and why in said[0]
