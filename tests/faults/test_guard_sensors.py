# SPDX-License-Identifier: BSD-3-Clause
"""The guard with two cameras and a laser: each fault of each of them."""
import math
import sys

import laser as lasers
import numpy as np
import pytest
import rospy
from guarded import bits, twist
from laser import scan_of
from scenes import HEIGHT, WIDTH, always, cloud_of, hall, wall
from three_sensors import REAR_FRAME, robot_with_sensors

from safety_control_cloud.processes import process

AHEAD, BACK, LEFT = twist(0.3), twist(-0.3), twist(0.0, 0.5)


@pytest.fixture(scope="module")
def robot(master):
    with robot_with_sensors() as robot:
        yield robot


@pytest.fixture(autouse=True)
def free_hall(request):
    """Each test begins in a hall that is seen to be free, and without a driver."""
    yield
    if "robot" not in request.fixturenames:
        return
    robot = request.getfixturevalue("robot")
    for part in (robot.laser, robot.camera, robot.rear):
        part.clock = rospy.Time.now
    robot.laser.show(lambda: scan_of(lasers.hall()))
    robot.camera.show(hall())
    robot.rear.show(hall(frame=REAR_FRAME))
    robot.driver.say(BACK)
    robot.passes(BACK, within=5.0)
    robot.driver.say(None)


@pytest.mark.parametrize("command", [AHEAD, BACK, LEFT, twist(0.2, -0.5), twist(-0.2, 0.4)])
def test_what_all_see_to_be_free_passes(robot, command):
    robot.driver.say(command)
    robot.passes(command)


def test_the_one_that_sees_an_obstacle_decides_and_is_named(robot):
    robot.rear.show(hall(wall(0.6), frame=REAR_FRAME))
    robot.driver.say(twist(-0.6))
    state = robot.gives(lambda state: state.factor < 0.9 and state.sensor == "rear")
    assert state.nearest_point.x == pytest.approx(0.087 - 0.6, abs=0.05)
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)


def test_a_laser_sees_what_no_camera_does(robot):
    robot.laser.show(lambda: scan_of(lasers.with_post(150.0, 0.4)))
    robot.driver.say(twist(-0.6))
    state = robot.gives(lambda state: state.factor < 0.9 and state.sensor == "laser")
    assert state.nearest_point.x == pytest.approx(0.4 * math.cos(math.radians(150)), abs=0.06)


def infinite():
    return np.full(lasers.BEAMS, np.inf)


FROZEN = scan_of(lasers.hall())
FAULTS_OF_A_LASER = {
    "nothing measured": (lambda: scan_of(np.full(lasers.BEAMS, np.nan)), "BLIND"),
    "nothing within its range": (lambda: scan_of(infinite()), "BLIND"),
    "all below its range": (lambda: scan_of(np.zeros(lasers.BEAMS)), "BLIND"),
    "no ranges": (lambda: scan_of([]), "UNREADABLE"),
    "half of the ranges": (lambda: scan_of(lasers.hall()[::2]), "UNREADABLE"),
    "NaN as its step": (lambda: scan_of(lasers.hall(), angle_increment=math.nan), "UNREADABLE"),
    "limits swapped": (lambda: scan_of(lasers.hall(), range_min=10.0, range_max=0.1), "UNREADABLE"),
    "a turn of a minute": (lambda: scan_of(lasers.hall(), scan_time=60.0), "UNREADABLE"),
    "the same again and again": (lambda: FROZEN, "FROZEN"),
}


@pytest.mark.parametrize("fault", FAULTS_OF_A_LASER)
def test_a_laser_at_fault_stops_every_motion(robot, fault):
    shown, cause = FAULTS_OF_A_LASER[fault]
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    robot.laser.show(shown)
    assert robot.stands(cause).sensor == "laser"
    robot.driver.say(BACK)
    robot.stands(cause)


def test_a_laser_in_a_frame_that_nobody_knows_stops_it(robot):
    def elsewhere():
        scan = scan_of(lasers.hall())
        scan.header.frame_id = "nowhere"
        return scan

    robot.driver.say(AHEAD)
    robot.laser.show(elsewhere)
    assert robot.stands("NO_TRANSFORM").sensor == "laser"


@pytest.mark.parametrize("seconds, cause", [(-2.0, "STALE"), (2.0, "FUTURE")])
def test_a_laser_whose_stamps_are_off_stops_it(robot, seconds, cause):
    robot.driver.say(AHEAD)
    robot.laser.clock = lambda: rospy.Time.now() + rospy.Duration(seconds)
    assert robot.stands(cause).sensor == "laser"


def test_a_silent_laser_stops_it(robot):
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    robot.laser.pause()
    assert robot.stands("SILENT").sensor == "laser"


def test_two_lasers_on_one_topic_stop_it(robot):
    robot.driver.say(AHEAD)
    with process([sys.executable, lasers.__file__]):
        assert robot.stands("TWO_SOURCES", within=10.0).sensor == "laser"


def test_a_blind_front_camera_leaves_the_way_back(robot):
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    robot.camera.show(always(cloud_of(np.full((HEIGHT, WIDTH, 3), np.nan, np.float32))))
    robot.stands("BLIND")
    robot.driver.say(BACK)
    robot.passes(BACK)  # the others look there


def test_a_camera_that_is_not_required_only_stops_to_count(robot):
    robot.laser.show(lambda: scan_of(lasers.hall()))
    robot.driver.say(BACK)
    robot.passes(BACK)
    robot.rear.pause()
    state = robot.gives(lambda state: len(state.doubts) == 1 and state.factor == 1.0)
    assert state.doubts[0].startswith("rear: SILENT"), "the laser still looks there"
    assert bits(state.given) == bits(BACK)

