# SPDX-License-Identifier: BSD-3-Clause
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from patience import eventually
from tree import PYTHON, ROOT

from safety_control_cloud.processes import OF_ROSLAUNCH, ProcessError, process

STUBBORN = "import signal, time; signal.signal(signal.SIGINT, signal.SIG_IGN); print('up', flush=True); time.sleep(600)"


def exists(pid):
    """Not counting a zombie, which has ended and waits to be asked how."""
    status = Path(f"/proc/{pid}/status")
    return status.exists() and "State:\tZ" not in status.read_text()


def test_a_process_that_ignores_ctrl_c_is_ended_all_the_same():
    with process([sys.executable, "-c", STUBBORN], ((signal.SIGINT, 0.2), (signal.SIGTERM, 5.0))) as running:
        eventually(lambda: running.output() == "up\n")

    assert running.exit_code == -signal.SIGTERM


def test_what_a_process_has_started_ends_with_it():
    with process([sys.executable, "-c", "import subprocess; subprocess.Popen(['sleep', '600']); print('up')"]) as running:
        running.wait(30.0)
        sleepers = subprocess.run(["pgrep", "-g", str(running.pid)], stdout=subprocess.PIPE, text=True).stdout.split()
        assert len(sleepers) == 1

    eventually(lambda: not exists(sleepers[0]))


def test_who_ends_roslaunch_waits_longer_than_roslaunch_waits_for_its_nodes():
    nodeprocess = pytest.importorskip("roslaunch.nodeprocess")
    number, patience = OF_ROSLAUNCH[0]
    assert number == signal.SIGINT and patience > nodeprocess.DEFAULT_TIMEOUT_SIGINT + nodeprocess.DEFAULT_TIMEOUT_SIGTERM + 2.0


def test_every_roslaunch_is_ended_with_that_patience():
    sources = [*PYTHON.rglob("*.py"), *(ROOT / "tests").rglob("*.py")]
    started = [line for path in sources for line in re.findall(r'rocess\(\["roslaunch".*', path.read_text())]
    assert started and [line for line in started if "OF_ROSLAUNCH" not in line] == []


def test_a_command_that_is_not_there_is_named():
    with pytest.raises(ProcessError, match="no_such_command"):
        with process(["no_such_command"]):
            pass


def test_sigterm_leaves_every_block_in_order():
    code = ("import os, signal\n"
            "from safety_control_cloud.processes import end_on_sigterm\n"
            "end_on_sigterm()\n"
            "try: os.kill(os.getpid(), signal.SIGTERM)\n"
            "finally: print('in order')")

    result = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)

    assert (result.returncode, result.stdout) == (128 + signal.SIGTERM, "in order\n")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_process_that_is_just_starting_does_not_outlive_a_signal(monkeypatch, number):
    started = []
    start = subprocess.Popen

    def start_and_be_interrupted(*arguments, **options):
        started.append(start(*arguments, **options))
        signal.raise_signal(number)
        return started[0]

    monkeypatch.setattr(subprocess, "Popen", start_and_be_interrupted)
    usual = signal.signal(number, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            with process(["sleep", "600"]):
                pytest.fail("the block was entered")
    finally:
        signal.signal(number, usual)
    assert started[0].poll() is not None
