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
from geometry_msgs.msg import Twist
from guarded import FRONT_BUMPER, driver_of_the_bumper, guarded_robot, twist
from lost_board import BOARD, FREE, PASSED, robot_that_lost_a_board
from repeated import Repeated
from robot import NODE, START, Heard, after, eventually, node_under_test, robot_with
from scenes import hall, wall
from std_msgs.msg import Bool
from std_srvs.srv import Trigger

from safety_control_cloud.msg import SafetyState

NOTHING_TOLD = "the ROS master tells nothing of what was near before this start"
NOT_PLACED = "the ROS master tells of something near or lost before this start that this node cannot place"
NONSENSE = (["pixels 4294967295 4294967295 0 1 0 1 5"], ["things-4 1 2 3"], ["point nan 0 0"], 7, ["x"] * 9, [["x"]])


@contextmanager
def killed_and_started_again(robot, *arguments):
    robot.process.send(signal.SIGKILL)
    robot.process.wait(5.0)
    robot.camera.changes()
    with node_under_test(*arguments) as robot.process:
        yield


@contextmanager
def guarded_robot_that_lost_a_board():
    """It is driven on."""
    with guarded_robot() as robot:
        robot.driver.say(twist(0.2))
        robot.passes(twist(0.2))
        robot.camera.show(hall(BOARD, wall(3.0)))
        time.sleep(0.6)
        robot.camera.show(hall(PASSED, wall(3.0)))
        robot.stands("NEAR_LOSS")
        eventually(lambda: any(rospy.get_param(NODE + "_lost/things")))
        yield robot


def forget():
    assert rospy.ServiceProxy(NODE + "/reset", Trigger)().success


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


def test_what_a_guard_lost_is_lost_for_a_node_in_mode_drive_and_for_the_next_guard(master):
    with guarded_robot_that_lost_a_board() as robot:
        commands = Heard("/cmd_vel_mux/input/teleop", Twist)
        with killed_and_started_again(robot, "_mode:=drive"):
            robot.states.until(lambda state: "as before this start" in state.reason)
            time.sleep(1.0)
            assert robot.states.all()[-1].cause_text == "NEAR_LOSS"
            assert {command.linear.x for command in commands.all()} == {0.0}
            assert NOTHING_TOLD not in robot.process.output() and NOT_PLACED not in robot.process.output()
            with killed_and_started_again(robot, "_mode:=guard"):
                robot.states.until(lambda state: "as before this start" in state.reason)
                robot.stands("NEAR_LOSS")
                robot.camera.show(FREE)
                robot.passes(twist(0.2))
        commands.close()


def test_what_touches_a_guard_that_is_killed_touches_the_next_one(master):
    rospy.set_param(NODE + "/switches", [FRONT_BUMPER])
    bumper = rospy.Publisher("/bumper", Bool, queue_size=1)
    with guarded_robot() as robot:
        robot.driver.say(twist(0.2))
        robot.passes(twist(0.2))
        eventually(bumper.get_num_connections)
        bumper.publish(True)
        robot.stands("BUMPER")
        eventually(lambda: any(rospy.get_param(NODE + "_lost/things")))
        with killed_and_started_again(robot, "_mode:=guard"):
            state = robot.stands("BUMPER")
            assert state.sensor == "front" and "~reset" in state.hint
            eventually(bumper.get_num_connections)
            bumper.publish(False)
            robot.passes(twist(0.2))
    bumper.unregister()


def test_what_one_of_two_drivers_touched_is_not_released_by_the_other_after_a_restart(master):
    rospy.set_param(NODE + "/switches", [FRONT_BUMPER])
    right = Repeated("/bumper", Bool, 10.0)
    right.say(Bool(False))
    with guarded_robot() as robot:
        robot.driver.say(twist(0.2))
        robot.passes(twist(0.2))
        with driver_of_the_bumper("true", name="left"):
            robot.stands("BUMPER", within=10.0)
            eventually(lambda: any(rospy.get_param(NODE + "_lost/things")))
        with killed_and_started_again(robot, "_mode:=guard", "_memory_distance:=0.0"):
            robot.gives(lambda state: state.cause_text == "BUMPER", within=10.0, lasts=3.0)
            right.end()
            time.sleep(1.0)
            right = Repeated("/bumper", Bool, 10.0)
            right.say(Bool(False))
            robot.gives(lambda state: state.cause_text == "BUMPER", within=10.0, lasts=3.0)
            forget()
            robot.passes(twist(0.2))
    right.end()


