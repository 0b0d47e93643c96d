# SPDX-License-Identifier: BSD-3-Clause
"""What happens to the robot when its processes are stopped, ended, killed and started again."""
import os
import signal
import subprocess
import sys
import time
import xmlrpc.client
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import rosgraph
import rospy
from lost_board import robot_that_lost_a_board
from robot import AGAIN, GRACE, NODE, START, after, robot_with
from scenes import hall, wall
from std_srvs.srv import Trigger

from safety_control_cloud.processes import OF_ROSLAUNCH, process

LAUNCH = """
<launch>
  <node pkg="safety_control_cloud" type="safety_control_node" name="safety_control_cloud" respawn="true"/>
</launch>
"""
RESPAWN = 5.0  # [s] in which roslaunch notices and the node is there again


def test_a_node_that_was_stopped_and_goes_on_trusts_nothing_from_before(robot):
    robot.process.send(signal.SIGSTOP)
    robot.keeps_silent(2.0)
    robot.camera.changes()
    robot.process.send(signal.SIGCONT)
    assert robot.first_command().linear.x == 0.0
    robot.drives()


def test_an_obstacle_that_came_while_the_node_was_stopped_is_never_driven_at(robot):
    robot.process.send(signal.SIGSTOP)
    robot.camera.show(hall(wall(0.45)))
    robot.keeps_silent(2.0)
    robot.camera.changes()
    robot.process.send(signal.SIGCONT)
    robot.stops("SEEN", within=AGAIN)
    assert {command.linear.x for _, command in after(robot.camera.changed_at, robot.commands)} == {0.0}
    robot.camera.show(hall())
    robot.drives()


def test_a_reset_that_waited_while_the_node_was_stopped_is_refused(master):
    with robot_that_lost_a_board() as robot, ThreadPoolExecutor() as somebody:
        robot.process.send(signal.SIGSTOP)
        answer = somebody.submit(rospy.ServiceProxy(NODE + "/reset", Trigger))
        time.sleep(2.0)
        robot.camera.changes()
        robot.process.send(signal.SIGCONT)
        assert (answer.result(10.0).success, answer.result().message) == (
            False, "refused: this node had stood still until just now; ask again")
        robot.keeps(0.0, 0.5)  # STALE, as long as clouds of meanwhile wait in the socket
        robot.camera.changes()
        robot.stops("NEAR_LOSS", within=AGAIN)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda number: number.name)
def test_the_last_command_of_a_node_that_is_ended_is_zero(robot, number):
    robot.process.send(number)
    assert robot.process.wait(5.0) == 0, robot.process.output()
    assert robot.commands.until_silence()[-1].linear.x == 0.0


@pytest.mark.skipif("SAFETY_CONTROL_NODE" in os.environ, reason="roslaunch starts the package's own node")
def test_a_node_that_is_killed_is_started_again_by_roslaunch_and_begins_with_zero(master, tmp_path):
    launch = tmp_path / "respawn.launch"
    launch.write_text(LAUNCH)
    with process(["roslaunch", str(launch)], OF_ROSLAUNCH) as roslaunch, robot_with(roslaunch, hall()) as robot:
        robot.drives(within=START)
        first = pid_of(NODE)
        os.kill(first, signal.SIGSTOP)  # what it said last arrives before, not after it is killed
        robot.keeps_silent(GRACE)
        robot.camera.changes()
        os.kill(first, signal.SIGKILL)
        assert robot.first_command(within=RESPAWN).linear.x == 0.0
        robot.drives(within=RESPAWN + AGAIN)
        assert pid_of(NODE) != first


def succeeds(script, *arguments):
    result = subprocess.run(
        [sys.executable, Path(__file__).with_name(script), *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, timeout=120)
    assert result.returncode == 0, result.stdout


def test_a_robot_whose_ros_master_dies_still_stops_and_drives():
    succeeds("lost_master.py")


@pytest.mark.parametrize("when", ("before", "after"))
def test_a_guard_whose_ros_master_dies_still_notices_that_the_driver_of_its_bumper_does(when):
    """And a new master is there before that, or after."""
    succeeds("lost_master_of_a_guard.py", when)


def pid_of(node):
    proxy = xmlrpc.client.ServerProxy(rosgraph.Master("/test_lives").lookupNode(node))
    return proxy.getPid("/test_lives")[2]
