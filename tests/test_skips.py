# SPDX-License-Identifier: BSD-3-Clause
"""Of the watch over skipped tests; see skips.py."""
import subprocess
import sys
from pathlib import Path

import pytest
import skips

TESTS = Path(__file__).resolve().parent
CONFTEST = """
from pathlib import Path
import skips
def pytest_configure(config):
    config.pluginmanager.register(skips.Watch(skips.allowed_in(Path("allowed.yaml")), "debian12"))
"""
SKIPS = {
    "call": 'import pytest\ndef test_sees():\n    pytest.skip("no camera")\n',
    "fixture": 'import pytest\n@pytest.fixture\ndef eye():\n    pytest.skip("no camera")\ndef test_sees(eye): pass\n',
    "mark": 'import pytest\n@pytest.mark.skipif(True, reason="no camera")\ndef test_sees(): pass\n',
    "module": 'import pytest\npytest.skip("no camera", allow_module_level=True)\n',
    "import": 'import pytest\npytest.importorskip("camera_that_is_not_there", reason="no camera")\n',
    "unittest": 'import unittest\nclass TestEye(unittest.TestCase):\n    def test_sees(self): self.skipTest("no camera")\n',
    "gtest": "import test_gtest\ndef test_sees(): test_gtest.Results('./gtest', ['Eye.Sees']).judge('Eye.Sees')\n",
}
GTEST = """#!/bin/sh
echo "[ RUN      ] Eye.Sees
eye_test.cpp:7: Skipped
no camera

[  SKIPPED ] Eye.Sees (0 ms)"
"""
LISTED = "- {{test: {test}, says: no camera, where: [{where}], because: this machine sees nothing}}\n"


@pytest.fixture
def run(tmp_path):
    """Runs pytest on a folder with one test that passes and one that skips in the given way."""
    (tmp_path / "conftest.py").write_text(CONFTEST)
    (tmp_path / "pytest.ini").write_text(f"[pytest]\npythonpath = {TESTS} {TESTS / 'support'}\n")
    (tmp_path / "test_feet.py").write_text("def test_stand(): pass\n")
    (tmp_path / "gtest").write_text(GTEST)
    (tmp_path / "gtest").chmod(0o755)

    def run(way, allowed, *arguments):
        (tmp_path / "test_eye.py").write_text(SKIPS[way])
        (tmp_path / "allowed.yaml").write_text(allowed)
        return subprocess.run(
            [sys.executable, "-m", "pytest", *arguments], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    return run


@pytest.mark.parametrize("way", SKIPS)
def test_a_skip_that_is_not_listed_fails_the_run_with_its_name_and_reason(way, run):
    result = run(way, "")
    assert result.returncode == 1, result.stdout
    told = result.stdout.partition("skipped, and not listed for debian12")[2]
    assert "test_eye.py" in told and "no camera" in told


@pytest.mark.parametrize("way", SKIPS)
@pytest.mark.parametrize("where", ["debian12", "everywhere"])
def test_a_listed_skip_leaves_the_run_green(way, where, run):
    result = run(way, LISTED.format(test="test_eye.py", where=where))
    assert result.returncode == 0 and "not listed" not in result.stdout, result.stdout


@pytest.mark.parametrize(
    "listed",
    [
        LISTED.format(test="test_eye.py", where="debian11, debian13"),
        LISTED.format(test="test_ey", where="debian12"),
        LISTED.format(test="test_eye.py::test_other", where="debian12"),
        LISTED.format(test="test_eye.py", where="debian12").replace("no camera", "no light"),
    ],
    ids=["platform", "beginning of a name", "test", "reason"],
)
def test_a_skip_listed_for_another_platform_test_or_reason_fails_the_run(listed, run):
    assert run("call", listed).returncode == 1


def test_what_was_not_selected_is_not_asked_for(run):
    assert run("call", "", "-k", "stand").returncode == 0
    assert run("call", "", "test_feet.py").returncode == 0


def test_a_test_that_fails_stays_failed_and_one_that_is_expected_to_fail_is_no_skip(run, tmp_path):
    (tmp_path / "test_legs.py").write_text("import pytest\n@pytest.mark.xfail\ndef test_fly(): assert False\n")
    assert run("call", "", "test_legs.py").returncode == 0
    (tmp_path / "test_legs.py").write_text("def test_fly(): assert False\n")
    assert run("call", "", "test_legs.py").returncode == 1


def test_this_run_is_watched(request):
    assert isinstance(request.config.pluginmanager.get_plugin("skips"), skips.Watch)


@pytest.mark.parametrize("listed", skips.allowed_in(skips.LIST), ids=lambda listed: listed.test)
def test_what_is_listed_exists(listed):
    file, _, name = listed.test.partition("::")
    source = (TESTS.parent / file).read_text()
    assert not name or f"def {name.partition('[')[0]}(" in source


@pytest.mark.parametrize("entry", ["- {test: a.py, says: b, where: [everywhere]}", "- {test: a.py, says: '', where: [c], because: d}"])
def test_an_entry_without_a_reason_is_refused(entry, tmp_path):
    (tmp_path / "allowed.yaml").write_text(entry)
    with pytest.raises(ValueError, match="a.py"):
        skips.allowed_in(tmp_path / "allowed.yaml")


@pytest.mark.parametrize(
    "text, named", [('ID=debian\nVERSION_ID="12"\n', "debian12"), ("ID=ubuntu\nVERSION_ID='20.04'\n", "ubuntu20.04"), ("", "unknown")]
)
def test_a_platform_is_named_as_the_system_names_itself(text, named, tmp_path):
    (tmp_path / "os-release").write_text(text)
    assert skips.platform(tmp_path / "os-release") == named
