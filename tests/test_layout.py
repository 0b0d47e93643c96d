# SPDX-License-Identifier: BSD-3-Clause
"""Folder = permission: what a file may include or import follows from where it lies."""
import ast
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
SOURCES = ROOT / "safety_control_cloud"
CORE = SOURCES / "core"
PYTHON = SOURCES / "python" / "safety_control_cloud"

TOP_LEVEL = {
    *("safety_control_cloud", "tests", "scripts", "CMakeLists.txt", "package.xml", "README.md"),
    *("msg", "cfg", "srv", "setup.py", "LICENSE", "CHANGELOG.rst"),
}
TOOLS_OF_A_CLONE = {"setup", "test", "demo", "bench", "trials"}
SOURCE_FOLDERS = {"core", "ros", "python", "launch", "config", "rviz"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD = re.compile(r"[a-z_0-9]+")  # <vector>, <cmath>: neither folder nor ending
OWN_LIBRARIES = ("Eigen/", "pcl/", "hwy/")
READS_A_CLOCK_OR_DOES_IO = {
    *("chrono", "ctime", "thread"),
    *("cstdio", "filesystem", "fstream", "iostream"),
}
IO_OF_PCL = ("pcl/console/", "pcl/io/", "pcl/visualization/")

KNOWS_ROS = re.compile(r"^((?!rosbags$)ros\w*|tf2?(_\w+)?|genpy|dynamic_reconfigure|diagnostic_updater|\w+_msgs|\w+_srvs)$")
OWN_ROS = re.compile(r"^safety_control_cloud\.(msg|srv|cfg|nodes?)\b")


def forbidden_in_core(file):
    """What a file of core/ includes beside the standard library, Eigen, PCL, Highway and core/ itself."""
    for bracket, name in INCLUDE.findall(file.read_text()):
        if bracket == '"':
            if (file.parent / name).resolve().parent != CORE:
                yield name
        elif name in READS_A_CLOCK_OR_DOES_IO or name.startswith(IO_OF_PCL):
            yield name
        elif not STANDARD.fullmatch(name) and not name.startswith(OWN_LIBRARIES):
            yield name


def forbidden_in_bindings(file):
    """The binding is the core's: pybind11 and the core, no ROS."""
    for bracket, name in INCLUDE.findall(file.read_text()):
        if bracket == '"':
            if (file.parent / name).resolve().parent not in (CORE, file.parent):
                yield name
        elif not STANDARD.fullmatch(name) and not name.startswith(("pybind11/", *OWN_LIBRARIES)):
            yield name


def modules_in(file):
    """The full name of every module that a Python file of the package imports, relative ones resolved."""
    package = ("safety_control_cloud", *file.parent.relative_to(PYTHON).parts)
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            module = ".".join([*base, *([node.module] if node.module else [])])
            yield module
            yield from (f"{module}.{alias.name}" for alias in node.names)


def forbidden_without_ros(file):
    return [name for name in modules_in(file) if KNOWS_ROS.match(name.split(".")[0]) or OWN_ROS.match(name)]


def files(folder, *endings):
    return [
        pytest.param(file, id=str(file.relative_to(ROOT)))
        for file in sorted(folder.rglob("*"))
        if file.suffix in endings and file.is_file()
    ]


@pytest.mark.parametrize("file", files(CORE, ".hpp", ".cpp"))
def test_the_core_knows_no_ros_no_clock_and_no_io(file):
    assert list(forbidden_in_core(file)) == []


@pytest.mark.parametrize("file", files(SOURCES / "python", ".hpp", ".cpp"))
def test_the_binding_knows_the_core_alone(file):
    assert list(forbidden_in_bindings(file)) == []


@pytest.mark.parametrize("file", files(PYTHON / "simulation", ".py") + files(PYTHON / "trials", ".py"))
def test_simulation_and_trials_know_no_ros(file):
    assert list(forbidden_without_ros(file)) == []


@pytest.mark.parametrize(
    "line, name",
    [
        ("#include <ros/ros.h>", "ros/ros.h"),
        ("#include <pcl_ros/point_cloud.h>", "pcl_ros/point_cloud.h"),
        ("#include <pcl/io/pcd_io.h>", "pcl/io/pcd_io.h"),
        ('  #  include "../ros/output/messages.hpp"', "../ros/output/messages.hpp"),
        ("#include <chrono>", "chrono"),
        ("#include <unistd.h>", "unistd.h"),
    ],
)
def test_an_include_that_the_core_may_not_have_is_found(line, name, tmp_path):
    file = tmp_path / "file.hpp"
    file.write_text(f"#pragma once\n#include <vector>\n#include <pcl/point_types.h>\n{line}\n")
    assert list(forbidden_in_core(file)) == [name]


@pytest.mark.parametrize(
    "line, name",
    [
        ("import rospy", "rospy"),
        ("from sensor_msgs.msg import PointCloud2", "sensor_msgs.msg"),
        ("from ..msg import SafetyState", "safety_control_cloud.msg"),
        ("import numpy, rosbag", "rosbag"),
        ("def late():\n    from .. import msg", "safety_control_cloud.msg"),
    ],
)
def test_an_import_that_the_simulation_may_not_have_is_found(line, name, monkeypatch, tmp_path):
    file = tmp_path / "simulation" / "file.py"
    file.parent.mkdir()
    file.write_text(f"import numpy\nfrom . import world\n{line}\n")
    monkeypatch.setitem(globals(), "PYTHON", tmp_path)
    assert name in forbidden_without_ros(file)


def test_the_top_level_holds_only_what_the_design_allows():
    tracked = {Path(path).parts[0] for path in tracked_files()}
    assert {name for name in tracked if not name.startswith(".")} - TOP_LEVEL == set()


def test_the_sources_have_their_own_folders():
    assert {path.name for path in SOURCES.iterdir() if path.name != "__pycache__"} - SOURCE_FOLDERS == set()


def test_no_source_folder_shadows_the_generated_package():
    assert not (SOURCES / "__init__.py").exists()


def test_a_script_is_installed_unless_it_is_a_tool_of_a_clone():
    installed = set(re.findall(r"\bscripts/(\w+)", (ROOT / "CMakeLists.txt").read_text()))
    assert installed == {path.name for path in (ROOT / "scripts").iterdir() if path.is_file()} - TOOLS_OF_A_CLONE


def test_every_source_names_its_licence():
    sources = [ROOT / path for path in tracked_files() if Path(path).suffix in (".py", ".hpp", ".cpp") or path.startswith("scripts/")]
    without = [path for path in sources if path.exists() and "SPDX-License-Identifier: BSD-3-Clause" not in path.read_text()[:200]]
    assert without == []


@pytest.mark.skipif(shutil.which("catkin_lint") is None, reason="catkin_lint is not installed")
def test_catkin_lint_finds_nothing():
    # The folder of a clone may bear any name, and not every machine has a rosdep database to compare with.
    result = subprocess.run(
        ["catkin_lint", "-W2", "--strict", "--offline", "--ignore", "package_path_name", ROOT],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    assert result.returncode == 0, result.stdout


def tracked_files():
    try:
        listing = subprocess.run(
            ["git", "-c", f"safe.directory={ROOT}", "-C", ROOT, "ls-files"], stdout=subprocess.PIPE, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("not a git clone")
    return listing.stdout.splitlines()
