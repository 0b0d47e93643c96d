# SPDX-License-Identifier: BSD-3-Clause
"""The core's gtests and all fault tests once more, against what a sanitizer has been built into."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PYTHON = "/usr/bin/python3"  # ROS's own, see scripts/setup
TARGETS = ("safety_control_node", "safety_control_core_tests")
OPTIONS = {
    # roscpp locks connections in both orders; this package locks nothing.
    "TSAN_OPTIONS": f"suppressions={HERE / 'thread.supp'} detect_deadlocks=0",
    "UBSAN_OPTIONS": "print_stacktrace=1",
}

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif("SAFETY_CONTROL_SANITIZE" not in os.environ, reason="takes long: scripts/test --sanitize"),
]


@pytest.fixture(scope="module", params=[("sanitized", "address,undefined"), ("sanitized_threads", "thread")], ids="-".join)
def build(request):
    folder, sanitizers = request.param
    build = ROOT / "build" / folder
    run(
        "cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1 -g1",
        f"-DSAFETY_CONTROL_SANITIZE={sanitizers}", f"-DPython3_EXECUTABLE={PYTHON}", f"-DPYTHON_EXECUTABLE={PYTHON}",
        "-DCATKIN_ENABLE_TESTING=ON", PATH="/usr/bin:" + os.environ["PATH"])
    run("cmake", "--build", build, "--target", *TARGETS, "-j2")
    return build


def test_the_core_keeps_its_promises(build):
    gtests = [name for name in (build / "tests" / "gtests").read_text().split() if name.startswith("core/")]
    assert gtests
    for name in gtests:
        run(build / "tests" / name)


def test_the_node_stands_every_fault(build):
    node = build / "devel" / "lib" / "safety_control_cloud" / "safety_control_node_sanitized"
    run(sys.executable, "-m", "pytest", HERE, "-k", "not soak and not sanitized", SAFETY_CONTROL_NODE=str(node))


def run(*command, **environment):
    result = subprocess.run(
        command, cwd=ROOT, env={**os.environ, **OPTIONS, **environment}, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True)
    assert result.returncode == 0, result.stdout[-8000:]
