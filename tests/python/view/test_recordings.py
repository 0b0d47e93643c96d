# SPDX-License-Identifier: BSD-3-Clause
"""Recordings read back: what replay, trials and the node of view.launch put into them, and what a browser shows."""
from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import urllib.request
from pathlib import Path
from typing import Any, Set

import numpy as np
import pytest
from drives import camera, depth, wall, write_drive
from guard_drives import driven_at_wall
from patience import eventually

pytest.importorskip("rerun", reason="rerun-sdk is not installed (scripts/setup --with view)")

from safety_control_cloud import core
from safety_control_cloud.processes import OF_ROSLAUNCH, process
from safety_control_cloud.ros_session import node, roscore
from safety_control_cloud.view.entities import COLOURS, entities_of
from safety_control_cloud.view.moment import Moment
from safety_control_cloud.view.open import command, free_port, quiet, viewer

WITH_PICTURE = {"/world/camera", "/world/camera/depth"}
ALWAYS = {"/world/corridor", "/world/limits", "/world/nearest", "/world/remembered", "/distance/nearest", "/distance/warning",
          "/distance/danger", "/speed/commanded", "/decision/zone", "/decision/cause", "/log"}
GUARDED = ALWAYS - {"/world/corridor", "/world/limits", "/world/remembered", "/distance/warning", "/distance/danger"} | {
    "/world/footprint", "/world/path", "/world/wanted", "/speed/wanted"}
LAUNCH = Path(__file__).resolve().parents[3] / "safety_control_cloud/launch/view.launch"
CAMERA = [sys.executable, str(Path(__file__).with_name("live_camera.py"))]


def run(*arguments: Any, code: int = 0) -> str:
    result = subprocess.run([str(one) for one in arguments], capture_output=True, text=True, timeout=240)
    assert result.returncode == code, result.stdout + result.stderr
    return result.stdout


def entities(recording: Path) -> Set[str]:
    """With their data, by rerun's own tool, which has verified them."""
    run(viewer(), "rrd", "verify", recording)
    return recorded(recording)


def recorded(recording: Path) -> Set[str]:
    """The same of one that was cut off, which has no end to verify."""
    return set(re.findall(r" - (/\S+) - data columns", run(viewer(), "rrd", "print", recording)))


def texts(recording: Path) -> str:
    return run(viewer(), "rrd", "print", "-vvv", recording)


@pytest.fixture(scope="module")
def driven(tmp_path_factory) -> Path:
    """A wall that comes nearer, in depth images."""
    folder = tmp_path_factory.mktemp("driven")
    records = []
    for number in range(16):
        picture = np.full((120, 160), 2000 - 105 * number, np.uint16)
        picture[:, :30] = 3500
        records += [depth(0.1 * number, picture), camera(0.1 * number, 160, 120, 140.0)]
    bag = write_drive(folder / "drive.bag", records)
    run(sys.executable, "-m", "safety_control_cloud.replay", bag, "--rrd", folder / "drive.rrd")
    return folder / "drive.rrd"


def test_a_replay_of_depth_images_holds_pictures_decisions_and_plots(driven):
    assert entities(driven) >= ALWAYS | WITH_PICTURE and "/world/points" not in entities(driven)
    said = texts(driven)
    assert all(word in said for word in ("Safe", "Warning", "Danger", "nearest obstacle at"))


def test_a_replay_of_several_sensors_holds_each_for_itself_with_its_points_and_the_silence_between(tmp_path):
    often = [wall(0.1 * n + (2.0 if n > 5 else 0.0), 1.2, "/front") for n in range(12)]
    bag = write_drive(tmp_path / "clouds.bag", [*often, *(wall(0.2 * n, 0.4, "/rear/points") for n in range(14))])

    run(sys.executable, "-m", "safety_control_cloud.replay", bag, "--rrd", tmp_path / "clouds.rrd")

    shown = entities(tmp_path / "clouds.rrd")
    for sensor in ("/front", "/rear/points"):
        assert shown >= {sensor + entity for entity in ALWAYS | {"/world/points"}}
    assert not shown & ALWAYS and "SILENT" in texts(tmp_path / "clouds.rrd")


@pytest.mark.parametrize("zone", COLOURS)
def test_the_corridor_and_the_footprint_bear_the_zones_colour_in_full(zone):
    """The viewer makes a corridor's sides transparent by itself: of a colour that is transparent too, nothing is left."""
    moment = Moment(0.0, zone, "SEEN", "", 0.4, (0.0, 0.0, 0.4), 0.0)
    red, green, blue = COLOURS[zone]

    for mode, path in (("drive", "world/corridor"), ("guard", "world/footprint")):
        shown = dict(entities_of(moment, core.Settings(mode=mode)))[path]
        assert shown.colors.as_arrow_array().to_pylist() == [(red << 24) + (green << 16) + (blue << 8) + 255]


