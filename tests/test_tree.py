# SPDX-License-Identifier: BSD-3-Clause
"""What lies where, and what each file bears."""
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from tree import ROOT, SOURCES, tracked_files

TOP_LEVEL = {
    *("safety_control_cloud", "tests", "scripts", "CMakeLists.txt", "package.xml", "README.md"),
    # rosmsg and rossrv, and so `rossrv show`, look for PACKAGE/msg and PACKAGE/srv where package.xml lies.
    *("msg", "cfg", "srv", "setup.py", "LICENSE", "CHANGELOG.rst"),
}
TOOLS_OF_A_CLONE = {"setup", "test", "demo", "bench", "trials", "package"}
SOURCE_FOLDERS = {"core", "ros", "python", "launch", "config", "rviz", "urdf"}
PAGES = {"GUARD.md", "README.md", "TUTORIAL.md", "LIMITS.md"}


def test_the_top_level_holds_only_what_the_design_allows():
    tracked = {Path(path).parts[0] for path in tracked_files()}
    assert {name for name in tracked if not name.startswith(".")} - TOP_LEVEL == set()


def test_the_sources_have_their_own_folders():
    assert {path.name for path in SOURCES.iterdir() if path.name != "__pycache__"} - SOURCE_FOLDERS - PAGES == set()


def test_no_source_folder_shadows_the_generated_package():
    assert not (SOURCES / "__init__.py").exists()


def test_a_script_is_installed_unless_it_is_a_tool_of_a_clone():
    installed = set(re.findall(r"\bscripts/(\w+)", (ROOT / "CMakeLists.txt").read_text()))
    assert installed == {path.name for path in (ROOT / "scripts").iterdir() if path.is_file()} - TOOLS_OF_A_CLONE


def test_every_fault_meets_the_node_that_may_be_built_with_a_sanitizer():
    """Which support/robot.py chooses."""
    files = [path for folder in ("faults", "support") for path in (ROOT / "tests" / folder).glob("*.py")]
    assert [path.name for path in files if 'node("safety_control_node"' in path.read_text()] == ["robot.py"]


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
