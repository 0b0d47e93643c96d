# SPDX-License-Identifier: BSD-3-Clause
"""Every command of TUTORIAL.md does what the page says."""
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from page import PAGE, Step, missing_in, steps_of
from patience import eventually

TUTORIAL = str(Path(__file__).parent)
SCREEN = '#!/bin/sh\neval "echo 99 >&$2"\nexec sleep 600\n'  # in Xvfb's place


def test_a_command_its_output_and_its_picture_are_one_step():
    text = "```sh stays\nls\n```\n\nwords\n\n```text\na 1\n```\n\n![it](a/b.png)\n\n```sh\ncd\n```\n"
    assert steps_of(text) == [Step("ls", "stays", ("a 1",), "a/b.png"), Step("cd", "")]


def test_what_is_shown_is_looked_for_in_its_order_and_with_any_number():
    assert missing_in("x\nnearest 0.513 m\nSafe\n", ("nearest 0.5 m", "Safe")) is None
    assert missing_in("Safe\nnearest 0.5 m\n", ("nearest 0.5 m", "Safe")) == "Safe"


@pytest.mark.parametrize("argument, code", [("--bogus", 2), ("--help", 0)])
def test_a_word_that_is_no_argument_of_its_own_starts_nothing(argument, code):
    result = subprocess.run([sys.executable, TUTORIAL, argument], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=30)
    assert result.returncode == code and result.stdout.startswith("usage: python tests/tutorial ")


def started_with(mark):
    """The processes that inherited this of their environment."""
    found = []
    for path in Path("/proc").glob("[0-9]*/environ"):
        try:
            found += [path.parent.name] if mark.encode() in path.read_bytes() else []
        except OSError:
            pass  # it has ended, or is another user's
    return found


def test_what_it_has_started_does_not_outlive_sigterm(tmp_path):
    pytest.importorskip("rospy")
    (tmp_path / "Xvfb").write_text(SCREEN)
    (tmp_path / "Xvfb").chmod(0o755)
    mark = f"STARTED_BY={tmp_path}"
    named = {**os.environ, "STARTED_BY": str(tmp_path), "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    running = subprocess.Popen([sys.executable, TUTORIAL], env=named, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    eventually(lambda: len(started_with(mark)) >= 3)  # the screen and the master
    running.send_signal(signal.SIGTERM)
    assert running.wait(60.0) == 128 + signal.SIGTERM
    assert started_with(mark) == []


@pytest.mark.slow
def test_every_command_does_what_the_page_says(tmp_path):
    if "SAFETY_CONTROL_TUTORIAL" not in os.environ:
        pytest.skip("takes long: SAFETY_CONTROL_TUTORIAL=1 scripts/test tests/tutorial")
    pytest.importorskip("rospy")
    from follow import follow

    from safety_control_cloud.ros_session import roscore

    pictures = []
    with roscore():
        follow(steps_of(PAGE.read_text()), tmp_path, pictures.append)
    assert len(pictures) == 4
