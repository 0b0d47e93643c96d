# SPDX-License-Identifier: BSD-3-Clause
"""The guard on robots of their own: one that is driven, a nodelet, two on one master, a footprint."""
import math
import signal
import time
from contextlib import contextmanager

import numpy as np
import pytest
import rospy
from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from guarded import CAMERA_TO_FRONT, ZERO, Base, bits, guarded_robot, odometry_at_rest, twist
from laser import scan_of, with_post
from repeated import Repeated
from robot import GRACE, START, node_under_test
from scenes import FRAME, HEIGHT, WIDTH, always, cloud_of, hall, wall
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage
from three_sensors import robot_with_sensors

from safety_control_cloud.processes import process
from safety_control_cloud.srv import Override

NOWHERE = np.full((HEIGHT, WIDTH, 3), np.nan, np.float32)
AHEAD = twist(0.3)
NODELET = ["rosrun", "nodelet", "nodelet", "standalone", "safety_control_cloud/SafetyControlNodelet",
           "__name:=safety_control_cloud", "_mode:=guard"]


def test_a_robot_that_is_driven_at_a_wall_stops_before_it_and_backs_off(master):
    with guarded_robot(memory_distance=1.5) as robot:
        base = Base(robot, 1.0)
        robot.driver.say(twist(0.6))
        base.runs(6.0)
        assert 0.02 < base.nearest == pytest.approx(base.gap, abs=0.01)
        assert base.gap < 0.25, "it came near"
        assert robot.states.all()[-1].stuck
        before = base.gap
        robot.driver.say(twist(-0.1))
        base.runs(1.5)
        assert base.gap > before + 0.08
        base.end()


TURNING = math.pi / 2.0  # [rad/s]


def odom_of(heading):
    turned = Quaternion(0.0, 0.0, math.sin(heading[0] / 2.0), math.cos(heading[0] / 2.0))
    transform = TransformStamped(Header(0, rospy.Time.now(), "odom"), "base_footprint", Transform(Vector3(), turned))
    return TFMessage([transform])


@contextmanager
def robot_that_turned_away_from_a_wall():
    """Its TF says so, until that is ended. The wall is behind it now, where no sensor looks."""
    heading = [0.0]
    with guarded_robot(odom_frame="odom", unseen_speed=0.7, memory_distance=1.5) as robot:
        tf = Repeated("/tf", TFMessage, 50.0, odom_of)
        tf.say(heading)
        robot.camera.show(hall(wall(0.2 + CAMERA_TO_FRONT)))
        robot.driver.say(twist(0.3))
        robot.gives(lambda state: state.factor < 1.0)
        robot.driver.say(twist(0.0, TURNING))  # who turns otherwise has slewed
        robot.camera.show(hall())
        for _ in range(50):
            time.sleep(0.04)
            heading[0] += 0.04 * TURNING
        robot.driver.say(twist())
        yield robot, tf
        tf.end()


def remembers_the_wall(state, within=0.08):
    there = pytest.approx(-0.2 - 0.178, abs=within)  # once it has turned; the nearest of many returns lies before the wall
    return state.sensor == "memory" and state.factor < 0.9 and state.nearest_point.x == there


def test_of_a_robot_whose_odometry_is_tf_what_it_turned_away_from_stays(master):
    with robot_that_turned_away_from_a_wall() as (robot, tf):
        robot.driver.say(twist(-0.5))
        robot.gives(remembers_the_wall)
        tf.say(None)
        robot.stands("NO_ODOMETRY")


