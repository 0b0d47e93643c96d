# SPDX-License-Identifier: BSD-3-Clause
"""A terminal that takes no more lines (Ctrl-S, a full pipe) does not keep the robot waiting."""
import fcntl
import os
import subprocess

import pytest
from robot import ONE_CLOUD, SOURCE_TIMEOUT, START, robot_with
from scenes import hall, wall

from safety_control_cloud.ros_session import PACKAGE, executable_of

F_SETPIPE_SZ = 1031  # of Linux; Python has the name since 3.10
CAPACITY = 4096  # [byte] the least that a pipe can hold


class Terminal:
    """A process whose output nobody reads any more; speaks like processes.Process."""

    def __init__(self, command):
        self._reading, writing = os.pipe()
        fcntl.fcntl(writing, F_SETPIPE_SZ, CAPACITY)
        self._writing = writing
        self._fill()
        self._popen = subprocess.Popen(command, stdout=writing, stderr=writing, start_new_session=True)

    def _fill(self):
        """As much as goes in: whoever writes the first line is blocked."""
        os.set_blocking(self._writing, False)
        try:
            while os.write(self._writing, b"x"):
                pass
        except BlockingIOError:
            pass
        os.set_blocking(self._writing, True)  # as the node will have it

    pid = property(lambda self: self._popen.pid)
    exit_code = property(lambda self: self._popen.poll())

    def output(self):
        return "(nobody reads it)"

    def end(self):
        self._popen.kill()
        self._popen.wait()
        os.close(self._reading)
        os.close(self._writing)


@pytest.fixture
def blocked(master):
    command = os.environ.get("SAFETY_CONTROL_NODE") or executable_of(PACKAGE, "safety_control_node")
    terminal = Terminal([command])
    try:
        with robot_with(terminal, hall()) as robot:
            yield robot
    finally:
        terminal.end()


def test_a_terminal_that_takes_no_lines_keeps_no_robot_waiting(blocked):
    blocked.drives(within=START)
    for _ in range(3):
        blocked.camera.show(hall(wall(0.45)))
        blocked.stops("SEEN", within=ONE_CLOUD)
        blocked.camera.show(hall())
        blocked.drives()
    blocked.camera.pause()
    blocked.stops("SILENT", within=SOURCE_TIMEOUT)
