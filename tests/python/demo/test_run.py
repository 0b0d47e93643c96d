# SPDX-License-Identifier: BSD-3-Clause
"""The demo's simulator dies, or never lived."""
import subprocess
import sys

import pytest

pytest.importorskip("rospy")

from safety_control_cloud.demo.__main__ import main  # noqa: E402

WAITS = """
import rospy
from safety_control_cloud.demo.run import _watched
from safety_control_cloud.processes import ProcessError, process
from safety_control_cloud.ros_session import roscore
with roscore(), process(["bash", "-c", "sleep 3; echo 'turtlebot_sim: it cannot be'; echo more"]) as launch:
    rospy.set_param("/use_sim_time", True)
    rospy.init_node("waits", disable_signals=True)
    try:
        with _watched(launch):
            {waits}
    except ProcessError as error:
        print(error)
"""


@pytest.mark.parametrize("waits", [
    "rospy.sleep(0.3)", "rospy.wait_for_service('/turtlebot_sim/reset', timeout=600.0)",
    "rospy.wait_for_message('/odom', rospy.AnyMsg, timeout=600.0)", "rospy.Rate(20.0).sleep()"])
def test_nothing_is_waited_for_once_the_simulator_has_died(waits):
    result = subprocess.run([sys.executable, "-c", WAITS.format(waits=waits)], capture_output=True, text=True, timeout=60)
    assert (result.returncode, result.stdout) == (0, "turtlebot_sim: it cannot be\n"), result.stderr


def test_a_world_that_nobody_can_drive_in_is_told_in_a_line(tmp_path, capsys):
    (tmp_path / "a.yaml").write_text("a: b\n")
    assert main(["guard", "--world", str(tmp_path / "a.yaml"), "--out", str(tmp_path)]) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"demo: cannot drive in {tmp_path}/a.yaml: ") and said.count("\n") == 1
