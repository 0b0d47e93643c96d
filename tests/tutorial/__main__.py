# SPDX-License-Identifier: BSD-3-Clause
"""Takes the tutorial's pictures anew: python tests/tutorial, after scripts/setup --checks, with the package sourced."""
import os
import tempfile
from functools import partial
from pathlib import Path

from follow import follow, keep_picture
from page import PAGE, steps_of

from safety_control_cloud.ros_session import roscore
from safety_control_cloud.virtual_screen import virtual_screen

with tempfile.TemporaryDirectory() as name, virtual_screen(1440, 900) as display, roscore():
    folder = Path(name)
    os.environ.update(DISPLAY=display, LIBGL_ALWAYS_SOFTWARE="1")
    follow(steps_of(PAGE.read_text()), folder, partial(keep_picture, folder=folder, page=PAGE), windows=True)
