#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A camera on /camera/depth/points.

As a script it is a node of its own that sees a wall: camera.py DISTANCE [m]
"""
from __future__ import annotations

import sys
import threading
import time
from typing import Callable, Optional

import rospy
from scenes import View, hall, wall
from sensor_msgs.msg import PointCloud2

TOPIC = "/camera/depth/points"
Clock = Callable[[], rospy.Time]


class Camera:
    """Publishes what it is shown, at its rate, from a thread of its own."""

    def __init__(self, view: View, clock: Clock = rospy.Time.now, rate: float = 20.0, topic: str = TOPIC) -> None:
        self.clock = clock  # stamps the clouds
        self.rate = rate  # [Hz]
        self.changed_at = 0.0  # [s] steady clock: of the latest change, as a view's first cloud
        self._view: Optional[View] = view
        self._sent = 0
        self._change = threading.Condition()
        self._ended = False
        self._publisher = rospy.Publisher(topic, PointCloud2, queue_size=2, tcp_nodelay=True)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def show(self, view: View) -> None:
        """Returns when the first cloud of this view has been sent."""
        with self._change:
            self._view, self._sent = view, 0
            self._change.notify_all()
            assert self._change.wait_for(lambda: self._sent > 0, 20.0)

    def pause(self) -> None:
        """No cloud is sent after this returns."""
        with self._change:
            self._view = None
            self.changes()

    def changes(self) -> None:
        """Something else changes now, and the robot is to answer to it from now on."""
        self.changed_at = time.monotonic()

    def end(self) -> None:
        with self._change:
            self._ended = True
            self._change.notify_all()
        self._thread.join()
        self._publisher.unregister()

    def _run(self) -> None:
        while True:
            with self._change:
                if self._ended:
                    return
                if self._view:
                    self._send(self._view[self._sent % len(self._view)])
                self._change.wait_for(lambda: self._ended or self._is_new(), 1.0 / self.rate)

    def _is_new(self) -> bool:
        return self._view is not None and self._sent == 0

    def _send(self, cloud: PointCloud2) -> None:
        if self._sent == 0:
            self.changed_at = time.monotonic()
        cloud.header.stamp = self.clock()
        self._publish(cloud)
        self._sent += 1
        self._change.notify_all()

    def _publish(self, cloud: PointCloud2) -> None:
        self._publisher.publish(cloud)


if __name__ == "__main__":
    rospy.init_node("another_camera", disable_rosout=True)
    Camera(hall(wall(float(sys.argv[1]))))
    rospy.spin()
