# SPDX-License-Identifier: BSD-3-Clause
"""Tests that fail while the machine stands still are asked once more, and no others."""
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from patience import eventually
from stalls import Stalls

SUPPORT = Path(__file__).resolve().parent / "support"
FAILS_AT_FIRST = """
import pytest
from pathlib import Path
ASKED = Path(__file__).with_name("asked")

@pytest.fixture
def fresh():
    return []

def test_one(fresh):
    fresh.append(1)
    ASKED.write_text(ASKED.read_text() + "x" if ASKED.exists() else "x")
    assert fresh == [1] and len(ASKED.read_text()) > {failures}
"""
RUN = """
import sys, pytest, stalls
class Known:
    def since(self, moment):
        return {stalls}
    def end(self):
        pass
sys.exit(pytest.main([sys.argv[1], "-p", "no:cacheprovider"], plugins=[stalls.AskedOnceMore(Known())]))
"""


def run(folder, failures, stalls):
    file = folder / "test_it.py"
    file.write_text(FAILS_AT_FIRST.format(failures=failures))
    command = [sys.executable, "-c", RUN.format(stalls=stalls), str(file)]
    ended = subprocess.run(command, cwd=folder, env={**os.environ, "PYTHONPATH": str(SUPPORT)}, stdout=subprocess.PIPE, text=True)
    return ended.returncode, len((folder / "asked").read_text()), ended.stdout


@pytest.mark.parametrize("failures, stalls, ends, asked", [(0, [0.5], 0, 1), (1, [0.5], 0, 2), (1, [], 1, 1), (2, [0.5], 1, 2)])
def test_what_fails_meanwhile_is_asked_once_more(tmp_path, failures, stalls, ends, asked):
    code, times, said = run(tmp_path, failures, stalls)
    assert (code, times) == (ends, asked), said
    assert ("asked once more: test_it.py::test_one: the machine stood still for 0.50 s" in said) == (asked == 2)


def test_a_process_that_does_not_run_is_noticed():
    began, stalls = time.monotonic(), Stalls()
    try:
        time.sleep(0.5)
        os.kill(stalls._process.pid, signal.SIGSTOP)
        time.sleep(0.6)
        os.kill(stalls._process.pid, signal.SIGCONT)
        assert 0.4 < max(eventually(lambda: stalls.since(began))) < 5.0
        assert stalls.since(time.monotonic()) == []
    finally:
        stalls.end()
