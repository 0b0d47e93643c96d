# SPDX-License-Identifier: BSD-3-Clause
"""The guard, and who tells it where the robot goes."""
import signal
import time

import rospy
from guarded import guarded_robot, odometry_at_rest, twist
from robot import NODE, eventually
from scenes import hall, post, wall
from std_srvs.srv import Trigger

from safety_control_cloud.processes import process

ELSEWHERE = "{header: auto, child_frame_id: base_footprint, pose: {pose: {position: {x: 1.0}, orientation: {w: 1.0}}}}"


def names_two(output):
    return all(words in output for words in ("odometry comes from", "/another", "/faults", "in turn"))


def test_two_that_tell_where_it_goes_are_named_and_doubted_until_one_is_left(master):
    with guarded_robot() as robot:
        robot.driver.say(twist(0.2))
        with odometry_at_rest():
            robot.gives(lambda state: state.doubts == [])
            with process(["rostopic", "pub", "-s", "-r", "20", "/odom", "nav_msgs/Odometry", ELSEWHERE, "__name:=another"]):
                state = robot.gives(lambda state: any("did not go on" in doubt for doubt in state.doubts), within=10.0)
                assert state.doubts[0].startswith("odometry: ")
                eventually(lambda: names_two(robot.process.output()))
            robot.gives(lambda state: state.doubts == [])


def stands_still(robot, seconds):
    robot.process.send(signal.SIGSTOP)
    time.sleep(seconds)
    robot.process.send(signal.SIGCONT)
    return time.monotonic()


def test_a_node_that_stood_still_goes_on_with_what_odometry_tells_by_then(master):
    with guarded_robot(memory_distance=1.5) as robot, odometry_at_rest():
        robot.camera.show(hall(wall(1.2)))
        robot.driver.say(twist(0.2))
        robot.gives(lambda state: state.doubts == [] and state.cause_text == "SEEN")
        went_on = stands_still(robot, 4.0)
        robot.gives(lambda state: state.cause_text == "SEEN")
        time.sleep(1.0)
        told = [state for at, state in robot.states.timed() if at >= went_on]
        assert not [doubt for state in told for doubt in state.doubts if "did not go on" in doubt]
        assert "NO_ODOMETRY" not in {state.cause_text for state in told}


def test_a_node_that_stood_still_as_the_robot_drove_stands_without_odometry(master):
    with guarded_robot(memory_distance=1.5) as robot:
        robot.camera.show(hall(post(0.9, 0.1)))
        robot.driver.say(twist(0.0))
        robot.passes(twist(0.0))
        robot.driver.say(twist(0.2))
        eventually(lambda: robot.last_given().linear.x > 0.1)
        stands_still(robot, 4.0)
        robot.stands("NO_ODOMETRY")
        assert "~reset" in robot.states.all()[-1].hint
        eventually(lambda: rospy.ServiceProxy(NODE + "/reset", Trigger)().success)  # not at once
        robot.gives(lambda state: state.cause_text == "SEEN")


def test_odometry_of_a_frame_that_tf_does_not_know_is_named(master):
    with guarded_robot() as robot, process(["rostopic", "pub", "-s", "-r", "20", "/odom", "nav_msgs/Odometry", ELSEWHERE.replace("base_footprint", "axle")]):
        robot.driver.say(twist(0.2))
        eventually(lambda: "odometry is of axle, and TF does not tell where base_footprint is in it" in robot.process.output())
        robot.passes(twist(0.2))


def test_an_odom_frame_that_tf_does_not_know_is_named(master):
    with guarded_robot("_odom_frame:=odomm") as robot:
        robot.driver.say(twist(0.2))
        robot.passes(twist(0.2))
        eventually(lambda: "odom_frame odomm: TF does not tell" in robot.process.output())
