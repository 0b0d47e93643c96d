# SPDX-License-Identifier: BSD-3-Clause
"""What the guard tells: the log, /diagnostics, ~blocked and ~markers."""
import math

import numpy as np
import pytest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Twist
from guarded import CAMERA_TO_FRONT, guarded_robot, twist
from listening import Heard
from robot import eventually
from scenes import HEIGHT, WIDTH, always, cloud_of, hall, wall
from visualization_msgs.msg import Marker, MarkerArray

from safety_control_cloud.msg import SafetyState

NOWHERE = np.full((HEIGHT, WIDTH, 3), np.nan, np.float32)
AHEAD = twist(0.3)


@pytest.fixture(scope="module")
def guarded(master):
    with guarded_robot() as robot:
        yield robot


@pytest.fixture
def robot(guarded):
    yield guarded
    guarded.rests()


def test_a_driver_whom_no_base_hears_is_told(robot):
    robot.driver.say(AHEAD)
    robot.gives(lambda state: state.cause_text == "SEEN")
    robot.commands.close()
    try:
        eventually(lambda: "nobody listens on /cmd_vel" in robot.process.output())
    finally:
        robot.commands = Heard("/cmd_vel", Twist)


def test_diagnostics_tell_what_is_near_and_a_robot_that_nobody_drives_is_no_error(robot):
    heard = Heard("/diagnostics", DiagnosticArray)
    robot.camera.show(hall(wall(0.45)))
    robot.driver.say(AHEAD)
    slowed = heard.until(lambda array: math.isfinite(float(values_in(array)["nearest [m]"])))
    assert slowed.status[0].level == DiagnosticStatus.WARN
    assert float(values_in(slowed)["nearest [m]"]) == pytest.approx(0.45 - 0.087, abs=0.05)
    robot.driver.say(None)
    idle = heard.until(lambda array: values_in(array)["cause"] == "NO_COMMAND")
    assert idle.status[0].level == DiagnosticStatus.OK
    heard.close()


def values_in(array):
    return {value.key: value.value for value in array.status[0].values}


def test_whoever_plans_is_told_what_is_blocked_and_what_is_open(robot):
    robot.camera.show(hall(wall(0.45)))
    robot.driver.say(AHEAD)
    robot.gives(lambda state: state.inside > 0)
    robot.camera.show(always(cloud_of(NOWHERE)))
    robot.stands("BLIND")
    robot.gives(lambda state: state.open == SafetyState.BACKWARD)  # once it has surely come to a stand
    told = eventually(lambda: [blocked for blocked in robot.blocked.all()[-1:] if blocked.open == SafetyState.BACKWARD])[0]
    assert (told.blocked, told.cause_text, told.open) == (True, "BLIND", SafetyState.BACKWARD)
    assert told.wanted.linear.x == AHEAD.linear.x
    robot.driver.say(twist(0.0, 0.5))  # for the same cause, and with the same way open
    eventually(lambda: robot.blocked.all()[-1].wanted.angular.z == 0.5)
    robot.driver.say(twist(-0.1))
    robot.passes(twist(-0.1))
    eventually(lambda: not robot.blocked.all()[-1].blocked)


def moves_before_something(array: MarkerArray) -> bool:
    """Whether the path leads out of the footprint: not in the moments in which a busy machine makes the robot stand."""
    foremost = {marker.ns: max((point.x for point in marker.points), default=0.0) for marker in array.markers}
    return array.markers[2].action == Marker.ADD and foremost["path"] > foremost["footprint"]


def test_rviz_is_shown_the_footprint_its_path_and_what_decided(robot):
    robot.camera.show(hall(wall(0.4 + CAMERA_TO_FRONT)))
    robot.driver.say(twist(0.5, 0.2))
    shown = Heard("/safety_control_cloud/markers", MarkerArray)
    markers = {marker.ns: marker for marker in shown.until(moves_before_something).markers}
    shown.close()
    assert set(markers) == {"footprint", "path", "decider", "reason"}
    assert {marker.header.frame_id for marker in markers.values()} == {"base_footprint"}
    assert markers["decider"].pose.position.x == pytest.approx(0.4 + 0.178, abs=0.05)
