# SPDX-License-Identifier: BSD-3-Clause
"""What of a bag the guard is given: its sensors, the commands that were recorded, and odometry."""
from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Any, Dict, List, Mapping, Optional, Sequence

from safety_control_cloud import core
from safety_control_cloud.replay.bags import BagError, Bags, Topic
from safety_control_cloud.replay.guard.switches import Switch, switches_in
from safety_control_cloud.replay.parameters import BadSettings, settings_of
from safety_control_cloud.replay.topics import COMPRESSED, OWN, Source, lasers_in, listed, same, sources_in

COMMANDS = {"twist": "geometry_msgs/msg/Twist", "twist_stamped": "geometry_msgs/msg/TwistStamped"}  # by command_type
COMMAND_NAME = "cmd_vel"  # how the last part of its topic begins
ODOMETRY = "nav_msgs/msg/Odometry"
WANTED_IF_GIVEN = ("command_type", "input")  # else what there is, also where the default is the same
OF_TRANSPORT = ("image_transport",)  # parameters of the node that are no settings


@dataclass(frozen=True)
class Inputs:
    settings: core.Settings
    sensors: Sequence[Source]  # in the order of the settings' sensors
    names: Sequence[str]  # of the sensors
    commands: Topic
    odometry: Optional[Topic]
    switches: Sequence[Switch] = ()

    @property
    def of_base(self) -> List[Topic]:
        """Commands, odometry, and the switches' topics, each once."""
        odometry = [self.odometry] if self.odometry else []
        return [self.commands, *odometry, *{switch.topic.name: switch.topic for switch in self.switches}.values()]


def inputs_in(bags: Bags, parameters: Mapping[str, Any], topics: Sequence[str] = (), cmd_vel: Optional[str] = None,
              odom: Optional[str] = None) -> Inputs:
    """Where no name is given: all sensors, and what alone is named as commands and odometry are.

    Raises BagError, BadSettings.
    """
    refuse_both(parameters, topics, odom)
    found = _without_switches(bags, parameters, topics, cmd_vel, odom)
    return replace(found, switches=switches_in(bags, found.settings))


def refuse_both(parameters: Mapping[str, Any], topics: Sequence[str], odom: Optional[str]) -> None:
    """What the settings and an option would both say. Raises BadSettings."""
    if parameters.get("sensors") and topics:
        raise BadSettings("either `sensors` of the settings or --topic says which sensors there are")
    if parameters.get("odom_frame") and odom is not None:
        raise BadSettings("either odom_frame or --odom says where the robot went")


def _without_switches(bags: Bags, parameters: Mapping[str, Any], topics: Sequence[str], cmd_vel: Optional[str],
                      odom: Optional[str]) -> Inputs:
    given = {name: value for name, value in parameters.items() if name not in OF_TRANSPORT}
    commands = _commands(bags, cmd_vel, given.get("command_type"))
    odometry = _odometry(bags, odom, given.get("odom_frame"))
    given["mode"] = "guard"
    given["command_type"] = next(name for name, kind in COMMANDS.items() if kind == commands.kind)
    if given.get("sensors"):
        settings = settings_of(given)
        sensors = [_named(sensor["topic"], bags, sensor["type"]) for sensor in settings.sensors]
        return Inputs(settings, sensors, [sensor["name"] for sensor in settings.sensors], commands, odometry)
    sensors = [_named(name, bags) for name in topics] or _all(bags, given.get("input"))
    sensors = list({source.name: source for source in sensors}.values())
    if len(sensors) == 1:
        given["input"] = sensors[0].input
        return Inputs(settings_of(given), sensors, [sensors[0].input], commands, odometry)
    given["sensors"] = _list_of(sensors)
    return Inputs(settings_of(given), sensors, [one["name"] for one in given["sensors"]], commands, odometry)


