# SPDX-License-Identifier: BSD-3-Clause
"""A real node for each sensor, in a namespace of its own: none hears of the others' clouds and commands."""
from __future__ import annotations

import time
from contextlib import ExitStack, contextmanager
from typing import Dict, Iterator, List, Mapping, Sequence

import rospy
from tf2_msgs.msg import TFMessage

from safety_control_cloud.processes import Process
from safety_control_cloud.replay.lockstep import Answer, Lockstep, parameters_for_replay, raw
from safety_control_cloud.replay.recording import RecordedCloud, Transforms
from safety_control_cloud.replay.topics import INPUTS, OWN, Source, rooted
from safety_control_cloud.ros_session import node, roscore

NODE = "safety_control_cloud"
TRANSFORMS_TAKE = 0.05  # [s] to the nodes


@contextmanager
def safety_nodes(parameters: Mapping[str, str], sources: Sequence[Source]) -> Iterator["Nodes"]:
    """Starts a master and the nodes for such sources, and ends them all. Once per process, as rospy.init_node().

    Raises BadParameters, or processes.ProcessError if one cannot be started.
    """
    with ExitStack() as running:
        running.enter_context(roscore())
        processes = [running.enter_context(_node(parameters, source, f"/replay_{number}"))
                     for number, source in enumerate(sources)]
        rospy.init_node("safety_control_replay", anonymous=True, disable_signals=True, disable_rosout=True)
        running.callback(rospy.signal_shutdown, "replayed")
        yield Nodes({source.topic.name: Lockstep(process, f"/replay_{number}/{NODE}", _topics(source, f"/replay_{number}"))
                     for number, (source, process) in enumerate(zip(sources, processes))})


@contextmanager
def _node(parameters: Mapping[str, str], source: Source, namespace: str) -> Iterator[Process]:
    wanted = parameters_for_replay(parameters)
    if wanted.get("input", INPUTS[0]) in INPUTS:  # the node itself refuses others
        wanted["input"] = source.input
    arguments = [f"_{name}:={value}" for name, value in wanted.items()]
    arguments += [f"{OWN[1]}:={_topics(source, namespace)[0]}"] if source.camera else []
    with node("safety_control_node", f"__ns:={namespace}", *arguments) as process:
        yield process


def _topics(source: Source, namespace: str) -> List[str]:
    """That the node subscribes to; an image's name tells whether it is rectified."""
    own = [source.name, source.camera.name] if source.camera else [OWN[0]]
    return [namespace + rooted(name) for name in own]


class Nodes:
    """Hands clouds to their nodes, each after the answer to the one before, and transforms to all."""

    def __init__(self, by_topic: Mapping[str, Lockstep]) -> None:
        self._by_topic = by_topic
        self._transforms: Dict[str, rospy.Publisher] = {}

    def answer_to(self, cloud: RecordedCloud) -> Answer:
        """Raises lockstep.NoAnswer."""
        self._move(cloud.transforms)
        return self._by_topic[cloud.topic].answer_to(cloud)

    def remembered(self, topic: str) -> List[str]:
        return self._by_topic[topic].remembered()

    def _move(self, transforms: Transforms) -> None:
        """Transforms have a way of their own to the nodes, and they do not tell when they are there."""
        new = {topic for topic, _ in transforms} - set(self._transforms)
        for topic in new:
            self._transforms[topic] = rospy.Publisher(topic, raw(TFMessage), queue_size=1000)
        for topic in new:
            while self._transforms[topic].get_num_connections() < len(self._by_topic):
                for one in self._by_topic.values():
                    one.check_alive("its transforms")
                time.sleep(0.01)
        for topic, message in transforms:
            self._transforms[topic].publish(message)
        if transforms:
            time.sleep(TRANSFORMS_TAKE)
