# SPDX-License-Identifier: BSD-3-Clause
import subprocess
import sys

from recordings import TOPIC, wall_at, write_ros1

from safety_control_cloud import core
from safety_control_cloud.replay.lockstep import distinct, parameters_for_replay

# rospy starts once per process, so this runs in one of its own. The pauses are longer than the node's patience: it
# says SILENT between the clouds, with the stamp of the cloud before, which is the stamp of the next one too.
SLOW = """
import sys, time
from pathlib import Path
from safety_control_cloud.replay.recording import recording
from safety_control_cloud.replay.nodes import safety_nodes
from safety_control_cloud.view.memory import spots_in
with recording([Path(sys.argv[1])]) as recorded, safety_nodes({"source_timeout": "0.1"}, recorded.sources) as nodes:
    for cloud in recorded.clouds:
        answer = nodes.answer_to(cloud)
        print(answer.stamp, answer.cause, round(answer.nearest, 3))
        time.sleep(0.7)
        print(len(spots_in(nodes.remembered(cloud.topic))) > 0)
"""


def test_a_repeated_state_of_the_cloud_before_is_never_taken_for_the_answer(tmp_path):
    bag = write_ros1(tmp_path / "slow.bag", {TOPIC: [wall_at(d, stamp) for d, stamp in [(0.5, 0), (0.8, 0), (1.1, 0)]]})

    result = subprocess.run([sys.executable, "-c", SLOW, str(bag)], capture_output=True, text=True, timeout=120)

    assert (result.stdout, result.stderr) == ("0 SEEN 0.5\nTrue\n0 SEEN 0.8\nFalse\n0 SEEN 1.1\nFalse\n", "")


def test_stamps_are_made_distinct_and_never_run_to_and_fro_where_the_recorded_ones_do_not():
    recorded, sent = [0, 0, 0, 1, 1, 4, 10**9 - 1, 10**9 - 1, 3, 3, 9], [0]
    for before, stamp in zip([0, *recorded], recorded):
        sent.append(distinct(stamp, before, sent[-1]))

    assert sent[1:] == [1, 2, 3, 4, 5, 6, 10**9 - 1, 10**9, 3, 4, 9]


def test_neither_silence_nor_age_is_judged_in_a_recording():
    parameters = parameters_for_replay({})

    patience = float(parameters["source_timeout"])
    assert core.Settings(source_timeout=patience).problems() == []
    assert core.Settings(source_timeout=patience + 0.1).problems() == ["source_timeout must be at most 10"]
    assert float(parameters.get("stamp_tolerance", 0.0)) == 0.0


def test_only_parameters_that_the_node_has_are_set():
    assert set(parameters_for_replay({})) <= set(core.Settings().as_dict())


def test_what_the_caller_chooses_goes_before():
    chosen = {"source_timeout": "0.2", "method": "pcl"}

    assert parameters_for_replay(chosen).items() >= chosen.items()