def _list_of(sensors: Sequence[Source]) -> List[Dict[str, Any]]:
    """As the node's parameter has it; each is required."""
    found: Dict[str, Source] = {}
    for source in sensors:
        name = re.sub(r"\W", "_", source.name.strip("/"), flags=re.ASCII)
        found[name if name not in found else f"{name}_{len(found)}"] = source
    return [{"name": name, "type": source.input, "topic": source.name} for name, source in found.items()]


def _all(bags: Bags, kind: Optional[str]) -> List[Source]:
    """Those of one kind, if that is given; a depth image is left out where its own cloud lies beside it."""
    there = [*sources_in(bags), *lasers_in(bags)]
    if kind is not None:
        of_kind = [source for source in there if source.input == kind]
        own = [source for source in of_kind if any(same(source.name, name) for name in (*OWN, "scan"))]
        there = own[:1] or of_kind
    clouds = {_folder(source) for source in there if source.input == "cloud"}
    found = [source for source in there if source.input != "depth" or _folder(source) not in clouds]
    if not found:
        what = f"of the input {kind}" if kind else "no PointCloud2, no depth image with its CameraInfo, no LaserScan"
        raise BagError(f"no sensor {what} in {bags.names}; there is: {bags.contents()}")
    raw = {source.name for source in found if source.topic.kind != COMPRESSED}
    return [source for source in found if source.topic.kind != COMPRESSED or source.name not in raw]


def _folder(source: Source) -> str:
    return source.name.strip("/").rpartition("/")[0]


def _named(name: str, bags: Bags, kind: Optional[str] = None) -> Source:
    there = [source for source in (*sources_in(bags), *lasers_in(bags)) if kind in (None, source.input)]
    for source in there:
        if same(source.topic.name, name) or same(source.name, name):
            return source
    raise BagError(f"no {kind or 'cloud, depth image with its CameraInfo, or scan'} on {name} in {bags.names}; "
                   f"there is: {listed(there) or bags.contents()}")


def _commands(bags: Bags, name: Optional[str], kind: Optional[str]) -> Topic:
    kinds = [COMMANDS[kind]] if kind in COMMANDS else list(COMMANDS.values())
    there = [topic for topic in bags.topics() if topic.kind in kinds]
    if name is not None:
        return _one_named(name, there, _words(kinds), bags)
    found = [topic for topic in there if topic.name.rpartition("/")[2].startswith(COMMAND_NAME)]
    if len(found) == 1:
        return found[0]
    typed = f" (command_type: {kind})" if kind else ""
    what = "several topics of commands" if found else f"no {_words(kinds)}{typed} on a topic named {COMMAND_NAME}*"
    hint = "say which by --cmd-vel" if there else "a guard has nothing to guard"
    raise BagError(f"{what} in {bags.names}: {hint}; there is: {_topics(found or there) or bags.contents()}")


def _odometry(bags: Bags, name: Optional[str], frame: Optional[str]) -> Optional[Topic]:
    """With a frame, TF tells it."""
    if frame:
        return None
    there = [topic for topic in bags.topics() if topic.kind == ODOMETRY]
    if name is not None:
        return _one_named(name, there, _words([ODOMETRY]), bags)
    found = [topic for topic in there if same(topic.name, "odom")] or there
    if len(found) > 1:
        raise BagError(f"several topics of odometry in {bags.names}: say which by --odom; there is: {_topics(found)}")
    return found[0] if found else None


def _one_named(name: str, there: Sequence[Topic], kind: str, bags: Bags) -> Topic:
    for topic in there:
        if same(topic.name, name):
            return topic
    raise BagError(f"no {kind} on {name} in {bags.names}; there is: {_topics(there) or bags.contents()}")


def _words(kinds: Sequence[str]) -> str:
    return " or ".join(kind.replace("/msg/", "/") for kind in kinds)


def _topics(topics: Sequence[Topic]) -> str:
    return ", ".join(f"{topic.name} ({_words([topic.kind])}, {topic.count})" for topic in topics)
