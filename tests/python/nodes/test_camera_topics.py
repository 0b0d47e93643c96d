# SPDX-License-Identifier: BSD-3-Clause
"""Somebody listens, and the simulator looks no harder than that needs."""
from types import SimpleNamespace

import numpy as np
import pytest

pytest.importorskip("rospy")

from safety_control_cloud.nodes import camera_topics, messages  # noqa: E402
from safety_control_cloud.simulation.camera import Picture  # noqa: E402
from safety_control_cloud.simulation.sensor import Xtion  # noqa: E402

POINTS, DEPTH, COLOUR = "/camera/depth/points", "/camera/depth/image_raw", "/camera/rgb/image_raw"
INFO = "/camera/depth/camera_info"


class Robot:
    """Notes each way in which it is asked to look."""

    def __init__(self):
        self.world = SimpleNamespace(xtion=Xtion(width=64, height=48))
        self.looks = []

    def depth(self):
        self.looks.append("depth")
        return np.full((48, 64), 1.5, np.float32)

    def picture(self):
        self.looks.append("picture")
        return Picture(np.full((48, 64), 1.5, np.float32), np.zeros((48, 64, 3), np.uint8))


@pytest.fixture
def published_to(monkeypatch):
    """What goes out when these topics have a subscriber each, and how the robot looked for it."""

    def published(*subscribed):
        sent = {}

        def publisher(topic, *_, **__):
            return SimpleNamespace(
                get_num_connections=lambda: int(topic in subscribed),
                publish=lambda message: sent.update({topic: message}))

        monkeypatch.setattr(camera_topics.rospy, "Publisher", publisher)
        robot = Robot()
        camera_topics.CameraTopics(robot, "16UC1").publish(messages.time_of(12.35))
        return sent, robot.looks

    return published


def test_for_the_depth_image_alone_no_colours_are_drawn(published_to):
    sent, looks = published_to(DEPTH, INFO)
    assert looks == ["depth"]
    assert set(sent) == {DEPTH, INFO}
    assert sent[DEPTH].encoding == "16UC1" and set(np.frombuffer(sent[DEPTH].data, np.uint16)) == {1500}


@pytest.mark.parametrize("subscribed", [{POINTS}, {COLOUR}, {POINTS, DEPTH}, {COLOUR, DEPTH}, {POINTS, DEPTH, COLOUR}])
def test_a_cloud_and_a_colour_image_are_of_one_picture_with_the_depth(published_to, subscribed):
    sent, looks = published_to(*subscribed)
    assert looks == ["picture"]
    assert set(sent) == subscribed


def test_without_a_listener_no_picture_is_taken(published_to):
    assert published_to() == ({}, [])
    sent, looks = published_to(INFO)
    assert set(sent) == {INFO} and looks == []
