# SPDX-License-Identifier: BSD-3-Clause
"""The core's gtests and all fault tests once more, against what a sanitizer has been built into."""
import os
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import dynamic_reconfigure.client
import pytest
import rospy
from robot import NODE
from std_srvs.srv import Trigger

from safety_control_cloud.processes import process

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PYTHON = "/usr/bin/python3"  # ROS's own, see scripts/setup
TARGETS = ("safety_control_node", "safety_control_core_tests", "safety_control_nodelet", "safety_control_nodelet_camera")
FAST = ("160", "120", "200", "10", "1000")  # pixels, rows, [Hz], clouds to warm up and to count
OPTIONS = {
    # roscpp locks connections in both orders; this package locks nothing.
    "TSAN_OPTIONS": f"suppressions={HERE / 'thread.supp'} detect_deadlocks=0",
    "UBSAN_OPTIONS": "print_stacktrace=1",
}
TESTS_FAILED = 1  # as pytest ends
FAULTY = """
#include <cstdlib>
#include <thread>
int shared = 0;
int main(int size, char**) {
  std::thread other([] { shared = 1; });
  shared = 2;
  other.join();
  volatile char* past = static_cast<char*>(std::malloc(size));
  return past[size];
}
"""

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


def test_the_node_stands_every_fault(build, tmp_path):
    """What a sanitizer finds in any run counts. What comes too late is asked once more, alone: a sanitizer makes a node
    many times slower, and a machine may be busy."""
    node = build / "devel" / "lib" / "safety_control_cloud" / "safety_control_node_sanitized"
    findings = tmp_path / "finding"
    faults = [sys.executable, "-m", "pytest", HERE, "-k", "not soak and not sanitized", "-o", f"cache_dir={tmp_path / 'cache'}"]
    environment = {"SAFETY_CONTROL_NODE": str(node), **writing_to(findings)}
    first = finished(*faults, **environment)
    if first.returncode == TESTS_FAILED:
        run(*faults, "--last-failed", "--last-failed-no-failures", "none", **environment)
    else:
        assert first.returncode == 0, first.stdout[-8000:]
    assert [path.read_text() for path in tmp_path.glob(findings.name + ".*")] == []


def test_a_finding_is_written_where_it_is_looked_for(build, tmp_path):
    """Even if whoever started the node does not ask how it ended."""
    source, program = tmp_path / "faulty.cpp", tmp_path / "faulty"
    source.write_text(FAULTY)
    kind = "thread" if build.name == "sanitized_threads" else "address,undefined"
    run("c++", f"-fsanitize={kind}", "-O1", "-g1", "-pthread", source, "-o", program)
    finished(program, **writing_to(tmp_path / "finding"))
    assert list(tmp_path.glob("finding.*"))


def test_the_nodelet_stands_a_camera_of_200_Hz_in_its_process(build, master):
    """While it is set and reset."""
    where = {**OPTIONS, "CMAKE_PREFIX_PATH": f"{build / 'devel'}:{os.environ['CMAKE_PREFIX_PATH']}"}
    command = ["env", *(f"{name}={value}" for name, value in where.items())]
    with process([*command, str(build / "tests/benchmarks/nodelet_camera"), *FAST, "_source_timeout:=10.0"]) as camera:
        settings = dynamic_reconfigure.client.Client(NODE, timeout=60.0)
        reset = rospy.ServiceProxy(NODE + "/reset", Trigger)
        reset.wait_for_service(60.0)
        assert str(build / "devel/lib/libsafety_control_nodelet.so") in Path(f"/proc/{camera.pid}/maps").read_text()
        turns = 0
        ended = (rospy.ServiceException, dynamic_reconfigure.DynamicReconfigureCallbackException)
        with suppress(*ended):
            while camera.exit_code is None:
                settings.update_configuration({"min_points": 1 + turns % 2})
                reset()
                turns += 1
        assert camera.wait(60.0) == 0, camera.output()
        assert turns > 20


def writing_to(path):
    """The options with which a sanitizer writes what it finds into a file that begins so."""
    return {name: f"{OPTIONS.get(name, '')} log_path={path}".strip() for name in ("ASAN_OPTIONS", "TSAN_OPTIONS", "UBSAN_OPTIONS")}


def finished(*command, **environment):
    return subprocess.run(
        command, cwd=ROOT, env={**os.environ, **OPTIONS, **environment}, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True)


def run(*command, **environment):
    result = finished(*command, **environment)
    assert result.returncode == 0, result.stdout[-8000:]
