# SPDX-License-Identifier: BSD-3-Clause
"""The simulator's messages are those of the real robot's drivers."""
from math import pi

import numpy as np
import pytest

pytest.importorskip("rospy")

from sensor_msgs import point_cloud2  # noqa: E402

from safety_control_cloud.nodes import messages  # noqa: E402
from safety_control_cloud.simulation.base import Pose, Velocity  # noqa: E402
from safety_control_cloud.simulation.sensor import Xtion, points  # noqa: E402

SMALL = Xtion(width=64, height=48)
STAMP = messages.time_of(12.35)


def test_stamps_are_exact_to_the_nanosecond():
    assert (messages.time_of(0.29).secs, messages.time_of(0.29).nsecs) == (0, 290_000_000)
    assert (STAMP.secs, STAMP.nsecs) == (12, 350_000_000)


def test_others_read_the_cloud_as_it_was_meant():
    depth = np.random.default_rng(0).uniform(0.5, 4, (48, 64)).astype(np.float32)
    depth[3, 5] = np.nan
    colour = np.zeros((48, 64, 3), np.uint8)
    colour[..., 1] = 255
    cloud = messages.CloudMessage(SMALL).of(depth, colour, STAMP)
    read = np.array(list(point_cloud2.read_points(cloud, ("x", "y", "z")))).reshape(48, 64, 3)
    assert np.allclose(read, points(depth, SMALL), equal_nan=True, atol=1e-6)
    rgb = np.array(list(point_cloud2.read_points(cloud, ("rgb",))), np.float32).view(np.uint32)
    assert (rgb == 0x00FF00).all()


def test_the_cloud_is_organised_32_bytes_a_point_and_not_dense():
    cloud = messages.CloudMessage(Xtion()).of(np.ones((480, 640), np.float32), np.zeros((480, 640, 3), np.uint8), STAMP)
    assert (cloud.height, cloud.width, cloud.point_step, cloud.row_step) == (480, 640, 32, 20480)
    assert [(field.name, field.offset, field.datatype) for field in cloud.fields] == [
        ("x", 0, 7), ("y", 4, 7), ("z", 8, 7), ("rgb", 16, 7)]
    assert not cloud.is_dense and not cloud.is_bigendian
    assert cloud.header.frame_id == "camera_depth_optical_frame"
    assert len(cloud.data) == 9_830_400


@pytest.mark.parametrize("encoding, kind, far", [("32FC1", np.float32, np.nan), ("16UC1", np.uint16, 0)])
def test_the_depth_image_comes_in_both_of_the_drivers_encodings(encoding, kind, far):
    depth = np.full((48, 64), 1.5, np.float32)
    depth[0, 0] = np.nan
    image = messages.to_depth_image(depth, encoding, STAMP)
    read = np.frombuffer(image.data, kind).reshape(image.height, image.width)
    assert image.encoding == encoding and image.step == 64 * np.dtype(kind).itemsize
    assert read[1, 1] == (1.5 if kind is np.float32 else 1500)
    assert np.array_equal(read[0, 0], far, equal_nan=True)


def test_the_camera_info_holds_the_xtions_lens():
    info = messages.to_camera_info(Xtion(), STAMP)
    assert info.K[0] == info.K[4] == pytest.approx(554.26, abs=0.005)
    assert (info.K[2], info.K[5]) == (319.5, 239.5)


def test_odometry_and_transform_tell_the_same_pose():
    pose = Pose(1.0, -2.0, pi / 2)
    odometry = messages.to_odometry(pose, Velocity(0.2, 0.1), STAMP)
    transform = messages.to_transform(pose, STAMP)
    assert odometry.pose.pose.orientation == transform.transform.rotation
    assert (transform.transform.translation.x, transform.transform.translation.y) == (1.0, -2.0)
    assert (odometry.twist.twist.linear.x, odometry.twist.twist.angular.z) == (0.2, 0.1)
    assert (transform.header.frame_id, transform.child_frame_id) == ("odom", "base_footprint")
