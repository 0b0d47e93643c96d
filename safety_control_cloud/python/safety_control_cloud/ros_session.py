# SPDX-License-Identifier: BSD-3-Clause
"""A ROS master of one's own on a free port, and nodes on it.

    with roscore(), node("safety_control_node", "_method:=pcl") as process:
        ...  # this process and its children talk to that master, and to no other
"""
from __future__ import annotations

import os
import socket
import tempfile
import time
import xmlrpc.client
from contextlib import contextmanager
from typing import Iterator, Mapping, Optional

import roslib.packages
import rospkg

from safety_control_cloud.processes import Process, ProcessError, process

PACKAGE = "safety_control_cloud"
START_TIMEOUT = 20.0  # [s] until a master that says nothing counts as failed; a busy machine is slow, not broken


@contextmanager
def node(executable: str, *arguments: str, package: str = PACKAGE) -> Iterator[Process]:
    """Runs a node of a package; arguments as for rosrun: `_parameter:=value`, `topic:=other`, `__name:=name`.

    Raises ProcessError unless the package has exactly this executable.
    """
    with process([executable_of(package, executable), *arguments]) as running:
        yield running


def executable_of(package: str, executable: str) -> str:
    """The path that rosrun would run. A workspace's own comes before what another build left in the package's folder."""
    packages = rospkg.RosPack()
    try:
        found = [str(one) for one in roslib.packages.find_node(package, executable, packages)]
        inside = os.path.join(packages.get_path(package), "")
    except rospkg.ResourceNotFound:
        found, inside = [], ""
    found = [one for one in found if not one.startswith(inside)] or found
    if len(found) != 1:
        raise ProcessError(f"{len(found)} executables {executable} in package {package}; is its setup.bash sourced?")
    return found[0]


@contextmanager
def roscore() -> Iterator[str]:
    """A master (with parameter server) on a free port; gives its URI.

    Within the block, os.environ leads this process and its children to it and keeps ROS logs in a folder that is
    deleted afterwards. Raises ProcessError if it does not start.
    """
    with tempfile.TemporaryDirectory(prefix="ros_session_") as folder:
        with _environment(ROS_HOSTNAME="localhost", ROS_IP=None, ROS_HOME=folder, ROS_LOG_DIR=folder):
            for _ in range(5):
                port = _free_port()
                uri = f"http://localhost:{port}/"
                with process(["rosmaster", "--core", "-p", str(port)]) as master, _environment(ROS_MASTER_URI=uri):
                    if not _answers(master, uri):
                        continue  # somebody else took the port meanwhile
                    yield uri
                    return
            raise ProcessError("no ROS master could be started:\n" + master.output())


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return int(probe.getsockname()[1])


def _answers(master: Process, uri: str) -> bool:
    """Waits for the master; False if it ended. The pid tells it from another's master on the same port."""
    proxy = xmlrpc.client.ServerProxy(uri)
    deadline = time.monotonic() + START_TIMEOUT
    while master.exit_code is None and time.monotonic() < deadline:
        try:
            return proxy.getPid("/ros_session")[2] == master.pid
        except (OSError, xmlrpc.client.Error):
            time.sleep(0.02)
    return False


@contextmanager
def _environment(**variables: Optional[str]) -> Iterator[None]:
    """Sets variables of os.environ (None: unsets) for as long as the block lasts."""
    before = {name: os.environ.get(name) for name in variables}
    _set(variables)
    try:
        yield
    finally:
        _set(before)


def _set(variables: Mapping[str, Optional[str]]) -> None:
    for name, value in variables.items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value
