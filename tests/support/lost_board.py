# SPDX-License-Identifier: BSD-3-Clause
"""A robot that has driven up to a board and lost it from sight."""
from contextlib import contextmanager

import rospy
from robot import NODE, START, eventually, node_under_test, robot_with
from scenes import hall, wall

FREE = hall(wall(3.0))
BOARD = (0.5, -0.25, 0.25, -0.25, 0.0)  # hangs: the floor before and behind it is seen
PASSED = (0.39,) + BOARD[1:]  # nearer than the camera can see


@contextmanager
def robot_that_lost_a_board():
    with node_under_test() as first, robot_with(first, FREE) as robot:
        robot.drives(within=START)
        robot.camera.show(hall(BOARD, wall(3.0)))
        robot.stops("SEEN")
        robot.camera.show(hall(PASSED))
        assert robot.stops("NEAR_LOSS").speed == 0.0
        eventually(lambda: any(rospy.get_param(NODE + "_lost/things")))
        yield robot
