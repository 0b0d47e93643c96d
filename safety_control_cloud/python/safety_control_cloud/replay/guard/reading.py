# SPDX-License-Identifier: BSD-3-Clause
"""One guard that is handed the messages of a bag, each at the time at which it was recorded."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

from safety_control_cloud.headings import heading_of
from safety_control_cloud.replay.bags import BagError, Bags, Recorded
from safety_control_cloud.replay.eyes import Sighting
from safety_control_cloud.replay.guard.drive import GuardDrive, Told
from safety_control_cloud.replay.guard.inputs import Inputs
from safety_control_cloud.replay.guard.poses import BasePlace, Poses
from safety_control_cloud.replay.guard.scans import any_eye_for
from safety_control_cloud.replay.guard.seen import Seen
from safety_control_cloud.replay.guard.switches import Switch
from safety_control_cloud.replay.places import Place, Places
from safety_control_cloud.replay.topics import transforms_in
from safety_control_cloud.replay.wire import header_in

if TYPE_CHECKING:
    from safety_control_cloud.replay.guard.show import Show

LONG = 60.0  # [s] without a message


class Reading:
    def __init__(self, bags: Bags, inputs: Inputs, told: Told, show: Optional[Show] = None) -> None:
        """`told` hears of each answer, `show` of each picture."""
        self._bags, self._inputs, self._told, self._show = bags, inputs, told, show
        self._places, settings = Places(bags), inputs.settings
        self._base = BasePlace(self._places, settings.base_frame)
        self._poses = Poses(self._places, settings.odom_frame, settings.base_frame) if settings.odom_frame else None
        self._switches: Dict[str, List[Switch]] = {}
        for switch in inputs.switches:
            self._switches.setdefault(switch.topic.name, []).append(switch)
        self._eyes = [any_eye_for(bags, source) for source in inputs.sensors]
        self._seen = [Seen(source, inputs.settings, number) for number, source in enumerate(inputs.sensors)]
        self._looking: Dict[str, List[int]] = {}
        for number, source in enumerate(inputs.sensors):
            for topic in source.topics:
                self._looking.setdefault(topic.name, []).append(number)
        self._drive: Optional[GuardDrive] = None
        self.start = self._latest = 0  # [ns] of the bag
        self._warnings: List[str] = []
        moving = transforms_in(bags)
        self._moving = {topic.name for topic in moving}
        self.topics = [*(topic for source in inputs.sensors for topic in source.topics), *inputs.of_base, *moving]

    def take(self, message: Recorded) -> None:
        if self._drive is None:
            self.start = message.time
            self._latest = message.time
            self._drive = GuardDrive(self._inputs.settings, list(self._inputs.names), message.time, self._told, self._poses)
        self._note_pause(message.time)
        if message.topic in self._moving:
            with self._bags.understanding(message):
                self._places.add(message)
        elif message.topic in self._looking:
            for number in self._looking[message.topic]:
                with self._bags.understanding(message):
                    sighting = self._eyes[number].sighting_of(message)
                if sighting:
                    self._see(number, sighting)
        elif message.topic == self._inputs.commands.name:
            with self._bags.understanding(message):
                wanted, stamp = command_in(self._bags.content_of(message))
            self._drive.want(wanted, stamp, message.time)
        elif message.topic in self._switches:
            for switch in self._switches[message.topic]:
                self._drive.touch(switch.name, *switch.word_in(message), message.time)
        else:
            with self._bags.understanding(message):
                content = self._bags.content_of(message)
                odometry = odometry_in(content)
            base = self._base.within(content.child_frame_id, content.header.frame_id)
            if base is not None:
                self._drive.note_odometry(*odometry, message.time, base)

    def end(self) -> List[str]:
        """What is to be told of the bag. Raises BagError also where nothing of a required sensor can be believed."""
        if self._drive is None:
            raise BagError(f"nothing of the guard's in {self._bags.names}; there is: {self._bags.contents()}")
        self._drive.end(self._bags.end)
        for seen in self._seen:
            self._warnings += seen.jumps
            for problem in seen.problems():
                if seen.is_required:
                    raise BagError(problem)
                self._warnings.append(problem)
        if self._base.why_unknown:
            self._warnings.append(self._base.why_unknown)
        said = {switch.name for switch in self._inputs.switches}
        self._warnings += [f"nothing of the switch {one['name']} was recorded: it is taken for released"
                           for one in self._inputs.settings.switches if one["name"] not in said]
        return self._warnings

    def _see(self, number: int, sighting: Sighting) -> None:
        assert self._drive
        place = self._place_of(number, sighting)
        self._drive.see(number, sighting, place, sighting.time)
        if self._show and self._drive.latest:
            self._show.picture(number, sighting, place, self._drive.latest)

    def _place_of(self, number: int, sighting: Sighting) -> Place:
        place = self._places.at(self._inputs.settings.base_frame, sighting.header)
        self._seen[number].note(sighting, place, (sighting.time - self.start) / 1e9)
        return place

    def _note_pause(self, time: int) -> None:
        pause = (time - self._latest) / 1e9
        if pause > LONG:
            self._warnings.append(f"nothing was recorded for {pause:.1f} s from {(self._latest - self.start) / 1e9:.3f} s on: "
                                  "a pause, or a clock that jumped")
        self._latest = time


def command_in(message: Any) -> Tuple[Tuple[float, ...], Optional[float]]:
    """A Twist, or a TwistStamped and its stamp [s]."""
    twist = getattr(message, "twist", message)
    stamp = None if not hasattr(message, "header") else header_in(message).seconds
    return (*_numbers(twist.linear), *_numbers(twist.angular)), stamp


def odometry_in(message: Any) -> Tuple[float, Tuple[float, float, float], Tuple[float, float, float]]:
    """Its stamp [s], pose and twist as GuardDrive takes them."""
    pose, twist = message.pose.pose, message.twist.twist
    return (header_in(message).seconds, (pose.position.x, pose.position.y, heading_of(pose.orientation)),
            (twist.linear.x, twist.linear.y, twist.angular.z))


def _numbers(vector: Any) -> Tuple[float, float, float]:
    return (float(vector.x), float(vector.y), float(vector.z))
