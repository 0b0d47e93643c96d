# SPDX-License-Identifier: BSD-3-Clause
import os
import xmlrpc.client

import pytest

from safety_control_cloud.processes import ProcessError
from safety_control_cloud.ros_session import node, roscore


def test_two_sessions_have_masters_of_their_own_and_give_the_environment_back():
    before = dict(os.environ)
    with roscore() as first:
        xmlrpc.client.ServerProxy(first).setParam("/test", "/whose", "first")
        with roscore() as second:
            assert first != second == os.environ["ROS_MASTER_URI"]
            assert xmlrpc.client.ServerProxy(second).hasParam("/test", "/whose")[2] is False
        assert os.environ["ROS_MASTER_URI"] == first
    assert dict(os.environ) == before


def test_an_error_ends_the_processes():
    with pytest.raises(ZeroDivisionError):
        with roscore() as uri, node("safety_control_node") as running:
            1 / 0

    assert running.exit_code is not None
    with pytest.raises(OSError):
        xmlrpc.client.ServerProxy(uri).getPid("/test")


def test_an_executable_that_is_not_there_is_named():
    with pytest.raises(ProcessError, match="no_such_node in package safety_control_cloud"):
        with node("no_such_node"):
            pass
    with pytest.raises(ProcessError, match="no_such_package"):
        with node("safety_control_node", package="no_such_package"):
            pass
