# SPDX-License-Identifier: BSD-3-Clause
"""Processes that end: a ROS master of one's own on a free port, and nodes on it.

    with roscore(), node("safety_control_node", "_method:=pcl") as process:
        ...  # this process and its children talk to that master, and to no other

Whatever ends the block (an error, Ctrl-C) ends the processes too. SIGTERM runs no `finally` in Python unless it is
made an exception: a script that starts processes calls end_on_sigterm() first.
"""
from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import xmlrpc.client
from contextlib import contextmanager
from typing import IO, Iterator, Optional, Sequence

PACKAGE = "safety_control_cloud"
START_TIMEOUT = 20.0  # [s] until a process that says nothing counts as failed; a busy machine is slow, not broken
SIGNALS = ((signal.SIGINT, 5.0), (signal.SIGTERM, 2.0), (signal.SIGKILL, 5.0))  # how to end one, and the patience [s]


class SessionError(RuntimeError):
    """A process could not be started, or ended when it should not have."""


class Process:
    """A running command, in a process group of its own so that Ctrl-C reaches it only through end()."""

    def __init__(self, command: Sequence[str]) -> None:
        """Raises SessionError if there is no such command."""
        self.command = tuple(command)
        self._output: IO[bytes] = tempfile.TemporaryFile()
        try:
            self._popen = subprocess.Popen(
                self.command, stdin=subprocess.DEVNULL, stdout=self._output, stderr=subprocess.STDOUT,
                start_new_session=True)
        except OSError as error:
            raise SessionError(f"cannot start {self.command[0]}: {error.strerror}") from error

    @property
    def pid(self) -> int:
        return self._popen.pid

    @property
    def exit_code(self) -> Optional[int]:
        """None while it runs; -N if signal N ended it."""
        return self._popen.poll()

    def output(self) -> str:
        """What it has written so far, stdout and stderr in the order of writing."""
        size = os.fstat(self._output.fileno()).st_size
        return os.pread(self._output.fileno(), size, 0).decode(errors="replace")

    def wait(self, timeout: float) -> int:
        """The exit code. Raises subprocess.TimeoutExpired if it still runs after so many seconds."""
        return self._popen.wait(timeout)

    def send(self, number: signal.Signals) -> None:
        """Sends a signal to the process and to whatever it has started."""
        try:
            os.killpg(self.pid, number)
        except ProcessLookupError:
            pass  # it has ended by itself, which is what signals are sent for

    def end(self) -> None:
        """Ends it, politely first, and with it whatever it has started."""
        for number, patience in SIGNALS:
            if self.exit_code is not None:
                break
            self.send(number)
            try:
                self.wait(patience)
            except subprocess.TimeoutExpired:
                continue
        self.send(signal.SIGKILL)


@contextmanager
def process(command: Sequence[str]) -> Iterator[Process]:
    """Runs a command for as long as the block lasts."""
    running = Process(command)
    try:
        yield running
    finally:
        running.end()


@contextmanager
def node(executable: str, *arguments: str, package: str = PACKAGE) -> Iterator[Process]:
    """Runs a node of a package; arguments as for rosrun: `_parameter:=value`, `topic:=other`, `__name:=name`.

    Raises SessionError unless the package has exactly this executable.
    """
    with process([executable_of(package, executable), *arguments]) as running:
        yield running


def executable_of(package: str, executable: str) -> str:
    """The path that rosrun would run."""
    import roslib.packages
    import rospkg

    try:
        found = roslib.packages.find_node(package, executable)
    except rospkg.ResourceNotFound:
        found = []
    if len(found) != 1:
        raise SessionError(f"{len(found)} executables {executable} in package {package}; is its setup.bash sourced?")
    return str(found[0])


@contextmanager
def roscore() -> Iterator[str]:
    """A master (with parameter server) on a free port; gives its URI.

    Within the block, os.environ leads this process and its children to it and keeps ROS logs in a folder that is
    deleted afterwards. Raises SessionError if it does not start.
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
            raise SessionError("no ROS master could be started:\n" + master.output())


def end_on_sigterm() -> None:
    """Lets SIGTERM end this process as sys.exit() does, so that every `with` block is left in order."""
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))


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


def _set(variables: dict[str, Optional[str]]) -> None:
    for name, value in variables.items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value
