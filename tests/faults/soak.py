# SPDX-License-Identifier: BSD-3-Clause
"""Clouds as fast as they are decided on: soak.py binding|node CLOUDS

Prints the memory [byte] that the deciding process has in use, twenty times on the way. Camera and node are a process each,
so that what Python keeps does not count for the node.
"""
from __future__ import annotations

import os
import queue
import resource
import sys
from pathlib import Path
from typing import Callable, Iterator

SAMPLES = 20


def main(kind: str, clouds: int) -> None:
    for memory in {"binding": through_binding, "node": through_node}[kind](clouds):
        print(memory, flush=True)


def through_binding(clouds: int) -> Iterator[int]:
    """Both methods, with the crop, in a scene in which a post comes, is lost, and goes."""
    from safety_control_cloud import core

    scenes = pictures()
    controls = [core.SafetyControl(core.Settings(method=method, frozen_clouds=3)) for method in ("one_pass", "pcl")]

    def decide(i: int) -> None:
        controls[i % 2].decide(scenes[i // 2 % len(scenes)], now=i / 40, crop=True)

    yield from sampled(clouds, decide, os.getpid())


def through_node(clouds: int) -> Iterator[int]:
    """The real node with everything subscribed that it publishes."""
    import rospy
    from camera import TOPIC
    from diagnostic_msgs.msg import DiagnosticArray
    from scenes import cloud_of
    from sensor_msgs.msg import PointCloud2
    from visualization_msgs.msg import MarkerArray

    from safety_control_cloud.msg import SafetyState
    from robot import node_under_test

    from safety_control_cloud.ros_session import roscore

    answers: "queue.Queue[SafetyState]" = queue.Queue()
    messages = [cloud_of(points) for points in pictures()]
    with roscore(), node_under_test() as process:
        rospy.init_node("soak", disable_signals=True, disable_rosout=True)
        rospy.Subscriber("/safety_control_cloud/state", SafetyState, answers.put, tcp_nodelay=True)
        for topic, kind in [("/output", PointCloud2), ("/safety_control_cloud/markers", MarkerArray),
                            ("/diagnostics", DiagnosticArray)]:
            rospy.Subscriber(topic, kind, lambda message: None)
        publisher = rospy.Publisher(TOPIC, PointCloud2, queue_size=1, tcp_nodelay=True)
        while publisher.get_num_connections() == 0:
            answers.get(timeout=20.0)

        def decide(i: int) -> None:
            message = messages[i % len(messages)]
            message.header.stamp = rospy.Time.now()
            publisher.publish(message)
            while answers.get(timeout=20.0).header.stamp != message.header.stamp:
                pass

        yield from sampled(clouds, decide, process.pid)
        rospy.signal_shutdown("soaked")


def pictures() -> list:
    from scenes import points_of, post, wall

    boards = [[], [wall(3.0)], [post(1.4)], [post(0.8)], [post(0.6)], [post(0.45)], [post(0.3)], []]
    return [points_of(*board) for board in boards]


def sampled(count: int, decide: Callable[[int], None], pid: int) -> Iterator[int]:
    for i in range(count):
        decide(i)
        if (i + 1) % max(1, count // SAMPLES) == 0:
            yield int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * resource.getpagesize()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
