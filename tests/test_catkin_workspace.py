# SPDX-License-Identifier: BSD-3-Clause
"""The package in a catkin workspace: catkin_make, catkin_make install, and life from the install space."""
import os
import re
import shutil
import signal
import socket
import subprocess
import time
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PYTHON = "/usr/bin/python3"  # ROS's own, whichever stands first in PATH
SYSTEM_PATH = "/usr/local/bin:/usr/bin:/bin"
BUILD_SECONDS = 1500

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("catkin_make") is None, reason="catkin_make is not installed"),
]


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    """A workspace with this package in src/, built and installed."""
    folder = tmp_path_factory.mktemp("workspace")
    (folder / "src").mkdir()
    (folder / "src" / "safety_control_cloud").symlink_to(ROOT)
    python = [f"-D{name}_EXECUTABLE={PYTHON}" for name in ("Python", "Python3", "PYTHON")]
    # All as a user would have it but for the optimiser: nothing is timed here.
    build = ["catkin_make", *python, "-DCATKIN_ENABLE_TESTING=OFF", "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG", "-j2"]
    for command in (build, [*build, "install"]):
        result = run(command, cwd=folder, env=environment(), timeout=BUILD_SECONDS)
        if result.returncode != 0:
            pytest.fail(f"{' '.join(command)}\n{result.stdout[-5000:]}", pytrace=False)
    return folder


@pytest.fixture(scope="module")
def installed(workspace):
    """The environment of the install space."""
    return environment(workspace / "install" / "setup.bash")


@pytest.fixture
def master(installed, tmp_path):
    """The environment of a ROS master on a free port."""
    with socket.socket() as free:
        free.bind(("localhost", 0))
        port = free.getsockname()[1]
    here = {**installed, "ROS_MASTER_URI": f"http://localhost:{port}", "ROS_HOME": str(tmp_path)}
    with process(["roscore", "-p", str(port)], here):
        wait_for(lambda: run(["rosparam", "list"], env=here).returncode == 0, "roscore")
        yield here


def test_it_is_built_for_release_though_nobody_says_so(workspace):
    assert "CMAKE_BUILD_TYPE:STRING=Release" in (workspace / "build" / "CMakeCache.txt").read_text()


def test_the_node_starts_from_the_install_space_and_says_stop(master):
    with process(["rosrun", "safety_control_cloud", "safety_control_node"], master) as node:
        twist = run(["rostopic", "echo", "-n", "1", "/cmd_vel_mux/input/teleop"], env=master, timeout=60)
        assert re.findall(r"x: (\S+)", twist.stdout) == ["0.0", "0.0"]
        assert node.poll() is None
        node.send_signal(signal.SIGINT)
        assert node.wait(timeout=10) == 0


def test_rosrun_finds_the_node_of_a_build_inside_the_package(master):
    setup = ROOT / "devel" / "setup.bash"
    if not setup.exists():
        pytest.skip("there is no devel/; scripts/setup makes it")
    inside = {**environment(setup), "ROS_MASTER_URI": master["ROS_MASTER_URI"], "ROS_HOME": master["ROS_HOME"]}
    with process(["rosrun", "safety_control_cloud", "safety_control_node"], inside) as node:
        wait_for(lambda: "/safety_control_cloud" in run(["rosnode", "list"], env=inside).stdout, "the node")
        assert node.poll() is None


@pytest.mark.parametrize("module", ["core", "msg"])
def test_python_imports_it_from_the_install_space(module, installed, workspace):
    code = f"import safety_control_cloud.{module} as module; print(module.__file__)"
    result = run([PYTHON, "-c", code], env=installed, cwd="/")
    assert str(workspace / "install") in result.stdout, result.stdout


@pytest.mark.parametrize(
    "file", ["package.xml", "msg/SafetyState.msg", *(f"safety_control_cloud/{folder}" for folder in ("config", "launch", "rviz", "urdf"))])
def test_a_path_in_the_package_is_the_same_in_the_install_space(file, workspace):
    assert (ROOT / file).exists()
    assert (workspace / "install" / "share" / "safety_control_cloud" / file).exists()


def test_types_are_installed_for_those_who_check_them(workspace):
    package = next((workspace / "install" / "lib").glob("python3*/*-packages/safety_control_cloud"))
    assert (package / "py.typed").exists() and (package / "core.pyi").exists()


def test_rosmsg_shows_the_state_message(installed):
    assert "float64 speed" in run(["rosmsg", "show", "safety_control_cloud/SafetyState"], env=installed).stdout


def environment(setup=None):
    """What a new terminal has, after sourcing `setup` or else the distribution's own ROS."""
    ubuntus = (Path(f"/opt/ros/{name}/setup.bash") for name in ("noetic", "one"))
    setup = setup or next(filter(Path.exists, ubuntus), "/dev/null")
    clean = {"PATH": SYSTEM_PATH, "HOME": os.environ.get("HOME", "/"), "LANG": "C.UTF-8"}
    result = subprocess.run(
        ["bash", "-c", 'source "$0" >/dev/null && env -0', setup], env=clean, stdout=subprocess.PIPE, text=True, check=True
    )
    return dict(entry.split("=", 1) for entry in result.stdout.split("\0") if "=" in entry and not entry.startswith("PWD="))


@contextmanager
def process(command, env):
    """A process with its children, ended with them."""
    started = subprocess.Popen(command, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        yield started
    finally:
        for end in (signal.SIGINT, signal.SIGKILL):
            with suppress(ProcessLookupError):
                os.killpg(started.pid, end)
            with suppress(subprocess.TimeoutExpired):
                started.wait(timeout=10)


def wait_for(condition, what, seconds=30):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"{what} did not come up within {seconds} s"
        time.sleep(0.1)


def run(command, timeout=60, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=timeout, **options)
