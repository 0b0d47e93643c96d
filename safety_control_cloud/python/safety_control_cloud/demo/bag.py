# SPDX-License-Identifier: BSD-3-Clause
"""A bag of a run: all that is small, and of what is large one message now and then."""
from __future__ import annotations

from pathlib import Path
from threading import Lock

import rosbag
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import CameraInfo, Image, JointState, PointCloud2
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from safety_control_cloud.msg import SafetyState

SMALL = {
    "/tf": TFMessage,
    "/tf_static": TFMessage,
    "/odom": Odometry,
    "/joint_states": JointState,
    "/mobile_base/commands/velocity": Twist,
    "/cmd_vel_mux/input/teleop": Twist,
    "/cmd_vel_mux/active": String,
    "/safety_control_cloud/state": SafetyState,
    "/turtlebot_sim/contacts": String,
    "/camera/depth/camera_info": CameraInfo,
}
LARGE = {"/camera/depth/points": PointCloud2, "/camera/rgb/image_raw": Image, "/output": PointCloud2}
LARGE_EVERY = 2.0  # [s]


class Recorder:
    """Writes from construction to `close`; `rosbag play --clock` replays it."""

    def __init__(self, path: Path) -> None:
        self._bag = rosbag.Bag(str(path), "w", compression="lz4")
        self._lock = Lock()
        self._closed = False
        self._subscribers = [
            rospy.Subscriber(topic, kind, self._on_message, topic, queue_size=100) for topic, kind in SMALL.items()
        ]
        self._timer = rospy.Timer(rospy.Duration.from_sec(LARGE_EVERY), self._on_turn, reset=True)

    def close(self) -> None:
        self._timer.shutdown()
        for subscriber in self._subscribers:
            subscriber.unregister()
        with self._lock:
            self._closed = True
            self._bag.close()

    def _on_message(self, message, topic: str) -> None:
        with self._lock:
            if not self._closed:
                self._bag.write(topic, message, rospy.Time.now())

    def _on_turn(self, _event) -> None:
        """Subscribed for one message: 10 MB clouds at 20 Hz would keep this process busy."""
        for topic, kind in LARGE.items():
            try:
                self._on_message(rospy.wait_for_message(topic, kind, timeout=1.0), topic)
            except rospy.ROSException:
                continue  # nobody publishes it now
