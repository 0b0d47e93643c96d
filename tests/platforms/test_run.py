# SPDX-License-Identifier: BSD-3-Clause
"""What tests/platforms/run says before it makes anything; a run itself takes half an hour and is no test among the others."""
import os
import re
import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PLATFORMS = {"debian11", "debian12", "debian13"}


def run(*arguments, script=ROOT / "scripts" / "test", cache="/nonexistent", path="/usr/bin:/bin"):
    environment = {"PATH": str(path), "HOME": "/nonexistent", "SAFETY_CONTROL_PLATFORMS": str(cache)}
    return subprocess.run(
        [script, *arguments], env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)


def test_help_is_given_at_once():
    result = run("--platform", "--help")
    assert result.returncode == 0 and result.stdout.startswith("Usage: ")


@pytest.mark.parametrize("arguments", [(), ("debian9",), ("ubuntu20.04",)], ids=str)
def test_a_platform_that_is_not_known_is_refused(arguments):
    result = run("--platform", *arguments)
    assert result.returncode == 2 and PLATFORMS <= set(re.findall(r"\w+", result.stderr))


def test_a_step_that_is_not_known_is_refused():
    result = run("--platform", "debian13", "--step", "sleep")
    assert result.returncode == 2 and "'sleep'" in result.stderr


@pytest.mark.parametrize("platform", sorted(PLATFORMS - {"debian11"}))
def test_gazebo_is_refused_where_there_is_none(platform):
    result = run("--platform", platform, "--gazebo")
    assert result.returncode == 2 and "debian11" in result.stderr


def test_a_cache_in_the_sources_is_refused():
    result = run("--platform", "debian13", cache=ROOT / "build" / "platforms")
    assert result.returncode == 2 and "cache" in result.stderr


def test_who_cannot_make_a_root_is_told_why_and_nothing_is_made(tmp_path):
    for command in ("bash", "dirname", "readlink", "realpath"):
        (tmp_path / command).symlink_to(f"/usr/bin/{command}")
    result = run("debian13", script=HERE / "run", path=tmp_path, cache=tmp_path / "cache")
    wanted = "debootstrap is not installed" if os.geteuid() == 0 else "root"
    assert result.returncode == 1 and wanted in result.stderr
    assert not (tmp_path / "cache").exists()


def test_each_step_and_platform_is_in_the_help_and_each_platform_in_the_readme():
    told = run("--platform", "--help").stdout
    assert {path.name for path in (HERE / "steps").iterdir()} | PLATFORMS <= set(re.findall(r"\w+", told))
    assert PLATFORMS <= set(re.findall(r"\w+", (HERE / "README.md").read_text()))
