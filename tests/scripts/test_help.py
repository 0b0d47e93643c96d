# SPDX-License-Identifier: BSD-3-Clause
"""Every script answers --help at once, on a machine with Python alone, in a clone in which nothing has been set up; a word that
it does not know is named."""
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = sorted(path.name for path in (ROOT / "scripts").iterdir() if path.is_file())
MADE_LATER = (".git", ".venv", "build*", "devel", "__pycache__")
SECONDS = 10  # on a busy machine; alone it takes a tenth
NO_PACKAGES = 'import sys\nsys.path[:] = [path for path in sys.path if "-packages" not in path]\n'


@pytest.fixture
def fresh(tmp_path):
    """A copy of the sources in a catkin workspace that has not been built."""
    copy = tmp_path / "src" / "safety_control_cloud"
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(*MADE_LATER))
    return copy


@pytest.fixture
def alone(tmp_path):
    """The environment of somebody who has Python and no package, neither Debian's nor PyPI's."""
    (tmp_path / "alone").mkdir()
    (tmp_path / "alone" / "sitecustomize.py").write_text(NO_PACKAGES)
    return {"PATH": "/usr/bin:/bin", "HOME": str(tmp_path), "PYTHONPATH": str(tmp_path / "alone")}


def files_in(folder):
    return {path for path in folder.rglob("*") if "alone" not in path.parts}


@pytest.mark.parametrize("arguments", [["--help"], ["-h"]], ids=" ".join)
@pytest.mark.parametrize("script", SCRIPTS)
def test_help_is_given_at_once_and_sets_up_nothing(script, arguments, fresh, alone, tmp_path):
    before = files_in(tmp_path)
    result = subprocess.run(
        [fresh / "scripts" / script, *arguments], cwd=tmp_path, env=alone, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        timeout=SECONDS)
    assert result.returncode == 0 and re.match(rf"usage: (scripts/)?{script} ", result.stdout, re.IGNORECASE), result.stdout
    assert files_in(tmp_path) == before


@pytest.mark.parametrize("said, words", [
    ("setup: there is no option '--nope'", ["setup", "--nope"]),
    ("setup: --with is not followed by a group: 'nonsense'", ["setup", "--with", "nonsense"]),
    ("package: there is no option '--nope'", ["package", "--nope"]),
    ("package: --out is not followed by a folder", ["package", "--out"]),
    ("platforms: there is no platform 'debian99'", ["test", "--platform", "debian99"]),
])
def test_a_word_that_is_not_known_is_named_below_the_usage(said, words, fresh, alone, tmp_path):
    result = subprocess.run(
        [fresh / "scripts" / words[0], *words[1:]], cwd=tmp_path, env=alone, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        timeout=SECONDS)
    usage, _, last = result.stderr.rstrip().rpartition("\n")
    assert (result.returncode, result.stdout, last) == (2, "", said) and usage.startswith("Usage: ")


def test_a_machine_with_python_alone_has_no_numpy(alone):
    result = subprocess.run(["/usr/bin/python3", "-c", "import numpy"], env=alone, stderr=subprocess.PIPE, text=True)
    assert "No module named 'numpy'" in result.stderr
