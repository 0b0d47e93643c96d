# SPDX-License-Identifier: BSD-3-Clause
"""Which topics of a bag the node would look at."""
from __future__ import annotations

from dataclasses import dataclass
from typing import List, Optional, Sequence

from safety_control_cloud.replay.bags import BagError, Bags, Topic

CLOUD = "sensor_msgs/msg/PointCloud2"
IMAGE = "sensor_msgs/msg/Image"
COMPRESSED = "sensor_msgs/msg/CompressedImage"
CAMERA = "sensor_msgs/msg/CameraInfo"
SCAN = "sensor_msgs/msg/LaserScan"
DEPTH_ENDING = "/compressedDepth"  # of image_transport; what is before it is the image's own name
OWN = ("camera/depth/points", "camera/depth/image_rect")  # the node's, by its `input`: cloud, depth
INPUTS = ("cloud", "depth")
TRANSFORMS = {"/tf": False, "/tf_static": True}  # whether they hold for ever
TRANSFORM_KINDS = ("tf2_msgs/msg/TFMessage", "tf/msg/tfMessage")


@dataclass(frozen=True)
class Source:
    """What one node would be given: clouds, or depth images with their CameraInfo; in mode guard also scans."""

    topic: Topic
    camera: Optional[Topic] = None  # of depth images

    @property
    def input(self) -> str:
        if self.topic.kind == SCAN:
            return "scan"
        return "depth" if self.camera else "cloud"

    @property
    def name(self) -> str:
        """The topic as the node knows it: a depth image's without its transport."""
        return self.topic.name[: -len(DEPTH_ENDING)] if self.topic.kind == COMPRESSED else self.topic.name

    @property
    def topics(self) -> List[Topic]:
        return [self.topic, self.camera] if self.camera else [self.topic]


def sources_in(bags: Bags) -> List[Source]:
    """Everything that a node could look at, by name."""
    topics = bags.topics()
    cameras = {topic.name: topic for topic in topics if topic.kind == CAMERA}
    found = []
    for topic in topics:
        if topic.kind == CLOUD:
            found.append(Source(topic))
        elif topic.kind == COMPRESSED and topic.name.endswith(DEPTH_ENDING) or topic.kind == IMAGE and _is_depth(topic):
            image = Source(topic, topic).name
            camera = cameras.get(image.rpartition("/")[0] + "/camera_info")
            if camera:
                found.append(Source(topic, camera))
    return found


def lasers_in(bags: Bags) -> List[Source]:
    return [Source(topic) for topic in bags.topics() if topic.kind == SCAN]


def chosen(bags: Bags, names: Sequence[str], wanted: str = "cloud") -> List[Source]:
    """Those of these names; without a name the node's own topic, else all of the `wanted` input, else all of the other.

    Raises BagError if there are none.
    """
    there = sources_in(bags)
    if names:
        return [_named(name, there, bags) for name in names]
    if not there:
        raise BagError(f"no sensor_msgs/PointCloud2 and no depth image with its CameraInfo in {bags.names}; "
                       f"there is: {bags.contents()}{_hint_at_lasers(bags)}")
    own = [source for source in there if same(source.name, OWN[INPUTS.index(wanted)]) and source.input == wanted]
    return own[:1] or [source for source in there if source.input == wanted] or there


def transforms_in(bags: Bags) -> List[Topic]:
    return [one for one in bags.topics() if rooted(one.name) in TRANSFORMS and one.kind in TRANSFORM_KINDS]


def rooted(name: str) -> str:
    return "/" + name.strip("/")


def same(name: str, other: str) -> bool:
    return name.strip("/") == other.strip("/")


def _is_depth(topic: Topic) -> bool:
    """Whether an Image holds depths is in each message; that its topic speaks of them is how it is found."""
    return "depth" in topic.name


def _named(name: str, there: Sequence[Source], bags: Bags) -> Source:
    for source in there:
        if same(source.topic.name, name) or same(source.name, name):
            return source
    known = f"there is: {listed(there) or bags.contents()}{_hint_at_lasers(bags)}"
    raise BagError(f"no sensor_msgs/PointCloud2 or depth image with its CameraInfo on {name} in {bags.names}; {known}")


def _hint_at_lasers(bags: Bags) -> str:
    return f"; scripts/replay --mode guard looks at a LaserScan too: {listed(lasers_in(bags))}" if lasers_in(bags) else ""


def listed(sources: Sequence[Source]) -> str:
    return ", ".join(f"{source.topic.name} ({source.topic.count})" for source in sources)
