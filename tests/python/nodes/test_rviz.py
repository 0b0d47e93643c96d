# SPDX-License-Identifier: BSD-3-Clause
"""What a person sees in rviz, looked at: our configuration, on a virtual screen, with the whole stack running."""
from __future__ import annotations

import shutil
import subprocess
import time
from contextlib import contextmanager
from pathlib import Path
from typing import Optional

import numpy as np
import pytest

rosgraph = pytest.importorskip("rosgraph")

from matplotlib.image import imread  # noqa: E402

from safety_control_cloud.processes import OF_ROSLAUNCH, process  # noqa: E402
from safety_control_cloud.ros_session import roscore  # noqa: E402
from safety_control_cloud.virtual_screen import virtual_screen  # noqa: E402

PICTURE = Path(__file__).parents[3] / "build/rviz.png"  # kept, for whoever wants to look
WIDTH, HEIGHT = 1440, 900  # [px]
VIEW = np.s_[int(0.08 * HEIGHT):int(0.88 * HEIGHT), int(0.34 * WIDTH):]  # of the screen: the 3D view, no icons
PATIENCE = 240.0  # [s] for a busy computer that draws in software
STARTS = 3

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        not all(map(shutil.which, ("Xvfb", "import", "rviz", "roslaunch"))), reason="rviz or Xvfb is missing"),
]


def picture(path: Path) -> np.ndarray:
    """(height, width, 3) bytes of the screen."""
    subprocess.run(["import", "-window", "root", f"png24:{path}"], check=True)
    return np.rint(imread(path)[..., :3] * 255).astype(np.uint8)


def flat_green(screen: np.ndarray) -> int:
    """How many pixels of the 3D view are exactly #00FF00."""
    return int((screen[VIEW] == (0, 255, 0)).all(axis=-1).sum())


def wooden(screen: np.ndarray) -> int:
    """How many pixels of the 3D view have the cabinet's colour, which only the RGB cloud brings there."""
    red, green, blue = (screen[VIEW][..., channel].astype(int) for channel in range(3))
    return int(((red > 90) & (red > 1.3 * green) & (green > 1.2 * blue)).sum())


def wait_for(what: str, path: Path, seen, rviz) -> Optional[np.ndarray]:
    """The screen; none where what launched `rviz` says that it has died."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if "has died" in rviz.output():
            return None
        screen = picture(path)
        if seen(screen):
            return screen
        time.sleep(1.0)
    pytest.fail(f"{what} was not to be seen within {PATIENCE} s: {path}\n{rviz.output()}")


@contextmanager
def rviz_that_shows(what: str, path: Path, seen):
    """It, and the screen. rviz itself ends in free() now and then as it starts, and is started again."""
    for _ in range(STARTS):
        with launch_after_the_world("rviz.launch") as rviz:
            screen = wait_for(what, path, seen, rviz)
            if screen is not None:
                yield rviz, screen
                return
    pytest.fail(f"rviz has died {STARTS} times:\n{rviz.output()}")


def launch(file: str):
    return process(["roslaunch", "safety_control_cloud", file], OF_ROSLAUNCH)


def launch_after_the_world(file: str):
    """Two that start at once quarrel about the run_id, and rviz asks only once whether time is simulated."""
    end = time.monotonic() + PATIENCE
    while not rosgraph.Master("/test_rviz").hasParam("/use_sim_time"):
        assert time.monotonic() < end, "the world did not come up"
        time.sleep(0.1)
    return launch(file)


def test_rviz_shows_the_corridors_points_in_green_while_the_node_speaks_and_none_before(tmp_path, monkeypatch):
    monkeypatch.setenv("LIBGL_ALWAYS_SOFTWARE", "1")
    with virtual_screen(WIDTH, HEIGHT) as display, roscore():
        monkeypatch.setenv("DISPLAY", display)
        with launch("turtlebot_world.launch"), rviz_that_shows(
                "the coloured cloud", tmp_path / "silent.png", lambda screen: wooden(screen) > 500) as (rviz, screen):
            assert flat_green(screen) == 0
            with launch("safety_control.launch"):
                screen = wait_for(
                    "the corridor's points", tmp_path / "speaking.png", lambda screen: flat_green(screen) > 10_000, rviz)
            assert screen is not None, rviz.output()
    print(f"{flat_green(screen)} pixels of #00FF00")
    PICTURE.parent.mkdir(exist_ok=True)
    shutil.copy(tmp_path / "speaking.png", PICTURE)
