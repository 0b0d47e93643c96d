# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark's cameras and nodes do what its figures say; how fast is for scripts/bench to tell."""
import json
import subprocess
import sys
from pathlib import Path

import exchange
import guard
import nodes
import peer
import pytest
import rosgraph

from safety_control_cloud.ros_session import roscore

pytestmark = pytest.mark.skipif(
    not (exchange.PROGRAMS / "cloud_camera").exists(),
    reason="not built: cmake --build build --target safety_control_benchmarks",
)

CLOUDS = 3


@pytest.fixture(scope="module")
def master():
    with roscore() as uri:
        yield uri


@pytest.mark.parametrize(
    "side, speed",
    [
        *((side, 0.1) for side in ("ours", "ours_pcl", "tutorial", "nodelet", "depth", "chain")),
        *((side, 0.0) for side in ("floor", "depth_floor")),
    ],
)
def test_every_cloud_gets_exactly_one_answer_and_the_right_one(master, side, speed):
    met = nodes.exchange(exchange.QVGA, side, CLOUDS)
    assert met.twists == (1,) * CLOUDS
    assert met.speed == (speed,) * CLOUDS  # the scene's nearest box stands at 0.7 m
    assert len(met.latency_ms) == CLOUDS and min(met.latency_ms) > 0.0
    assert met.cpu_ms > 0.0 and met.faults >= 0.0


def test_our_node_looks_by_itself_again_after_it_looked_by_pcl(master):
    """The master keeps private parameters when their node has gone."""
    for side in ("ours_pcl", "ours"):
        exchange.exchanges(side, exchange.QVGA, CLOUDS)
    parameters = rosgraph.Master("test")  # rospy would keep to this master for the tests after this one
    assert parameters.getParam("/robot_0/safety_control_cloud/method") == "one_pass"


def test_several_cameras_are_answered_each_by_its_own_node(master):
    first, second = exchange.exchanges("ours", exchange.QVGA, CLOUDS, pairs=2)
    assert first.twists == second.twists == (1,) * CLOUDS


@pytest.mark.parametrize("side", guard.SIDES)
def test_the_guard_answers_every_command_beside_its_sensors(master, side):
    met = guard.drive(side, CLOUDS * guard.COMMANDS_A_CLOUD)
    assert len(met["latency_ms"]) == CLOUDS * guard.COMMANDS_A_CLOUD and min(met["latency_ms"]) > 0.0
    assert (met["cpu_share"] > 0.0) == (met["cpu_ms"] > 0.0) == (side not in guard.NODELETS)


def test_the_guard_answers_every_command_beside_one_camera_too(master):
    with guard.parameters({guard.NODE: peer.CAMERA}):
        met = guard.driven(guard.commands_of("ours"), CLOUDS * guard.COMMANDS_A_CLOUD, sensors=1)
    assert len(met["latency_ms"]) == CLOUDS * guard.COMMANDS_A_CLOUD <= met["said"]


@pytest.mark.slow
def test_the_json_names_every_figure_and_case(tmp_path):
    file = tmp_path / "figures.json"
    parts = ["--only", "nodes", "--only", "depth", "--only", "cameras"]
    little = ["--quick", *parts, "--repetitions", "1", "--clouds", "2"]
    subprocess.run([sys.executable, Path(__file__).parent, *little, "--json", file], stdout=subprocess.DEVNULL, check=True)
    figures = json.loads(file.read_text())
    ratios = ("node_cpu_vs_tutorial", "node_cpu_vs_floor", "node_latency_vs_floor")
    for name in (*ratios, "node_faults_per_cloud", "nodelet_latency_ms", "depth_cpu_vs_chain"):
        assert set(figures[name]) == {"worst", "median"}
    [case] = figures["nodes"]
    assert set(case) == {"case", *nodes.SIDES}
    assert set(case["ours"]) == {"latency_ms", "latency_p99_ms", "cpu_ms", "faults"}
    assert [row["cameras"] for row in figures["cameras"]] == [1, 2, 4]
