# SPDX-License-Identifier: BSD-3-Clause
"""Processes that end with the block that started them, whatever ends the block (an error, Ctrl-C).

SIGTERM runs no `finally` in Python unless it is made an exception: a script that starts processes calls
end_on_sigterm() first.
"""
from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import threading
from contextlib import contextmanager
from typing import IO, Iterator, List, Optional, Sequence, Tuple

Signals = Sequence[Tuple[signal.Signals, float]]  # how to end a process, and the patience [s] with each
SIGNALS: Signals = ((signal.SIGINT, 5.0), (signal.SIGTERM, 2.0), (signal.SIGKILL, 5.0))
# roslaunch itself has 15 s and 2 s of patience with its nodes, all at once: they outlive one that is killed before.
OF_ROSLAUNCH: Signals = ((signal.SIGINT, 25.0), (signal.SIGTERM, 5.0), (signal.SIGKILL, 5.0))
INTERRUPTS = (signal.SIGINT, signal.SIGTERM)


class ProcessError(RuntimeError):
    """A process could not be started, or ended when it should not have."""


class Process:
    """A running command, in a process group of its own so that Ctrl-C reaches it only through end()."""

    def __init__(self, command: Sequence[str], signals: Signals = SIGNALS) -> None:
        """Raises ProcessError if there is no such command."""
        self.command = tuple(command)
        self._signals = signals
        self._output: IO[bytes] = tempfile.TemporaryFile()
        try:
            self._popen = subprocess.Popen(
                self.command, stdin=subprocess.DEVNULL, stdout=self._output, stderr=subprocess.STDOUT,
                start_new_session=True)
        except OSError as error:
            raise ProcessError(f"cannot start {self.command[0]}: {error.strerror}") from error

    @property
    def pid(self) -> int:
        return self._popen.pid

    @property
    def exit_code(self) -> Optional[int]:
        """None while it runs; -N if signal N ended it."""
        return self._popen.poll()

    def output(self) -> str:
        """What it has written so far, stdout and stderr in the order of writing."""
        size = os.fstat(self._output.fileno()).st_size
        return os.pread(self._output.fileno(), size, 0).decode(errors="replace")

    def wait(self, timeout: float) -> int:
        """The exit code. Raises subprocess.TimeoutExpired if it still runs after so many seconds."""
        return self._popen.wait(timeout)

    def send(self, number: signal.Signals) -> None:
        """Sends a signal to the process and to whatever it has started."""
        try:
            os.killpg(self.pid, number)
        except ProcessLookupError:
            pass  # it has ended by itself, which is what signals are sent for

    def end(self) -> None:
        """Ends it, politely first, and with it whatever it has started."""
        for number, patience in self._signals:
            if self.exit_code is not None:
                break
            self.send(number)
            try:
                self.wait(patience)
            except subprocess.TimeoutExpired:
                continue
        self.send(signal.SIGKILL)


@contextmanager
def process(command: Sequence[str], signals: Signals = SIGNALS) -> Iterator[Process]:
    """Runs a command for as long as the block lasts."""
    running = None
    try:
        with _signals_deferred():
            running = Process(command, signals)
        yield running
    finally:
        if running:
            running.end()


@contextmanager
def _signals_deferred() -> Iterator[None]:
    """Lets Ctrl-C and SIGTERM wait for the end of the block: a process is not to start unseen by who ends it."""
    if threading.current_thread() is not threading.main_thread():
        yield  # Python handles signals in its main thread alone
        return
    arrived: List[int] = []
    usual = {number: signal.signal(number, lambda number, frame: arrived.append(number)) for number in INTERRUPTS}
    try:
        yield
    finally:
        for number, handler in usual.items():
            signal.signal(number, handler)
        for number in arrived:
            signal.raise_signal(number)


def end_on_sigterm() -> None:
    """Lets SIGTERM end this process as sys.exit() does, so that every `with` block is left in order."""
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))
