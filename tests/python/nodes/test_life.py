# SPDX-License-Identifier: BSD-3-Clause
"""A signal ends a node of ours whatever it is doing."""
import os
import re
import signal
import subprocess
import sys

import pytest
from patience import eventually
from tree import PYTHON

pytest.importorskip("rospy")

from safety_control_cloud.processes import process  # noqa: E402
from safety_control_cloud.ros_session import roscore  # noqa: E402

PUBLISHES = """
import os, signal, sys
import rospy
from rospy.impl.tcpros_pubsub import QueuedConnection
from std_msgs.msg import String
from safety_control_cloud.nodes.life import Life

class InTheMiddle(list):
    def append(self, data):  # the connection's lock is held
        super().append(data)
        os.kill(os.getpid(), int(sys.argv[1]))

life = Life("speaker")
topic = rospy.Publisher("/speech", String, queue_size=10)
steps = 0
while life.goes_on():
    steps += 1
    for connection in topic.impl.connections:
        connection._queue = InTheMiddle(connection._queue)
    topic.publish("")
    rospy.rostime.wallsleep(0.01)
print("ended in order", flush=True)
"""
NODE = "from safety_control_cloud.nodes.life import Life; Life('alone')"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_node_that_is_asked_to_end_as_it_publishes_ends(number):
    with roscore(), process(["rostopic", "echo", "/speech"]), process([sys.executable, "-c", PUBLISHES, str(int(number))]) as node:
        assert node.wait(60.0) == 0, node.output()
        assert node.output() == "ended in order\n"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_node_that_waits_for_a_master_ends_with_a_line(number, monkeypatch):
    monkeypatch.setitem(os.environ, "ROS_MASTER_URI", "http://localhost:1/")
    with process([sys.executable, "-u", "-c", NODE]) as node:
        eventually(lambda: "Unable to register with master node [http://localhost:1/]" in node.output())
        node.send(number)
        assert node.wait(20.0) == 128 + number
        assert node.output().count("\n") == 1


def test_who_asks_twice_does_not_wait_for_the_step():
    busy = f"{NODE}; print('busy', flush=True); import time; time.sleep(600)"
    with roscore(), process([sys.executable, "-c", busy]) as node:
        eventually(lambda: node.output() == "busy\n")
        node.send(signal.SIGINT)
        with pytest.raises(subprocess.TimeoutExpired):
            node.wait(0.5)
        node.send(signal.SIGINT)
        assert node.wait(5.0) == -signal.SIGINT


def test_no_node_lives_by_rospys_own_handlers():
    made = {str(path.relative_to(PYTHON)): re.findall(r"rospy\.init_node\((.*)\)$", path.read_text(), re.MULTILINE)
            for path in PYTHON.rglob("*.py")}
    assert [name for name, calls in made.items() if not all("disable_signals=True" in call for call in calls)] == []
