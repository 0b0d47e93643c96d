# SPDX-License-Identifier: BSD-3-Clause
"""~override: for a while what the camera shows is not asked, and then it is again."""
import math
import time

import numpy as np
import pytest
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.client import Client
from guarded import CAMERA_TO_FRONT, guarded_robot, twist
from listening import Heard
from robot import GRACE, after, eventually
from scenes import HEIGHT, WIDTH, always, cloud_of, hall, wall

from safety_control_cloud.processes import process
from safety_control_cloud.srv import Override

BLIND = always(cloud_of(np.full((HEIGHT, WIDTH, 3), np.nan, np.float32)))
SHORT, LONG = 1.0, 20.0  # [s]


@pytest.fixture(scope="module")
def robot(master):
    with guarded_robot(override_max=LONG, override_speed=0.3) as robot:
        yield robot


@pytest.fixture
def override(robot):
    service = rospy.ServiceProxy("/safety_control_cloud/override", Override)
    service.wait_for_service(10.0)
    robot.camera.show(hall(wall(0.15 + CAMERA_TO_FRONT)))
    robot.driver.say(twist(0.6))
    robot.gives(lambda state: 0.0 <= state.factor < 0.45)
    yield service
    service(0.0, 0.0, False)
    robot.driver.say(None)
    robot.camera.show(hall())


def gives(speed):
    return lambda state: state.given.linear.x == pytest.approx(speed) and state.override_left > 0.0


def reported():
    heard = Heard("/diagnostics", DiagnosticArray)
    values = heard.until(lambda array: any("override for [s]" in (v.key for v in s.values) for s in array.status))
    heard.close()
    return values.status[0]


def test_it_lets_the_robot_dock_slowly_and_ends_by_itself(robot, override):
    reply = override(SHORT + 0.5, 0.28, False)
    asked = time.monotonic()
    assert reply.success, reply.message
    state = robot.gives(gives(0.28))
    assert (state.zone_text, state.cause_text) == ("Warning", "SEEN") and "~override" in state.reason
    eventually(lambda: robot.states.all()[-1].override_left == 0.0)
    assert time.monotonic() - asked == pytest.approx(SHORT + 0.5, abs=GRACE)
    robot.gives(lambda state: state.factor < 0.45 and "~override" not in state.reason)
    eventually(lambda: "~override has ended" in robot.process.output())


def test_it_is_told_in_diagnostics(robot, override):
    assert override(LONG, 0.2, False).success
    assert reported().level == 1


def test_a_camera_in_doubt_refuses_it_unless_asked_for_explicitly(robot, override):
    robot.camera.pause()
    robot.stands("SILENT")
    reply = override(LONG, 0.2, False)
    assert not reply.success and "SILENT" in reply.message
    assert override(LONG, 0.2, True).success
    assert robot.gives(gives(0.2)).cause_text == "SILENT"
    assert override(LONG, 0.2, True).success, "once more, while it holds"
    assert not override(LONG, 0.1, False).success
    assert robot.gives(gives(0.2)).cause_text == "SILENT"
    assert override(0.0, 0.0, False).success
    robot.stands("SILENT")


def test_a_doubt_that_comes_meanwhile_stops_it_and_goes(robot, override):
    assert override(LONG, 0.2, False).success
    robot.gives(gives(0.2))
    robot.camera.show(BLIND)
    robot.stands("BLIND")
    robot.camera.show(hall(wall(0.15 + CAMERA_TO_FRONT)))
    robot.gives(gives(0.2))


@pytest.mark.parametrize("seconds, speed", [(math.nan, 0.1), (-1.0, 0.1), (math.inf, 0.1), (LONG + 0.1, 0.1), (1.0, math.nan), (1.0, 0.31)])
def test_odd_wishes_are_refused_and_change_nothing(robot, override, seconds, speed):
    since = time.monotonic()
    reply = override(seconds, speed, True)
    assert not reply.success and "refused" in reply.message
    time.sleep(GRACE)
    assert {state.override_left for _, state in after(since, robot.states)} == {0.0}


def test_what_is_no_matter_of_sight_stops_it_all_the_same(robot, override):
    assert override(LONG, 0.2, True).success
    robot.driver.say(twist(math.nan))
    robot.stands("BAD_COMMAND")
    robot.driver.say(None)
    robot.stands("NO_COMMAND")
    robot.driver.say(twist(0.6))
    robot.gives(gives(0.2))
    with process(["rostopic", "pub", "-r", "10", "/cmd_vel", "geometry_msgs/Twist", "{linear: {x: 0.1}}"]):
        eventually(lambda: robot.states.all()[-1].cause_text == "TWO_COMMANDERS")
        assert robot.states.all()[-1].given == twist()
    eventually(lambda: robot.states.all()[-1].cause_text == "SEEN")


def test_parameters_that_forbid_it_end_it(robot, override):
    assert override(LONG, 0.2, False).success
    client = Client("/safety_control_cloud", timeout=10.0)
    client.update_configuration({"override_max": 0.0})
    robot.gives(lambda state: state.override_left == 0.0)
    assert "override_max" in override(1.0, 0.1, False).message
    client.update_configuration({"override_max": LONG})
    client.close()
    robot.gives(lambda state: state.override_left == 0.0)
