# SPDX-License-Identifier: BSD-3-Clause
"""Every tests/**/*.test through rostest, each with a ROS master of its own."""
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from prefixes import prefixes

from safety_control_cloud.gazebo_ros import gazebo_ros_executable
from safety_control_cloud.processes import ProcessError

TESTS = Path(__file__).resolve().parent
SECONDS = 600
IN_GAZEBO = TESTS / "platforms" / "gazebo"


def has_gazebo():
    try:
        gazebo_ros_executable("gzserver")
    except ProcessError:
        return False
    return True


def parameters():
    without_gazebo = pytest.mark.skipif(not has_gazebo(), reason="gazebo_ros is not installed")
    for path in sorted(TESTS.rglob("*.test")):
        yield pytest.param(path, id=str(path.relative_to(TESTS)), marks=[without_gazebo] if IN_GAZEBO in path.parents else [])


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("rostest") is None, reason="rostest is not installed")
@pytest.mark.parametrize("path", list(parameters()))
def test_rostest(path, tmp_path):
    result = subprocess.run(
        ["rostest", path],  # with --text it would exit with 0 whatever the tests say
        env={**os.environ, "ROS_HOME": str(tmp_path), "ROS_LOG_DIR": str(tmp_path / "log"), "CMAKE_PREFIX_PATH": prefixes(tmp_path)},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=SECONDS,
    )
    if result.returncode != 0:
        results = "\n".join(found.read_text() for found in sorted(tmp_path.rglob("rosunit-*.xml")))
        pytest.fail(f"exit {result.returncode}\n{result.stdout}\n{results}", pytrace=False)
