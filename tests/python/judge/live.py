# SPDX-License-Identifier: BSD-3-Clause
"""A bag played to the real node at the speed at which it was recorded, by as many nodes as sent it: live.py BAG NODE.

Prints what the node said, a JSON list for each state that differs from the one before. With a second word it is one
of those that play.
"""
import json
import subprocess
import sys
import time
from pathlib import Path

import rospy
from rosbags.highlevel import AnyReader
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import PointCloud2
from tf2_msgs.msg import TFMessage

from safety_control_cloud.msg import SafetyState
from safety_control_cloud.replay.lockstep import raw
from safety_control_cloud.ros_session import node, roscore

KINDS = {"sensor_msgs/msg/PointCloud2": PointCloud2, "tf2_msgs/msg/TFMessage": TFMessage}
READY = 4.0  # [s] until the first message


def messages_in(bag, source=None):
    with AnyReader([Path(bag)]) as reader:
        for connection, at, content in reader.messages():
            if source in (None, connection.ext.callerid):
                yield connection.topic, KINDS[connection.msgtype], at, content


def play(bag, source, begin, clock):
    """`begin`: on the machine's clock, when the bag does; with `clock` ROS time is the bag's."""
    first = next(messages_in(bag))[2]
    rospy.init_node(source.strip("/"), disable_signals=True)
    ticks = rospy.Publisher("/clock", Clock, queue_size=1) if clock else None
    recorded = list(messages_in(bag, source))
    publishers = {topic: rospy.Publisher(topic, raw(kind), queue_size=100) for topic, kind, _, _ in recorded}
    for topic, _, at, content in recorded:
        while True:
            left = (at - first) / 1e9 - (time.time() - begin)
            if ticks:
                ticks.publish(Clock(rospy.Time.from_sec(at / 1e9 - max(left, 0.0))))
            if left <= 0:
                break
            time.sleep(min(left, 0.01))
        publishers[topic].publish(raw(PointCloud2)(content))
    time.sleep(1.0)


def watch(bag, arguments):
    said = []
    sources = sorted({connection.ext.callerid for connection in connections_of(bag)})
    first, last = ((at for _, _, at, _ in messages_in(bag)), None)
    first = next(first)
    last = max(at for _, _, at, _ in messages_in(bag))
    with roscore():
        rospy.set_param("use_sim_time", True)
        with node("safety_control_node", *arguments) as running:
            rospy.init_node("watch", disable_signals=True)
            rospy.Subscriber("safety_control_cloud/state", SafetyState, said.append, queue_size=1000)
            begin = time.time() + READY
            players = [subprocess.Popen([sys.executable, __file__, bag, "play", source, str(begin), str(int(not n))])
                       for n, source in enumerate(sources)]
            time.sleep(READY + (last - first) / 1e9 + 0.3)
            if running.exit_code is not None:
                sys.exit(running.output())
            for player in players:
                player.kill()
                player.wait()
            told = [[s.header.stamp.to_nsec(), s.zone_text, s.cause_text, s.nearest if abs(s.nearest) < 1e9 else None,
                     s.speed, s.inside, s.returns, s.total] for s in list(said)]
            print(json.dumps(told))
    rospy.signal_shutdown("seen")


def connections_of(bag):
    with AnyReader([Path(bag)]) as reader:
        return list(reader.connections)


if __name__ == "__main__":
    if sys.argv[2:3] == ["play"]:
        play(sys.argv[1], sys.argv[3], float(sys.argv[4]), sys.argv[5] == "1")
    else:
        watch(sys.argv[1], sys.argv[2:])
