# SPDX-License-Identifier: BSD-3-Clause
"""A bag of a run: all that is small, and of what is large one message now and then.

A process of its own (`python -m safety_control_cloud.demo.bag FILE`): packing clouds would hold up whoever looks on.
"""
from __future__ import annotations

import sys
import time
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
from safety_control_cloud.nodes.life import Life

SMALL = {
    "/tf": TFMessage,
    "/tf_static": TFMessage,
    "/odom": Odometry,
    "/joint_states": JointState,
    "/mobile_base/commands/velocity": Twist,
    "/cmd_vel_mux/input/teleop": Twist,
    "/teleop/cmd_vel": Twist,
    "/guard_mux/output": Twist,
    "/cmd_vel_mux/active": String,
    "/safety_control_cloud/state": SafetyState,
    "/turtlebot_sim/contacts": String,
    "/camera/depth/camera_info": CameraInfo,
}
LARGE = {"/camera/depth/points": PointCloud2, "/camera/rgb/image_raw": Image, "/output": PointCloud2}
LARGE_EVERY = 1.0  # [s] of real time


class Recorder:
    """Writes from construction to `close`; `rosbag play --clock` replays it."""

    def __init__(self, path: Path) -> None:
        self._bag = rosbag.Bag(str(path), "w", compression="lz4")
        self._lock = Lock()
        self._subscribers = [
            rospy.Subscriber(topic, kind, self._on_message, topic, queue_size=100) for topic, kind in SMALL.items()
        ]

    def run(self, life: Life) -> None:
        """For as long as the node lives."""
        while life.goes_on():
            for topic, kind in LARGE.items():
                if life.goes_on():
                    self._take_one(topic, kind)
            time.sleep(LARGE_EVERY)

    def close(self) -> None:
        for subscriber in self._subscribers:
            subscriber.unregister()
        with self._lock:
            self._bag.close()

    def _on_message(self, message, topic: str) -> None:
        now = rospy.Time.now()
        with self._lock:
            if now:  # else the simulated clock has not begun
                self._bag.write(topic, message, now)

    def _take_one(self, topic: str, kind: type) -> None:
        """Subscribed for one message: 10 MB clouds at 20 Hz would keep this process busy."""
        try:
            self._on_message(rospy.wait_for_message(topic, kind, timeout=1.0), topic)
        except rospy.ROSException:
            pass  # nobody publishes it now


def main(path: Path) -> None:
    life = Life("safety_demo_bag")
    recorder = Recorder(path)
    try:
        recorder.run(life)
    except rospy.ROSInterruptException:
        pass
    finally:
        recorder.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
