# SPDX-License-Identifier: BSD-3-Clause
"""A ROS master for all fault tests, and for each its own node, camera and ears."""
import pytest
import rospy
from robot import driving_robot
from stalls import AskedOnceMore, Stalls

from safety_control_cloud.ros_session import roscore


@pytest.fixture(scope="session")
def master():
    with roscore() as uri:
        rospy.init_node("faults", disable_signals=True, disable_rosout=True)
        yield uri
        rospy.signal_shutdown("tested")


@pytest.fixture
def robot(master, request):
    """A robot that drives at 0.2 m/s through a free hall. Parameters of the node: @with_parameters(name=value)."""
    with driving_robot(**request_parameters(request)) as robot:
        yield robot


def request_parameters(request):
    marker = request.node.get_closest_marker("with_parameters")
    return marker.kwargs if marker else {}


def pytest_configure(config):
    config.addinivalue_line("markers", "with_parameters(name=value): private parameters of the node under test")
    config.pluginmanager.register(AskedOnceMore(Stalls()), "asked_once_more")
