# SPDX-License-Identifier: BSD-3-Clause
"""Every command of TUTORIAL.md does what the page says."""
import os

import pytest
from page import PAGE, Step, missing_in, steps_of


def test_a_command_its_output_and_its_picture_are_one_step():
    text = "```sh stays\nls\n```\n\nwords\n\n```text\na 1\n```\n\n![it](a/b.png)\n\n```sh\ncd\n```\n"
    assert steps_of(text) == [Step("ls", "stays", ("a 1",), "a/b.png"), Step("cd", "")]


def test_what_is_shown_is_looked_for_in_its_order_and_with_any_number():
    assert missing_in("x\nnearest 0.513 m\nSafe\n", ("nearest 0.5 m", "Safe")) is None
    assert missing_in("Safe\nnearest 0.5 m\n", ("nearest 0.5 m", "Safe")) == "Safe"


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
