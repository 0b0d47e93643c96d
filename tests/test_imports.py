# SPDX-License-Identifier: BSD-3-Clause
"""Folder = permission: what a Python file may import follows from where it lies."""
import ast
import re

import pytest
from tree import PYTHON, files

KNOWS_ROS = re.compile(r"^((?!rosbags$)ros\w*|tf2?(_\w+)?|genpy|dynamic_reconfigure|diagnostic_updater|\w+_msgs|\w+_srvs)$")
OWN_ROS = re.compile(r"^safety_control_cloud\.(msg|srv|cfg|nodes?)\b")


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


@pytest.mark.parametrize("file", files(PYTHON / "simulation", ".py") + files(PYTHON / "trials", ".py") + files(PYTHON / "view", ".py"))
def test_simulation_trials_and_view_know_no_ros(file):
    assert list(forbidden_without_ros(file)) == []


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
