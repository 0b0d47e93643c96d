# SPDX-License-Identifier: BSD-3-Clause
"""What bumpers and cliff sensors said, as ros/input/switch_word.cpp reads it."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Mapping, Tuple

from safety_control_cloud import core
from safety_control_cloud.replay.bags import BagError, Bags, Recorded, Topic
from safety_control_cloud.replay.topics import same
from safety_control_cloud.replay.wire import CDR_PREFIX

BOOL = "std_msgs/msg/Bool"
OF_KOBUKI = ("kobuki_msgs/msg/BumperEvent", "kobuki_msgs/msg/CliffEvent")  # which say their side
SIDES_OF_KOBUKI = ("front_left", "front", "front_right")


@dataclass(frozen=True)
class Switch:
    name: str
    side: str  # "": its messages say it
    topic: Topic

    def word_in(self, message: Recorded) -> Tuple[str, bool]:
        """The side, and whether it is touched there. Raises BagError."""
        word = message.raw[CDR_PREFIX:] if message.is_cdr else message.raw
        if not self.side and len(word) > 1 and word[0] < len(SIDES_OF_KOBUKI):
            return SIDES_OF_KOBUKI[word[0]], word[1] != 0
        if self.side and word:
            return self.side, word[0] != 0
        raise BagError(f"cannot read a message of {message.topic}")


def switches_in(bags: Bags, settings: core.Settings) -> List[Switch]:
    """Those that said something. Raises BagError."""
    return [switch for one in settings.switches for switch in _of(one, bags)]


def _of(given: Mapping[str, str], bags: Bags) -> List[Switch]:
    side = given.get("side", "")
    kinds: Dict[str, Topic] = {topic.kind: topic for topic in bags.topics() if same(topic.name, given["topic"])}
    fit = [topic for kind, topic in kinds.items() if kind in ((BOOL,) if side else OF_KOBUKI)]
    if kinds and not fit:
        what = f"of {', '.join(kinds)}, which {'say' if not kinds.keys() - set(OF_KOBUKI) else 'do not say'} a side"
        raise BagError(f"switches, {given['name']}: {given['topic']} is {what}; side is {side!r}")
    return [Switch(given["name"], side, topic) for topic in fit]
