# SPDX-License-Identifier: BSD-3-Clause
"""A machine that stands still shows nothing of who is timed on it: a test that fails meanwhile is asked once more.

Virtual machines are paused, for tenths of a second or for seconds, and all that is timed on them with them. A process of
its own that has nothing to do but to wake sees that, though pytest's be busy.
"""
from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest
from _pytest.runner import runtestprotocol

LONGEST = 0.2  # [s] that whoever has slept may wait for a core: the faults' tests allow the node 0.25 s
PERIOD = 0.02  # [s]


def watch(into: Path) -> None:
    """Writes down when it was woken late, and by how much [s], until whoever started it has gone."""
    before, parent = time.monotonic(), os.getppid()
    while os.getppid() == parent:
        time.sleep(PERIOD)
        now = time.monotonic()
        if now - before > LONGEST:
            with into.open("a") as file:
                file.write(f"{now} {now - before:.3f}\n")
        before = now


class Stalls:
    """Watches until it is ended."""

    def __init__(self) -> None:
        self._folder = tempfile.TemporaryDirectory()
        self._file = Path(self._folder.name) / "stalls"
        self._process = subprocess.Popen([sys.executable, __file__, str(self._file)])

    def since(self, moment: float) -> list[float]:
        """How long [s] the machine stood still each time since then, by time.monotonic()."""
        lines = self._file.read_text().splitlines() if self._file.exists() else []
        seen = [tuple(map(float, line.split())) for line in lines]
        return [lasted for ended, lasted in seen if ended >= moment]

    def end(self) -> None:
        self._process.kill()
        self._process.wait()
        self._folder.cleanup()


class AskedOnceMore:
    """A plugin: what fails while the machine stands still is run again, and that counts. The terminal says so."""

    def __init__(self, stalls: Stalls) -> None:
        self._stalls, self._told = stalls, []

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_protocol(self, item, nextitem):
        began = time.monotonic()
        item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
        reports = runtestprotocol(item, nextitem=nextitem, log=False)
        stood_still = self._stalls.since(began) if any(report.failed for report in reports) else []
        if stood_still:
            why = next(str(report.longrepr) for report in reports if report.failed).splitlines()[-1]
            self._told.append(f"{item.nodeid}: the machine stood still for {max(stood_still):.2f} s. It had said: {why}")
            item._initrequest()  # its fixtures are of one run
            reports = runtestprotocol(item, nextitem=nextitem, log=False)
        for report in reports:
            item.ihook.pytest_runtest_logreport(report=report)
        item.ihook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
        return True

    def pytest_terminal_summary(self, terminalreporter):
        for line in self._told:
            terminalreporter.write_line("asked once more: " + line)

    def pytest_unconfigure(self):
        self._stalls.end()


if __name__ == "__main__":
    watch(Path(sys.argv[1]))