def test_a_simulated_drive_is_recorded_with_the_speed_over_the_floor(tmp_path):
    run(sys.executable, "-m", "safety_control_cloud.trials", "--replay", "wall:1", "--method", "ours", "--rrd", tmp_path / "wall.rrd")

    assert entities(tmp_path / "wall.rrd") >= ALWAYS | WITH_PICTURE | {"/speed/driven"}


def test_the_page_shows_the_picture_and_the_plots_in_a_real_browser(driven, tmp_path):
    browser = pytest.importorskip("browser", reason="tornado is not installed (scripts/setup --with cluster)")
    if browser.CHROMIUM is None:
        pytest.skip("no chromium")
    from safety_control_cloud.view.sink import address

    web, data = free_port(), free_port()
    serving = subprocess.Popen(command(driven, {}, web, data), env=quiet(os.environ), stdout=subprocess.DEVNULL)
    try:
        with browser.page(address("127.0.0.1", web, data), tmp_path / "profile") as picture:
            eventually(lambda: what_is_missing(picture()) == [], browser.PATIENCE, 0.5)
    finally:
        serving.kill()
        serving.wait()


def what_is_missing(shown: np.ndarray) -> list:
    """Of what has to be seen, by its colour: the left half holds scene and picture, the right one the plots."""
    left, right = shown[:, :900].astype(int), shown[:, 900:].astype(int)
    colourful = (np.ptp(left, axis=-1) > 60).sum()  # the picture is drawn in the colours of its distances
    lines = {"nearest": (90, 170, 250), "Safe": (46, 158, 91), "Warning": (232, 163, 23), "Danger": (214, 69, 69)}
    missing = [name for name, colour in lines.items() if (np.abs(right - colour).sum(axis=-1) < 90).sum() < 100]
    return missing + ([] if colourful > 20_000 else ["the picture"])


def test_the_launch_file_serves_a_page_and_what_the_running_node_publishes_anyway(tmp_path):
    """As a viewer on another computer gets it: over the data's port."""
    arrived, web, data = tmp_path / "arrived.rrd", free_port(), free_port()
    arguments = ["host:=localhost", f"port:={web}", f"data_port:={data}"]
    with roscore(), node("safety_control_node"), process(CAMERA), \
            process(["roslaunch", str(LAUNCH), *arguments], OF_ROSLAUNCH) as launched:
        page = eventually(lambda: page_at(f"http://localhost:{web}/"), 60.0)
        with process([viewer(), f"rerun+http://localhost:{data}/proxy", "--save", str(arrived)]) as client:
            eventually(lambda: holds_pictures(arrived), 60.0)
            client.send(signal.SIGINT)
            client.wait(10.0)
        assert f"http://localhost:{web}" in launched.output()

    assert "<html" in page.lower()
    assert recorded(arrived) >= ALWAYS | WITH_PICTURE
    assert "SEEN" in texts(arrived)


def test_a_guarded_robot_is_shown_with_its_footprint_and_what_it_sweeps(tmp_path):
    guard = tmp_path / "guard.rrd"
    with roscore(), node("safety_control_node", "_mode:=guard"), process([*CAMERA, "guard"]):
        with node("view_node", "--rrd", str(guard)):
            eventually(lambda: holds_pictures(guard), 60.0)

    shown, said = entities(guard), texts(guard)
    assert shown >= GUARDED | WITH_PICTURE and not shown & {"/world/corridor", "/world/limits", "/speed/safe"}
    assert "SEEN" in said and "Transform3D" in said


def holds_pictures(recording: Path) -> bool:
    return recording.exists() and recording.stat().st_size > 200_000  # [byte]


def page_at(address: str) -> str:
    try:
        return urllib.request.urlopen(address, timeout=10).read().decode()
    except OSError:
        return ""  # not yet


def test_a_replay_of_the_guard_holds_each_sensor_where_it_is_and_what_is_swept(tmp_path):
    bag = write_drive(tmp_path / "guarded.bag", driven_at_wall(seconds=2.5, sensors=("camera", "laser")))

    run(sys.executable, "-m", "safety_control_cloud.replay", bag, "--mode", "guard", "--rrd", tmp_path / "guarded.rrd")

    there = entities(tmp_path / "guarded.rrd")
    for sensor in ("/camera_depth_points", "/scan"):
        assert there >= {sensor + name for name in GUARDED | {"/world/camera", "/speed/driven"}}
    assert "/camera_depth_points/world/camera/depth" in there and "/scan/world/camera/points" in there
    assert "Danger, SEEN: obstacle at x" in texts(tmp_path / "guarded.rrd")
