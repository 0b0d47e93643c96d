# SPDX-License-Identifier: BSD-3-Clause
"""A guarded robot whose camera sends depth images: each fault ends at zero, and recovers."""
import numpy as np
import pytest
import rospy
from depth_camera import DepthCamera
from guarded import CAMERA_TO_FRONT, guarded_robot, odometry_at_rest, twist
from scenes import cloud_of, hall, points_of, post, wall

AHEAD = twist(0.3)


@pytest.fixture(scope="module")
def robot(master):
    with guarded_robot(input="depth", frozen_clouds=10, camera=DepthCamera) as robot:
        yield robot


@pytest.fixture(autouse=True)
def sound_camera(robot):
    """Each test begins and ends with a robot that drives in a free hall."""
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    yield
    robot.camera.damage = lambda image, info: None
    robot.camera.has_info = True
    robot.camera.clock = rospy.Time.now
    robot.camera.show(hall())
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)


def everywhere(metres):
    def alter(image, info):
        image.data = np.full(image.height * image.width, metres, np.float32).tobytes()

    return alter


def claims(**said):
    def alter(image, info):
        for name, value in said.items():
            setattr(info if name in ("K", "P", "D", "binning_x") else image, name, value)

    return alter


def same_bits(image, info):
    image.data = np.where(np.isnan(points_of()[..., 2]), np.nan, points_of()[..., 2]).astype(np.float32).tobytes()


def of_another_frame(frame):
    def alter(image, info):
        image.header.frame_id = info.header.frame_id = frame

    return alter


def cut(image, info):
    image.data = image.data[:-100]


FAULTS = {
    "blind": (everywhere(np.nan), "BLIND"),
    "all_infinite": (everywhere(np.inf), "BLIND"),
    "all_zero": (everywhere(0.0), "BLIND"),
    "too_close_everywhere": (everywhere(-np.inf), "BLIND"),
    "truncated": (cut, "UNREADABLE"),
    "no_rows": (claims(height=0, data=b""), "UNREADABLE"),
    "a_colour_image": (claims(encoding="rgb8"), "UNREADABLE"),
    "a_step_that_is_too_short": (claims(step=3), "UNREADABLE"),
    "no_camera_matrix": (claims(P=[0.0] * 12, K=[0.0] * 9), "UNREADABLE"),
    "another_camera's_size": (claims(binning_x=4), "UNREADABLE"),
    "frozen": (same_bits, "FROZEN"),
    "a_frame_that_nobody_knows": (of_another_frame("elsewhere"), "NO_TRANSFORM"),
    "a_frame_that_looks_elsewhere": (of_another_frame("base_footprint"), "WRONG_VIEW"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_ends_at_zero_and_recovers(robot, fault):
    robot.camera.damage, cause = FAULTS[fault]
    assert robot.stands(cause).stuck


@pytest.mark.parametrize("off, cause", [(-5.0, "STALE"), (60.0, "FUTURE")])
def test_a_stamp_that_cannot_be_ends_at_zero_and_recovers(robot, off, cause):
    robot.camera.clock = lambda: rospy.Time.now() + rospy.Duration(off)
    robot.stands(cause)


def test_images_without_their_camera_info_end_at_zero_and_recover(robot):
    robot.camera.has_info = False
    robot.stands("SILENT")


def test_a_silent_camera_ends_at_zero_and_recovers(robot):
    robot.camera.pause()
    robot.stands("SILENT", within=1.0)


def test_a_near_hole_ends_at_zero_and_recovers(robot):
    robot.camera.show(hall(post(0.6)))
    robot.gives(lambda state: state.inside > 0)
    hole = points_of(post(0.6))
    hole[points_of(post(0.6))[..., 2] == np.float32(0.6)] = np.nan
    robot.camera.show([cloud_of(hole * (1 + 1e-4 * i)) for i in range(3)])
    assert robot.stands("NEAR_LOSS").stuck


def test_before_a_wall_it_is_slowed_as_by_a_cloud(robot):
    robot.camera.show(hall(wall(0.4 + CAMERA_TO_FRONT)))
    robot.driver.say(twist(0.5, 0.2))
    with odometry_at_rest():
        state = robot.slows()
    assert (state.cause_text, state.sensor) == ("SEEN", "depth")
    assert state.nearest_point.x == pytest.approx(0.4 + 0.178, abs=0.05)