def test_what_a_robot_turned_away_from_outlives_the_node(master):
    with robot_that_turned_away_from_a_wall() as (robot, tf):
        robot.driver.say(twist(-0.5))
        robot.gives(remembers_the_wall)
        time.sleep(2.0)  # in which it is written down once more, though the machine be busy
        robot.process.send(signal.SIGKILL)
        robot.process.wait(5.0)
        time.sleep(GRACE)  # its last command arrives
        before = len(robot.commands.all())
        with node_under_test() as robot.process:
            robot.gives(lambda state: remembers_the_wall(state, 0.15), within=START)  # kept in cells, it is widened
            speeds = [command.linear.x for command in robot.commands.all()[before:]]
            assert min(speeds) > -0.45, "at no time as if nothing were there"
            robot.process.send(signal.SIGINT)
            assert robot.process.wait(10.0) == 0, robot.process.output()


def test_the_nodelet_guards_as_the_node_does(master):
    with guarded_robot(started=process(NODELET)) as robot, odometry_at_rest():
        robot.driver.say(AHEAD)
        robot.passes(AHEAD)
        robot.driver.say(None)
        robot.camera.show(hall(wall(0.4 + CAMERA_TO_FRONT)))
        robot.stands("NO_COMMAND")
        robot.driver.say(twist(0.5, 0.2))
        robot.slows()
        robot.camera.show(always(cloud_of(NOWHERE)))
        robot.stands("BLIND")


def override_of(namespace=""):
    service = rospy.ServiceProxy(namespace + "/safety_control_cloud/override", Override)
    service.wait_for_service(10.0)
    return service


@pytest.mark.parametrize("started", [None, NODELET + ["_override_max:=20.0"]], ids=["node", "nodelet"])
def test_who_ends_while_an_override_holds_ends_with_a_zero(master, started):
    with guarded_robot(started=started and process(started), override_max=20.0) as robot:
        robot.driver.say(AHEAD)
        robot.passes(AHEAD)
        assert override_of()(20.0, 0.1, False).success
        robot.gives(lambda state: state.given.linear.x == pytest.approx(0.1) and state.override_left > 0.0)
        robot.process.send(signal.SIGINT)
        assert robot.process.wait(10.0) == 0, robot.process.output()
        assert bits(robot.commands.until_silence()[-1]) == ZERO


def test_two_robots_on_one_master_are_guarded_apart(master):
    frames = [dict(namespace=f"/robot{i}", base_frame=f"robot{i}/base_footprint", override_max=20.0) for i in (1, 2)]
    with guarded_robot(**frames[0]) as one, guarded_robot(**frames[1]) as other:
        for robot in (one, other):
            robot.driver.say(AHEAD)
            robot.passes(AHEAD)
        one.camera.show(always(cloud_of(NOWHERE, frame=f"robot1/{FRAME}")))
        one.stands("BLIND")
        other.passes(AHEAD)
        other.camera.show(always(cloud_of(NOWHERE, frame=f"robot2/{FRAME}")))
        other.stands("BLIND")
        assert override_of("/robot1")(20.0, 0.1, True).success
        one.gives(lambda state: state.given.linear.x == pytest.approx(0.1) and state.override_left > 0.0)
        other.stands("BLIND")


def test_a_list_of_corners_is_a_footprint_and_an_unfit_one_refused(master):
    with node_under_test("_mode:=guard", "_footprint:=[[0.1, 0.1], [0.2, 0.2]]") as running:
        assert running.wait(START) == 1
        assert "at least 3 corners" in running.output()
    rospy.delete_param("/safety_control_cloud")
    with guarded_robot(footprint="[[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]") as robot:
        robot.driver.say(AHEAD)
        robot.passes(AHEAD)


def test_the_nodelet_takes_several_sensors(master):
    with robot_with_sensors(started=process(NODELET)) as robot:
        robot.driver.say(twist(-0.3))
        robot.passes(twist(-0.3))
        robot.laser.show(lambda: scan_of(with_post(150.0, 0.4)))
        robot.driver.say(twist(-0.6))
        robot.gives(lambda state: state.factor < 0.9 and state.sensor == "laser")
        robot.laser.show(lambda: scan_of([]))
        robot.stands("UNREADABLE")
        robot.laser.pause()
        robot.stands("SILENT")
