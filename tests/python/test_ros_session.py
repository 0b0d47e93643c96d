# SPDX-License-Identifier: BSD-3-Clause
import os
import xmlrpc.client

import pytest

from safety_control_cloud.processes import ProcessError
from safety_control_cloud.ros_session import executable_of, node, roscore


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


def test_a_workspaces_executable_comes_before_that_of_a_clones_own_build_in_it(tmp_path, monkeypatch):
    source, built = tmp_path / "src" / "eyes", tmp_path / "devel"
    mine, other = built / "lib" / "eyes" / "look", source / "devel" / "lib" / "eyes" / "look"
    for executable in (mine, other):
        executable.parent.mkdir(parents=True)
        executable.touch(mode=0o755)
    (built / ".catkin").write_text(str(tmp_path / "src"))
    (source / "package.xml").write_text(
        "<package><name>eyes</name><version>1.0.0</version><description>-</description>"
        '<maintainer email="a@b.org">-</maintainer><license>BSD</license></package>')
    monkeypatch.setenv("CMAKE_PREFIX_PATH", str(built))
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "src"))

    assert executable_of("eyes", "look") == str(mine)
    mine.unlink()
    assert executable_of("eyes", "look") == str(other)
