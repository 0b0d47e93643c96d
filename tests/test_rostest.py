# SPDX-License-Identifier: BSD-3-Clause
"""Every tests/**/*.test through rostest, each with a ROS master of its own."""
import os
import shutil
import subprocess
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parent
SECONDS = 600


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("rostest") is None, reason="rostest is not installed")
@pytest.mark.parametrize("path", [pytest.param(path, id=str(path.relative_to(TESTS))) for path in sorted(TESTS.rglob("*.test"))])
def test_rostest(path, tmp_path):
    result = subprocess.run(
        ["rostest", path],  # with --text it would exit with 0 whatever the tests say
        env={**os.environ, "ROS_HOME": str(tmp_path), "ROS_LOG_DIR": str(tmp_path / "log")},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=SECONDS,
    )
    if result.returncode != 0:
        results = "\n".join(found.read_text() for found in sorted(tmp_path.rglob("rosunit-*.xml")))
        pytest.fail(f"exit {result.returncode}\n{result.stdout}\n{results}", pytrace=False)
