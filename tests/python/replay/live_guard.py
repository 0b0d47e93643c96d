# SPDX-License-Identifier: BSD-3-Clause
"""A bag played to the real guard node, a little faster than it was recorded, with ROS time as the bag's: live_guard.py BAG SETTINGS.

SETTINGS: the node's parameters as JSON. Prints what it said, a JSON list for each state: cause, factor, sensor, wanted, given.
Faster, because an age is the greater of those by the two clocks: so it is that of the bag in every bit.
"""
import json
import sys
import time
from pathlib import Path

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rosbags.highlevel import AnyReader
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan, PointCloud2
from tf2_msgs.msg import TFMessage

from safety_control_cloud.msg import SafetyState
from safety_control_cloud.replay.lockstep import raw
from safety_control_cloud.ros_session import node, roscore

KINDS = {kind._type.replace("/", "/msg/"): kind for kind in (LaserScan, Odometry, PointCloud2, TFMessage, Twist)}
RATE = 1.03
CLOCK_TAKES = 0.002  # [s] to the node
NODE = "/safety_control_cloud"


def numbers(twist):
    return [twist.linear.x, twist.linear.y, twist.linear.z, twist.angular.x, twist.angular.y, twist.angular.z]


def played(bag, publishers, clock):
    with AnyReader([Path(bag)]) as reader:
        recorded = [(connection.topic, at, content) for connection, at, content in reader.messages()]
    begin, first = time.monotonic(), recorded[0][1]
    for topic, at, content in recorded:
        left = (at - first) / 1e9 / RATE - (time.monotonic() - begin)
        time.sleep(max(0.0, left - CLOCK_TAKES))
        clock.publish(Clock(rospy.Time(*divmod(at, 10**9))))
        time.sleep(CLOCK_TAKES)
        publishers[topic].publish(raw(Twist)(content))


def main(bag, settings):
    said = []
    with roscore():
        rospy.set_param("use_sim_time", True)
        for name, value in settings.items():
            rospy.set_param(f"{NODE}/{name}", value)
        with node("safety_control_node", "cmd_vel_in:=/wanted", "cmd_vel:=/given") as running:
            rospy.init_node("live", disable_signals=True)
            rospy.Subscriber(NODE + "/state", SafetyState, said.append, queue_size=1000, tcp_nodelay=True)
            with AnyReader([Path(bag)]) as reader:
                kinds = {connection.topic: KINDS[connection.msgtype] for connection in reader.connections}
            clock = rospy.Publisher("/clock", Clock, queue_size=100, tcp_nodelay=True)
            publishers = {topic: rospy.Publisher(topic, raw(kind), queue_size=100, tcp_nodelay=True) for topic, kind in kinds.items()}
            while not all(one.get_num_connections() for one in (clock, *publishers.values())):
                time.sleep(0.02)
                if running.exit_code is not None:
                    sys.exit(running.output())
            played(bag, publishers, clock)
            time.sleep(0.2)
        print(json.dumps([[state.cause_text, state.factor, state.sensor, numbers(state.wanted), numbers(state.given)] for state in said]))
    rospy.signal_shutdown("seen")


if __name__ == "__main__":
    main(sys.argv[1], json.loads(sys.argv[2]))
