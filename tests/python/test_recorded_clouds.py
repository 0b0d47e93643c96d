# SPDX-License-Identifier: BSD-3-Clause
"""Clouds that real sensors recorded, in every layout that drivers use, against truth that knows no PCL."""
from __future__ import annotations

import importlib.util
import json
import sys
from pathlib import Path
from types import ModuleType
from typing import Any, Dict, Iterator, List, Tuple

import pytest
from rosbags.highlevel import AnyReader

from safety_control_cloud import core

SHARED = Path(__file__).resolve().parents[3] / "shared"
DATA, TOOL = SHARED / "data", SHARED / "tools" / "pcd2bag.py"
LAYOUTS = ("native", "pcl32", "rs20", "xyz12", "f64", "be", "zyx", "off3", "rowpad")
METHODS = {"one_pass": core.look, "pcl": core.passthrough}

if not (DATA / "truth.json").is_file():
    pytest.skip(f"no recorded clouds: {DATA} is not there", allow_module_level=True)

TRUTH: Dict[str, Dict[str, Any]] = json.loads((DATA / "truth.json").read_text())
PCDS = [name for name in TRUTH if name.endswith(".pcd")]
BAGS = [name for name in TRUTH if name.endswith(".bag")]


def pcd2bag() -> ModuleType:
    """The tool, with what it imports of its neighbour."""
    library = loaded(TOOL.with_name("pcdlib.py"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "pcdlib", library)
        tool = loaded(TOOL)
    tool.truth_of = library.truth
    return tool


def loaded(file: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(file.stem, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def clouds_in(bag: Path) -> Iterator[Tuple[str, Any]]:
    """Topic and message of every cloud, read by rosbags."""
    with AnyReader([bag]) as reader:
        clouds = [connection for connection in reader.connections if connection.msgtype.endswith("/PointCloud2")]
        for connection, _, raw in reader.messages(connections=clouds):
            yield connection.topic, reader.deserialize(raw, connection.msgtype)


def cloud_of(message: Any) -> core.Cloud:
    fields = [(field.name, field.offset, field.datatype, field.count) for field in message.fields]
    return core.Cloud.of_bytes(
        message.data, message.height, message.width, fields, bool(message.is_bigendian), message.point_step,
        message.row_step)


@pytest.fixture(scope="module", params=PCDS)
def recorded(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Tuple[Dict[str, Any], Any]:
    """What is true of one file, and the file as a bag with a topic for each layout, read back."""
    import rosbag

    tool, path = pcd2bag(), tmp_path_factory.mktemp("recorded") / "layouts.bag"
    header, columns = tool.read_pcd(str(DATA / request.param))
    with rosbag.Bag(str(path), "w") as bag:
        for layout in LAYOUTS:
            bag.write(f"/{layout}", tool.build(header, columns, layout))
    # truth.json is rounded to six decimals; the file's own numbers say which float32 is meant.
    exact = tool.truth_of(*(columns[axis] for axis in "xyz"))["zmin_pos"]
    yield {**TRUTH[request.param]["truth"], "exact": exact}, {topic[1:]: message for topic, message in clouds_in(path)}
    path.unlink()  # 60 MB


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_recorded_cloud_shows_what_is_true_in_every_layout(recorded, layout, method):
    truth, messages = recorded

    sight = METHODS[method](cloud_of(messages[layout]))

    assert_same_nearest(sight, truth)
    assert (sight.nearest and sight.nearest.distance) == truth["exact"]  # to the last bit
    in_front = truth["z_range_all"][0] > 0.0
    assert (sight.total, sight.returns) == (truth["points"], truth["finite"] if in_front else 0)
    assert sight.inside == (truth["corridor_float32_limits"] if in_front else 0)


@pytest.mark.parametrize("method", METHODS)
def test_the_zone_of_a_recorded_cloud_is_the_tutorials(recorded, method):
    truth, messages = recorded

    decision = core.SafetyControl(core.Settings(method=method)).decide(cloud_of(messages["native"]), now=0.0)

    assert_decided_by(decision, truth)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("bag", BAGS)
def test_clouds_of_other_frames_show_what_is_true_as_they_were_recorded(bag, method):
    truths: List[Dict[str, Any]] = [cloud["truth"] for cloud in TRUTH[bag]["clouds"]]
    messages = [message for _, message in clouds_in(DATA / bag)]
    assert len(messages) == len(truths)

    for message, truth in zip(messages, truths):
        sight = METHODS[method](cloud_of(message))
        assert_same_nearest(sight, truth)
        assert sight.total == truth["points"] and sight.inside == truth["corridor_z_gt0"]
        assert 0 < sight.returns <= truth["finite"]
        assert_decided_by(core.SafetyControl(core.Settings(method=method)).decide(cloud_of(message), now=0.0), truth)


def assert_same_nearest(sight: core.Sight, truth: Dict[str, Any]) -> None:
    assert (sight.nearest and round(sight.nearest.distance, 6)) == truth["min_z_gt0"]


def assert_decided_by(decision: core.Decision, truth: Dict[str, Any]) -> None:
    """A cloud that shows next to nothing is no proof of free space: there the robot stands."""
    sight = decision.sight
    if sight.returns < 0.1 * sight.total or sight.returns == 0:
        assert (decision.cause, decision.zone, decision.speed) == (core.Cause.BLIND, core.Zone.DANGER, 0.0)
        return
    zone = truth["zone_z_gt0"].replace("NoObstacle", "Safe")
    assert (decision.cause, decision.zone.name) == (core.Cause.SEEN, zone.upper())
    assert decision.speed == {"Safe": 0.2, "Warning": 0.1, "Danger": 0.0}[zone]
