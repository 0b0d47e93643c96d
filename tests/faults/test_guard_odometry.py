# SPDX-License-Identifier: BSD-3-Clause
"""The guard, and who tells it where the robot goes."""
from guarded import guarded_robot, odometry_at_rest, twist
from robot import eventually

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


def test_an_odom_frame_that_tf_does_not_know_is_named(master):
    with guarded_robot("_odom_frame:=odomm") as robot:
        robot.driver.say(twist(0.2))
        robot.passes(twist(0.2))
        eventually(lambda: "odom_frame odomm: TF does not tell" in robot.process.output())
