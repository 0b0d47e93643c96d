# SPDX-License-Identifier: BSD-3-Clause
"""A guarded robot with a camera ahead, one behind that is not required, and a laser."""
from __future__ import annotations

from contextlib import contextmanager
from typing import ContextManager, Iterator, Optional

import rospy
from camera import Camera
from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from guarded import Guarded, guarded_robot
from laser import Laser, laser_on
from scenes import hall
from std_msgs.msg import Header

from safety_control_cloud.processes import Process

REAR_FRAME = "rear_optical_frame"
SENSORS = [
    {"name": "front", "type": "cloud", "topic": "camera/depth/points"},
    {"name": "rear", "type": "cloud", "topic": "rear/points", "required": False},
    {"name": "laser", "type": "scan", "topic": "scan", "noise": 0.02, "frozen_clouds": 8},
]
PARAMETERS = "/safety_control_cloud/"


@contextmanager
def robot_with_sensors(started: Optional[ContextManager[Process]] = None) -> Iterator[Guarded]:
    others = [laser_on("base_footprint"), rear_camera_on("base_footprint")]
    rospy.set_param(PARAMETERS + "sensors", SENSORS)
    rospy.set_param(PARAMETERS + "mode", "guard")
    laser, rear = Laser(), Camera(hall(frame=REAR_FRAME), topic="/rear/points")
    try:
        with guarded_robot(started=started, others=others) as robot:
            robot.laser, robot.rear = laser, rear
            yield robot
    finally:
        laser.end()
        rear.end()


def rear_camera_on(base: str) -> TransformStamped:
    place = Transform(Vector3(0.087, 0.0, 0.2972), Quaternion(0.5, 0.5, -0.5, -0.5))
    return TransformStamped(Header(0, rospy.Time.now(), base), REAR_FRAME, place)
