# SPDX-License-Identifier: BSD-3-Clause
"""A camera and a node in real processes: what every cloud's answer costs.

One node listens at a time, or they would take each other's time. All see the same scene: 32 bytes a point, floor, wall
and boxes, 30 % without return. The next cloud waits for the answer to the last.
"""
import json
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Tuple

from prefixes import prefixes

from safety_control_cloud.processes import Process, ProcessError, process
from safety_control_cloud.ros_session import PACKAGE, executable_of

PROGRAMS = Path(__file__).resolve().parents[2] / "build" / "tests" / "benchmarks"
WARM_UP = 10  # clouds
PATIENCE = 60.0  # [s] beyond what the clouds take at their rate
# So that every Twist is the answer to a cloud, on a busy machine too.
ONLY_ANSWERS = {"publish_rate": 1.0, "source_timeout": 10.0}


@dataclass(frozen=True, order=True)
class Stream:
    """What a camera sends."""

    width: int
    height: int
    rate: float  # [Hz]

    @property
    def name(self) -> str:
        return f"{self.width}x{self.height}"

    @property
    def points(self) -> int:
        return self.width * self.height


QVGA, VGA, HD = Stream(320, 240, 20.0), Stream(640, 480, 20.0), Stream(1280, 720, 10.0)


@dataclass(frozen=True)
class Exchange:
    """Lists hold a value for each cloud."""

    latency_ms: Tuple[float, ...]  # from just before publishing the cloud to its Twist
    twists: Tuple[int, ...]
    speed: Tuple[float, ...]  # [m/s]
    cpu_ms: float  # of the node, a cloud
    faults: float  # pages that the kernel gave the node, a cloud

    def __post_init__(self) -> None:
        if 0 in self.twists:
            raise ProcessError(f"not every cloud was answered: {self.twists}")


def exchanges(target: str, stream: Stream, clouds: int, pairs: int = 1) -> List[Exchange]:
    """So many cameras, each with a node of its own, all at once. Needs a master: ros_session.roscore()."""
    program = "depth_camera" if target in ("depth", "chain", "depth_floor") else "cloud_camera"
    with ExitStack() as stack:
        running = []
        for place in (f"__ns:=/robot_{number}" for number in range(pairs)):
            nodes = [stack.enter_context(process([*command, place])) for command in commands_of(target)]
            ids = [str(node.pid) for node in nodes]
            camera = stack.enter_context(process([str(PROGRAMS / program), *_numbers(stream, clouds), *ids, place]))
            running.append((camera, nodes))
        return [_report(camera, stream, clouds, *nodes) for camera, nodes in running]


def commands_of(target: str) -> List[List[str]]:
    """What takes the clouds or images and answers."""
    if target in ("tutorial", "floor"):
        return [[str(PROGRAMS / f"{target}_node")]]
    if target == "depth_floor":
        return [[str(PROGRAMS / "floor_node"), "depth"]]
    # All said each time: the master keeps what the last node of this name was given.
    method, taken = ("pcl" if target == "ours_pcl" else "one_pass"), ("depth" if target == "depth" else "cloud")
    said = [f"_method:={method}", f"_input:={taken}"]
    ours = [executable_of(PACKAGE, "safety_control_node"), *_parameters(), *said]
    return [_to_clouds(), ours] if target == "chain" else [ours]


def _to_clouds() -> List[str]:
    """depth_image_proc, in a nodelet manager of its own."""
    topics = ["image_rect:=camera/depth/image_rect", "points:=camera/depth/points"]
    found_by = ["env", f"CMAKE_PREFIX_PATH={prefixes(PROGRAMS)}"]
    return [*found_by, executable_of("nodelet", "nodelet"), "standalone", "depth_image_proc/point_cloud_xyz", *topics]


def exchange_in_one_process(stream: Stream, clouds: int) -> Exchange:
    """Camera and nodelet share a process: `cpu_ms` and `faults` are of both."""
    with process([str(PROGRAMS / "nodelet_camera"), *_numbers(stream, clouds), *_parameters()]) as camera:
        return _report(camera, stream, clouds)


def _numbers(stream: Stream, clouds: int) -> List[str]:
    return [str(number) for number in (stream.width, stream.height, stream.rate, WARM_UP, clouds)]


def _parameters() -> List[str]:
    return [f"_{name}:={value}" for name, value in ONLY_ANSWERS.items()]


def _report(camera: Process, stream: Stream, clouds: int, *others: Process) -> Exchange:
    """The camera's last line."""
    code = camera.wait((WARM_UP + clouds) / stream.rate + PATIENCE)
    lines = [line for line in camera.output().splitlines() if line.startswith("{")]
    if code != 0 or not lines:
        said = "\n".join(one.output() for one in (camera, *others))
        raise ProcessError(f"{' '.join(camera.command)}: exit code {code}\n{said}")
    report: Dict[str, object] = json.loads(lines[-1])
    return Exchange(**{name: tuple(value) if isinstance(value, list) else value for name, value in report.items()})
