# SPDX-License-Identifier: BSD-3-Clause
"""Does what TUTORIAL.md says, as its reader would, and sees whether it is so."""
from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Callable, List

from page import Step, missing_in

from safety_control_cloud.processes import OF_ROSLAUNCH, SIGNALS, Process, process

PATIENCE = 120.0  # [s] for a busy machine
PLAIN = 20_000  # [byte] a picture with less shows nothing yet
SETTLED = 15.0  # [s] rviz draws in software
SCRIPT = "scripts/"  # their own setup is another test's


class NotSo(AssertionError):
    """str() names the command, what it should have shown, and what it has."""


def follow(steps: List[Step], folder: Path, show: Callable[[Step], None], windows: bool = False) -> None:
    """Runs all commands in `folder`; `show` is called where the page has a picture. Raises NotSo."""
    os.environ["ROSCONSOLE_STDOUT_LINE_BUFFERED"] = "1"  # as at a terminal
    with ExitStack() as running:
        for step in steps:
            if step.kind == "stays" or step.kind == "window" and windows:
                signals = OF_ROSLAUNCH if step.command.startswith("roslaunch ") else SIGNALS
                command = ["bash", "-c", f"cd {shlex.quote(str(folder))}; exec {step.command}"]
                _watch(running.enter_context(process(command, signals)), step)
            elif step.kind == "":
                _run(step, folder)
            if step.picture:
                show(step)


def _watch(started: Process, step: Step) -> None:
    end = time.monotonic() + PATIENCE
    while missing_in(started.output(), step.shown):
        if time.monotonic() > end or started.exit_code is not None:
            raise NotSo(f"{step.command}\nnot shown: {missing_in(started.output(), step.shown)}\n{started.output()}")
        time.sleep(0.05)


def _run(step: Step, folder: Path) -> None:
    command = shlex.split(step.command)
    if step.command.startswith(SCRIPT):
        command = [sys.executable, "-m", f"safety_control_cloud.{command[0][len(SCRIPT):]}", *command[1:]]
    result = subprocess.run(
        command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=PATIENCE, env={**os.environ, "COLUMNS": "200"})
    missing = missing_in(result.stdout, step.shown)
    if result.returncode != 0 or missing:
        raise NotSo(f"{step.command}\nexit {result.returncode}, not shown: {missing}\n{result.stdout}")


def keep_picture(step: Step, folder: Path, page: Path) -> None:
    """A file that the commands have made, or else a photograph of the screen, where the page links it."""
    target = page.parent / step.picture
    target.parent.mkdir(parents=True, exist_ok=True)
    made = folder / target.name
    if made.exists():
        shutil.copy(made, target)
        return
    end = time.monotonic() + PATIENCE
    while _photograph(target) < PLAIN and time.monotonic() < end:
        time.sleep(1.0)
    time.sleep(SETTLED)
    _photograph(target)


def _photograph(target: Path) -> int:
    """Of the screen; gives its size [byte]."""
    small = ["-resize", "900x", "-dither", "None", "-colors", "64", "-strip"]
    subprocess.run(["import", "-window", "root", *small, f"png8:{target}"], check=True)
    return target.stat().st_size
