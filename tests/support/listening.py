# SPDX-License-Identifier: BSD-3-Clause
"""What the rostests share: hearing topics without sleeping, and playing bags."""
from __future__ import annotations

import tempfile
import threading
import time
import xmlrpc.client
from contextlib import contextmanager
from itertools import groupby
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, List, Sequence, Tuple

import rosgraph
import rospy

from recordings import TOPIC, MadeCloud, write_ros1

from safety_control_cloud.processes import Process, process

PATIENCE = 20.0  # [s] until something that should come about counts as missing


class Heard:
    """Everything received on a topic, in its order, with the time of arrival."""

    def __init__(self, topic: str, kind: type) -> None:
        self._changed = threading.Condition()
        self._messages: List[Tuple[float, Any]] = []
        self.topic = topic
        self.subscriber = rospy.Subscriber(topic, kind, self._on_message, tcp_nodelay=True)

    def _on_message(self, message: Any) -> None:
        with self._changed:
            self._messages.append((time.monotonic(), message))
            self._changed.notify_all()

    def all(self) -> List[Any]:
        return [message for _, message in self.timed()]

    def timed(self) -> List[Tuple[float, Any]]:
        """[s] on the steady clock, and the message."""
        with self._changed:
            return list(self._messages)

    def until(self, condition: Callable[[Any], bool], after: int = 0) -> Any:
        """The first message that fulfils the condition, waited for if need be; the first `after` are not asked."""
        def found() -> List[Any]:
            return [message for _, message in self._messages[after:] if condition(message)]

        with self._changed:
            if self._changed.wait_for(found, PATIENCE):
                return found()[0]
        raise AssertionError(f"{self.topic}: no such message within {PATIENCE} s; the last of {len(self.all())} was\n"
                             f"{self.all()[-1:]}")

    def until_silence(self) -> List[Any]:
        """All messages, once the publisher has gone and nothing can follow."""
        eventually(lambda: self.subscriber.get_num_connections() == 0)
        return self.all()

    def close(self) -> None:
        self.subscriber.unregister()


def eventually(condition: Callable[[], Any]) -> Any:
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        result = condition()
        if result:
            return result
        time.sleep(0.01)
    raise AssertionError(f"it did not come about within {PATIENCE} s")


def is_sending(node: str, topic: str) -> bool:
    """Whether this node has a subscriber to the topic: asked of the node, as a subscriber counts before it is heard."""
    address = rosgraph.Master(rospy.get_name()).lookupNode(node)
    _, _, connections = xmlrpc.client.ServerProxy(address).getBusInfo(rospy.get_name())
    return any(direction == "o" and name == topic for _, _, direction, _, name, *_ in connections)


def runs(values: Sequence[Any]) -> List[Any]:
    """The values without repetitions in a row: how often the node repeats itself is a matter of timing."""
    return [value for value, _ in groupby(values)]


@contextmanager
def playing(clouds: Sequence[MadeCloud], *arguments: str) -> Iterator[Process]:
    """`rosbag play` of these clouds on /camera/depth/points, which starts once somebody listens."""
    with tempfile.TemporaryDirectory() as folder:
        bag = write_ros1(Path(folder) / "clouds.bag", {TOPIC: clouds})
        with process(["rosbag", "play", "--quiet", "--wait-for-subscribers", str(bag), *arguments]) as player:
            yield player


def play(clouds: Sequence[MadeCloud], *arguments: str) -> None:
    """Plays all of them."""
    with playing(clouds, *arguments) as player:
        assert player.wait(60.0) == 0, player.output()


def by_stamp(messages: Sequence[Any]) -> Dict[int, Any]:
    """The last message of every stamp [ns]."""
    return {message.header.stamp.to_nsec(): message for message in messages}
