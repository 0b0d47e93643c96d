# SPDX-License-Identifier: BSD-3-Clause
"""~footprint changes what the guard keeps clear while it runs, or nothing at all."""
import math
import time

import pytest
import rospy
from dynamic_reconfigure.client import Client
from geometry_msgs.msg import Point32, Polygon, PolygonStamped
from guarded import CAMERA_TO_FRONT, guarded_robot, twist
from robot import GRACE, after, eventually
from scenes import hall, wall
from std_msgs.msg import Header

SMALL = [(0.178, 0.15), (-0.178, 0.15), (-0.178, -0.15), (0.178, -0.15)]
LONG = [(0.54, 0.15), (-0.178, 0.15), (-0.178, -0.15), (0.54, -0.15)]
UNFIT = {
    "two_corners": LONG[:2],
    "none": [],
    "nan": [(math.nan, 0.15), *LONG[1:]],
    "bow_tie": [LONG[0], LONG[2], LONG[1], LONG[3]],
    "far": [(5.0, 0.15), *LONG[1:]],
}


@pytest.fixture(scope="module")
def robot(master):
    with guarded_robot() as robot:
        robot.camera.show(hall(wall(0.4 + CAMERA_TO_FRONT)))
        robot.driver.say(twist(0.2))
        yield robot


@pytest.fixture(scope="module")
def footprint(robot):
    topic = rospy.Publisher("/safety_control_cloud/footprint", PolygonStamped, queue_size=10)
    eventually(topic.get_num_connections)

    def say(corners, frame="base_footprint"):
        points = [Point32(x, y, 0.0) for x, y in corners]
        topic.publish(PolygonStamped(Header(0, rospy.Time.now(), frame), Polygon(points)))

    yield say
    topic.unregister()


def drives(state):
    return state.factor == 1.0


def stands(state):
    return state.factor < 0.1 and state.cause_text == "SEEN"


def test_a_longer_robot_stops_earlier_and_a_change_of_other_settings_leaves_it_long(robot, footprint):
    robot.gives(drives)
    footprint(LONG)
    robot.gives(stands)
    client = Client("/safety_control_cloud", timeout=10.0)
    client.update_configuration({"noise": 0.011})
    client.close()
    robot.gives(stands)
    footprint(SMALL)
    robot.gives(drives)


def test_the_same_again_and_again_is_no_change(robot, footprint):
    footprint(SMALL)
    robot.gives(drives)
    since = time.monotonic()
    for _ in range(20):
        footprint(SMALL)
        time.sleep(0.02)
    time.sleep(GRACE)
    assert {drives(state) for _, state in after(since, robot.states)} == {True}


@pytest.mark.parametrize("unfit", UNFIT)
def test_what_is_no_footprint_is_refused_whole_with_a_line_in_the_log(robot, footprint, unfit):
    footprint(SMALL)
    robot.gives(drives)
    before = robot.process.output().count("~footprint: refused")
    footprint(UNFIT[unfit])
    eventually(lambda: robot.process.output().count("~footprint: refused") == before + 1)
    robot.gives(drives)


def test_one_in_another_frame_is_refused(robot, footprint):
    footprint(LONG, frame="odom")
    eventually(lambda: "it is in frame 'odom', not in base_footprint" in robot.process.output())
    robot.gives(drives)
