# SPDX-License-Identifier: BSD-3-Clause
"""What was near before a node was killed is not forgotten by the one that follows it."""
import os
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import pytest
import rospy
from lost_board import FREE, robot_that_lost_a_board
from robot import NODE, START, Heard, after, eventually, node_under_test, robot_with
from std_srvs.srv import Trigger

from safety_control_cloud.msg import SafetyState


@contextmanager
def killed_and_started_again(robot):
    robot.process.send(signal.SIGKILL)
    robot.process.wait(5.0)
    robot.camera.changes()
    with node_under_test() as robot.process:
        yield


def test_a_node_that_is_killed_while_something_is_lost_stands_until_it_is_seen_to_have_gone(master):
    with robot_that_lost_a_board() as robot, killed_and_started_again(robot):
        killed = robot.camera.changed_at
        state = robot.states.until(lambda state: "as before this start" in state.reason)
        assert (state.cause_text, state.speed) == ("NEAR_LOSS", 0.0) and "~reset" in state.hint
        robot.camera.changes()
        since = robot.stops("NEAR_LOSS").stuck_since.to_sec()
        assert 0.0 < since <= rospy.get_time()
        assert {command.linear.x for _, command in after(killed, robot.commands)} == {0.0}
        robot.camera.show(FREE)
        robot.drives()
        assert (robot.states.all()[-1].stuck_since.to_sec(), robot.states.all()[-1].hint) == (0.0, "")
        eventually(lambda: not any(rospy.get_param(NODE + "_lost/things")))
        robot.camera.changes()


def test_reset_frees_what_was_lost_before_the_start_and_is_logged_and_counted(master):
    with robot_that_lost_a_board() as robot, killed_and_started_again(robot):
        robot.states.until(lambda state: "as before this start" in state.reason)
        assert robot.states.all()[-1].resets == 0
        reset = rospy.ServiceProxy(NODE + "/reset", Trigger)
        robot.camera.changes()
        assert reset().success
        again = reset()
        assert (again.success, again.message) == (False, "refused: near obstacles are forgotten at most once a second")
        robot.drives()
        assert robot.states.all()[-1].resets == 1
        eventually(lambda: "~reset: near obstacles lost from sight are forgotten" in robot.process.output())
        time.sleep(1.0)
        assert reset().success
        robot.states.until(lambda state: state.resets == 2)


def test_what_makes_no_sense_on_the_parameter_server_keeps_no_node_from_starting(master):
    for nonsense in (["pixels 4294967295 4294967295 0 1 0 1 5"], ["pixels 2 2 0 9 0 9 5"], ["point nan 0 0"], [""], 7, ["x"] * 9):
        rospy.set_param(NODE + "_lost/things", nonsense)
        with node_under_test() as running, robot_with(running, FREE) as robot:
            robot.drives(within=START)


@pytest.mark.parametrize("found", [None, ["nonsense"]], ids=["nothing", "nonsense"])
@pytest.mark.parametrize("mode", ["drive", "guard"])
def test_a_node_that_knows_nothing_of_before_says_so_and_what_it_waits_for(master, mode, found):
    if rospy.has_param(NODE + "_lost"):
        rospy.delete_param(NODE + "_lost")  # what a node of another test wrote as it ended
    if found:
        rospy.set_param(NODE + "_lost/things", found)
    states = Heard(NODE + "/state", SafetyState)
    with node_under_test("_mode:=" + mode) as running:
        state = states.until(lambda state: "/camera/depth/points" in state.reason)
        assert (state.cause_text, state.speed) == ("NO_CLOUD", 0.0)
        assert "the ROS master tells nothing of what was near before this start" in state.reason
        eventually(lambda: "the ROS master tells nothing of what was near before this start" in running.output())
        with robot_with(running, FREE) as robot:
            if mode == "drive":
                robot.drives(within=START)
            else:
                states.until(lambda state: "NO_CLOUD" != state.cause_text)
    states.close()


@pytest.mark.skipif("SAFETY_CONTROL_NODE" in os.environ, reason="its time is the machine's")
def test_a_node_whose_master_is_started_anew_tells_it_again():
    result = subprocess.run(
        [sys.executable, Path(__file__).with_name("forgetful_master.py")], stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, timeout=120)
    assert result.returncode == 0, result.stdout
