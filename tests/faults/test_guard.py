# SPDX-License-Identifier: BSD-3-Clause
"""The guard: what somebody commands, and what reaches the base of it."""
import math
import signal
import time

import numpy as np
import pytest
import rospy
from commanders import is_of
from geometry_msgs.msg import Twist
from guarded import CAMERA_TO_FRONT, ZERO, bits, guarded_robot, odometry_at_rest, twist
from robot import GRACE, NODE, WATCH, after, eventually
from scenes import HEIGHT, WIDTH, always, cloud_of, hall, points_of, post, wall

from safety_control_cloud.processes import process

NOWHERE = np.full((HEIGHT, WIDTH, 3), np.nan, np.float32)
AHEAD = twist(0.3)


@pytest.fixture(scope="module")
def robot(master):
    with guarded_robot(frozen_clouds=10) as robot:
        yield robot


@pytest.fixture(autouse=True)
def free_hall(request):
    """Each test begins in a hall that is seen to be free, and without a driver."""
    yield
    if "robot" in request.fixturenames:
        request.getfixturevalue("robot").rests()


ODD = Twist()
ODD.linear.x, ODD.linear.y, ODD.angular.z, ODD.angular.x = 0.1 + 0.2, -0.0, 0.1 / 3, 5e-324


@pytest.mark.parametrize("command", [Twist(), ODD, AHEAD, twist(0.1, -1.5), twist(0.0, 2.0), twist(-0.1)])
def test_a_safe_command_passes_equal_in_every_bit(robot, command):
    robot.driver.say(command)
    state = robot.passes(command)
    assert state.zone_text == "Safe" and math.isinf(state.nearest) == (command.linear.x >= 0)


def test_a_command_into_a_wall_is_scaled_as_a_whole(robot):
    robot.camera.show(hall(wall(0.4 + CAMERA_TO_FRONT)))
    robot.driver.say(twist(0.5, 0.2))
    with odometry_at_rest():
        state = robot.slows()
    assert state.given.angular.z / state.given.linear.x == pytest.approx(0.4)
    assert (state.zone_text, state.cause_text, state.sensor) == ("Warning", "SEEN", "cloud")
    assert state.nearest_point.x == pytest.approx(0.4 + 0.178, abs=0.05)


def test_a_round_robot_turns_in_place_beside_a_wall(robot):
    # Who may still roll ahead may not turn either before a wall that has just appeared.
    robot.gives(lambda state: state.cause_text == "NO_COMMAND", lasts=1.0)
    robot.camera.show(hall(wall(0.45)))
    robot.driver.say(twist(0.0, 1.0))
    robot.passes(twist(0.0, 1.0))


def test_backward_where_nobody_looks_it_creeps(robot):
    robot.driver.say(twist(-0.4))
    state = robot.gives(lambda state: 0 < state.factor < 1)
    assert state.given.linear.x == pytest.approx(-0.1) and math.isnan(state.nearest)
    robot.driver.say(twist(-0.05))
    assert math.isnan(robot.passes(twist(-0.05)).nearest)  # nobody could look


def test_a_command_that_waited_while_the_node_was_stopped_is_not_obeyed(robot):
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    robot.process.send(signal.SIGSTOP)
    time.sleep(1.0)
    robot.driver.say(None)
    time.sleep(1.0)
    begun = time.monotonic()
    robot.process.send(signal.SIGCONT)
    time.sleep(1.5)
    assert {bits(command) for _, command in after(begun, robot.commands)} == {bits(Twist())}
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)


DOUBTS = {
    "blind": (always(cloud_of(NOWHERE)), "BLIND"),
    "blind_and_claims_to_be_dense": (always(cloud_of(NOWHERE, is_dense=True)), "BLIND"),
    "all_infinite": (always(cloud_of(np.full_like(NOWHERE, np.inf))), "BLIND"),
    "truncated": (always(cloud_of(points_of(), data=b"12345")), "UNREADABLE"),
    "without_fields": (always(cloud_of(points_of(), fields=[])), "UNREADABLE"),
    "frozen": (always(cloud_of(points_of())), "FROZEN"),
    "a_frame_that_nobody_knows": (hall(frame="elsewhere"), "NO_TRANSFORM"),
    "a_frame_that_looks_elsewhere": (hall(frame="base_footprint"), "WRONG_VIEW"),
    "a_near_hole": (None, "NEAR_LOSS"),
}


@pytest.mark.parametrize("doubt", DOUBTS)
def test_a_camera_in_doubt_ends_at_zero_and_recovers(robot, doubt):
    view, cause = DOUBTS[doubt]
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    if view is None:
        robot.camera.show(hall(post(0.6)))
        robot.gives(lambda state: state.inside > 0)
        hole = points_of(post(0.6))
        hole[points_of(post(0.6))[..., 2] == np.float32(0.6)] = np.nan
        view = [cloud_of(hole * (1 + 1e-4 * i)) for i in range(3)]
    robot.camera.show(view)
    state = robot.stands(cause)
    assert state.stuck and (cause == "NEAR_LOSS") == ("~reset" in state.hint)
    robot.camera.show(hall())
    robot.passes(AHEAD)


@pytest.mark.parametrize("off, cause", [(-5.0, "STALE"), (60.0, "FUTURE")])
def test_a_stamp_that_cannot_be_ends_at_zero_and_recovers(robot, off, cause):
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    robot.camera.clock = lambda: rospy.Time.now() + rospy.Duration(off)
    robot.stands(cause)
    robot.camera.clock = rospy.Time.now
    robot.passes(AHEAD)


def test_a_silent_camera_ends_at_zero_and_recovers(robot):
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    robot.camera.pause()
    robot.stands("SILENT", within=1.0)
    robot.camera.show(hall())
    robot.passes(AHEAD)


def test_a_driver_who_falls_silent_ends_at_zero_which_goes_on_being_said(robot):
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    robot.driver.say(None)
    assert not robot.stands("NO_COMMAND", within=0.7).stuck
    since = time.monotonic()
    time.sleep(1.0)
    said = [bits(command) for _, command in after(since, robot.commands)]
    assert len(said) >= 3 and set(said) == {ZERO}


@pytest.mark.parametrize("odd", [math.nan, math.inf, -math.inf, 1e3])
def test_a_command_that_is_no_motion_ends_at_zero_and_the_next_passes(robot, odd):
    robot.driver.say(twist(0.2, odd))
    robot.stands("BAD_COMMAND")
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)


def test_somebody_else_on_the_base_s_topic_ends_at_zero_and_is_named(robot):
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    with process(["rostopic", "pub", "-r", "10", "/cmd_vel", "geometry_msgs/Twist", "{linear: {x: 0.1}}", "__name:=another"]):
        eventually(lambda: "/another commands the robot on /cmd_vel" in robot.states.all()[-1].reason)
        time.sleep(GRACE)  # what was said before arrives
        since = time.monotonic()
        time.sleep(WATCH)
        assert {bits(state.given) for _, state in after(since, robot.states)} == {ZERO}
        assert {bits(command) for _, command in after(since, robot.commands) if is_of(NODE)(command)} == {ZERO}
    eventually(lambda: robot.states.all()[-1].cause_text == "SEEN")