def test_what_a_camera_lost_that_bears_another_name_by_now_stops_the_robot_until_reset(master):
    with guarded_robot_that_lost_a_board() as robot:
        rospy.set_param(NODE + "/sensors", [{"name": "front", "type": "cloud", "topic": "camera/depth/points"}])
        with killed_and_started_again(robot):
            robot.states.until(lambda state: "what was near or lost before this start cannot be placed" in state.reason)
            assert "~reset" in robot.stands("NEAR_LOSS").hint
            robot.camera.show(FREE)
            robot.driver.say(twist(-0.1))
            robot.stands("NEAR_LOSS")
            assert NOT_PLACED in robot.process.output() and NOTHING_TOLD not in robot.process.output()
            assert any(rospy.get_param(NODE + "_lost/things")), "for the next one"
            forget()
            robot.driver.say(twist(0.2))
            robot.passes(twist(0.2))
            eventually(lambda: not any(rospy.get_param(NODE + "_lost/things")))


def test_what_makes_no_sense_on_the_parameter_server_stops_the_robot_until_reset(master):
    for nonsense in NONSENSE:
        rospy.set_param(NODE + "_lost/things", nonsense)
        with node_under_test() as running, robot_with(running, FREE) as robot:
            robot.states.until(lambda state: state.cause_text == "NEAR_LOSS")
            assert "~reset" in robot.states.all()[-1].hint
            robot.camera.changes()
            robot.stops("NEAR_LOSS")
            forget()
            robot.camera.changes()
            robot.drives(within=START)


def test_a_node_before_which_nothing_was_near_drives(master):
    rospy.set_param(NODE + "_lost/things", [""])
    with node_under_test() as running, robot_with(running, FREE) as robot:
        robot.drives(within=START)
        assert NOTHING_TOLD not in running.output()


@pytest.mark.parametrize("found, told", [(None, NOTHING_TOLD), (["nonsense"], NOT_PLACED)], ids=["nothing", "nonsense"])
@pytest.mark.parametrize("mode", ["drive", "guard"])
def test_a_node_that_does_not_know_what_was_before_says_so_and_what_it_waits_for(master, mode, found, told):
    if rospy.has_param(NODE + "_lost"):
        rospy.delete_param(NODE + "_lost")  # what a node of another test wrote as it ended
    if found:
        rospy.set_param(NODE + "_lost/things", found)
    states = Heard(NODE + "/state", SafetyState)
    with node_under_test("_mode:=" + mode) as running:
        state = states.until(lambda state: "/camera/depth/points" in state.reason)
        assert (state.cause_text, state.speed) == ("NO_CLOUD", 0.0)
        assert told in state.reason
        eventually(lambda: told in running.output())
        with robot_with(running, FREE) as robot:
            if found:
                forget()
            if mode == "drive":
                robot.drives(within=START)
            else:
                states.until(lambda state: "NO_CLOUD" != state.cause_text)
    states.close()


@pytest.mark.parametrize("other", [[], [""], 7], ids=str)
def test_what_somebody_else_writes_over_what_is_lost_is_written_anew(master, other):
    """As who loads the parameters that he dumped an hour ago."""
    with robot_that_lost_a_board() as robot:
        lost = NODE + "_lost/things"
        eventually(lambda: any(rospy.get_param(lost)))
        kept = rospy.get_param(lost)
        rospy.set_param(lost, other)
        eventually(lambda: rospy.get_param(lost) == kept)
        assert "somebody has changed " + lost in robot.process.output()
        with killed_and_started_again(robot):
            robot.states.until(lambda state: "as before this start" in state.reason)
            robot.camera.changes()
            robot.stops("NEAR_LOSS")


@pytest.mark.skipif("SAFETY_CONTROL_NODE" in os.environ, reason="its time is the machine's")
def test_a_node_whose_master_is_started_anew_tells_it_again():
    result = subprocess.run(
        [sys.executable, Path(__file__).with_name("forgetful_master.py")], stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, timeout=120)
    assert result.returncode == 0, result.stdout
