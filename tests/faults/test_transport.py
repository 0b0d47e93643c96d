# SPDX-License-Identifier: BSD-3-Clause
"""Cameras that fall silent, die, or are two; clouds that come too fast or too big; a listener that never reads."""
import os
import signal
import sys
from contextlib import contextmanager
from pathlib import Path

import camera
import numpy as np
import pytest
from camera import Camera
from robot import AGAIN, NODE, ONE_CLOUD, SOURCE_TIMEOUT, START, after, eventually, is_sending
from scenes import FRAME, always, cloud_of, hall, wall

from safety_control_cloud.processes import process

CAMERA = Path(camera.__file__)


@contextmanager
def another_camera(distance):
    with process([sys.executable, str(CAMERA), str(distance)]) as running:
        yield running


def test_a_camera_that_falls_silent_stops_the_robot(robot):
    robot.camera.pause()
    robot.stops("SILENT", within=SOURCE_TIMEOUT)
    robot.camera.show(hall())
    robot.drives()


def test_a_camera_that_dies_stops_the_robot_until_it_is_started_anew(robot):
    robot.camera.pause()
    robot.stops("SILENT", within=SOURCE_TIMEOUT)
    for _ in range(2):
        with another_camera(3.0) as camera:
            robot.camera.changes()
            robot.drives(within=START)
            camera.send(signal.SIGKILL)
            robot.camera.changes()
            robot.stops("SILENT", within=SOURCE_TIMEOUT)


def test_two_cameras_on_one_topic_stop_the_robot_whatever_they_see(robot):
    for distance in (0.45, 3.0):
        with another_camera(distance) as camera:
            robot.camera.changes()
            robot.stops("TWO_SOURCES", within=START)
            camera.send(signal.SIGKILL)
            camera.wait(5.0)
            robot.camera.changes()
            robot.drives()


@pytest.mark.parametrize("frame, distance", [("another_optical_frame", None), (FRAME, 3.0)], ids=["frames", "contents"])
def test_two_drivers_in_one_process_are_two_cameras(robot, frame, distance):
    boards = [wall(distance)] if distance else []
    robot.camera.show(hall())
    other = Camera(hall(*boards, frame=frame))
    robot.camera.changes()
    robot.stops("TWO_SOURCES", within=AGAIN)
    other.end()
    robot.camera.changes()
    robot.drives()


def test_a_silent_camera_is_noticed_to_within_a_tenth_of_a_second(robot):
    late = []
    for _ in range(3):
        robot.camera.pause()
        robot.stops("SILENT", within=SOURCE_TIMEOUT)
        silent, last = next(said for said in after(robot.camera.changed_at, robot.states) if said[1].cause_text == "SILENT")
        seen = min(arrival for arrival, state in robot.states.timed() if state.header.stamp == last.header.stamp)
        late.append(silent - seen - 0.5)
        robot.camera.show(hall())
        robot.drives()
    assert min(map(abs, late)) < 0.1, late


def test_two_hundred_clouds_a_second_delay_no_stop(robot):
    robot.camera.rate = 200.0
    robot.camera.show(hall())
    robot.drives()
    robot.camera.show(hall(wall(0.45)))
    robot.stops("SEEN")
    robot.camera.show(hall())
    robot.drives()


@pytest.mark.with_parameters(stamp_tolerance=20, source_timeout=5)  # how long this machine takes to send it is not the question
def test_a_cloud_of_4096_x_3072_points_is_looked_at(robot):
    height, width = 3072, 4096
    points = np.zeros((height, width, 3), np.float32)
    points[..., 2] = 0.45

    robot.camera.show(always(cloud_of(points)))
    robot.camera.pause()

    state = robot.states.until(lambda state: state.total == width * height)
    assert (state.cause_text, state.speed, state.inside) == ("SEEN", 0.0, width * height)
    robot.keeps(0.0)
    robot.camera.show(hall(wall(3.0)))  # in a hall the clouds' new size would leave pixels that see past nothing
    robot.drives()


def test_a_listener_of_output_that_never_reads_changes_nothing(robot):
    robot.camera.rate = 50.0
    with process(["rostopic", "echo", "--noarr", "/output"]) as listener:
        eventually(lambda: is_sending(NODE, "/output"))
        listener.send(signal.SIGSTOP)
        robot.camera.show(hall(wall(1.5)))
        robot.drives()
        before = robot.memory()
        robot.camera.show(hall(wall(0.45)))
        robot.stops("SEEN", within=ONE_CLOUD)
        robot.camera.show(hall(wall(1.5)))
        robot.drives()
        robot.keeps(0.2, seconds=3.0)
        if "SAFETY_CONTROL_NODE" not in os.environ:  # a sanitizer keeps freed memory for a while
            assert robot.memory() - before < 8_000_000, "it keeps what nobody reads"
        listener.send(signal.SIGCONT)
    robot.keeps(0.2)
