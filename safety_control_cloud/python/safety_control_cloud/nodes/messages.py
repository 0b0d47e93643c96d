# SPDX-License-Identifier: BSD-3-Clause
"""What the simulated TurtleBot says, as ROS messages. Stamps are genpy Times; frames as on the real robot."""
from __future__ import annotations

from math import cos, sin
from typing import TYPE_CHECKING

import numpy as np
from genpy import Time
from geometry_msgs.msg import Point
from geometry_msgs.msg import Pose as RosPose
from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Twist, Vector3
from nav_msgs.msg import Odometry
from sensor_msgs.msg import CameraInfo, Image, JointState, PointCloud2, PointField
from std_msgs.msg import Header

from ..headings import heading_of
from ..simulation.base import WHEEL_RADIUS, Pose, Velocity
from ..simulation.sensor import POINT, Xtion, fill_cloud, fill_colour, millimetres

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

WORLD_FRAME = "odom"
BASE_FRAME = "base_footprint"
OPTICAL_FRAME = "camera_depth_optical_frame"  # of colour too: the driver registers it to the depth
WHEEL_JOINTS = ("wheel_left_joint", "wheel_right_joint")


def time_of(seconds: float) -> Time:
    return Time(0, round(seconds * 1e9))


def to_velocity(twist: Twist) -> Velocity:
    return Velocity(twist.linear.x, twist.angular.z)


def to_twist(velocity: Velocity) -> Twist:
    return Twist(Vector3(velocity.linear, 0, 0), Vector3(0, 0, velocity.angular))


def to_quaternion(yaw: float) -> Quaternion:
    return Quaternion(0, 0, sin(yaw / 2), cos(yaw / 2))


def to_pose(pose: RosPose) -> Pose:
    """As seen from above."""
    return Pose(pose.position.x, pose.position.y, heading_of(pose.orientation))


def to_ros_pose(pose: Pose, z: float = 0.0) -> RosPose:
    return RosPose(Point(pose.x, pose.y, z), to_quaternion(pose.yaw))


def to_transform(pose: Pose, stamp: Time) -> TransformStamped:
    """odom -> base_footprint: the truth, as if the wheels never slipped."""
    transform = Transform(Vector3(pose.x, pose.y, 0), to_quaternion(pose.yaw))
    return TransformStamped(Header(0, stamp, WORLD_FRAME), BASE_FRAME, transform)


def to_odometry(pose: Pose, velocity: Velocity, stamp: Time) -> Odometry:
    odometry = Odometry(header=Header(0, stamp, WORLD_FRAME), child_frame_id=BASE_FRAME)
    odometry.pose.pose.position.x, odometry.pose.pose.position.y = pose.x, pose.y
    odometry.pose.pose.orientation = to_quaternion(pose.yaw)
    odometry.twist.twist.linear.x = velocity.linear
    odometry.twist.twist.angular.z = velocity.angular
    return odometry


def to_joint_state(rolled: tuple[float, float], stamp: Time) -> JointState:
    """`rolled` [m]: how far the left and the right wheel have."""
    return JointState(Header(0, stamp, ""), list(WHEEL_JOINTS), [way / WHEEL_RADIUS for way in rolled], [], [])


def to_camera_info(xtion: Xtion, stamp: Time) -> CameraInfo:
    focal, (column, row) = xtion.focal, xtion.centre
    return CameraInfo(
        header=Header(0, stamp, OPTICAL_FRAME),
        height=xtion.height, width=xtion.width, distortion_model="plumb_bob", D=[0.0] * 5,
        K=[focal, 0, column, 0, focal, row, 0, 0, 1],
        R=[1, 0, 0, 0, 1, 0, 0, 0, 1],
        P=[focal, 0, column, 0, 0, focal, row, 0, 0, 0, 1, 0],
    )


def to_image(picture: NDArray, encoding: str, stamp: Time) -> Image:
    height, width = picture.shape[:2]
    step = picture.strides[0]
    return Image(Header(0, stamp, OPTICAL_FRAME), height, width, encoding, 0, step, picture.tobytes())


def to_depth_image(depth: NDArray[np.float32], encoding: str, stamp: Time) -> Image:
    """32FC1 in metres with NaN, or 16UC1 in millimetres with 0, where nothing returned."""
    return to_image(millimetres(depth) if encoding == "16UC1" else depth, encoding, stamp)


class CloudMessage:
    """One PointCloud2 filled again and again: at 10 MB a cloud, asking for memory costs more than the sums.

    Publish it before the next `of`; rospy serializes within `publish`.
    """

    def __init__(self, xtion: Xtion) -> None:
        self._xtion = xtion
        size = xtion.width * xtion.height * POINT.itemsize
        data = bytearray(size)
        self._cloud = np.frombuffer(data, dtype=POINT).reshape(xtion.height, xtion.width)
        fields = [PointField(name, POINT.fields[name][1], PointField.FLOAT32, 1) for name in POINT.names]
        self._message = PointCloud2(
            height=xtion.height, width=xtion.width, fields=fields, is_bigendian=False,
            point_step=POINT.itemsize, row_step=xtion.width * POINT.itemsize, data=data, is_dense=False,
        )

    def of(self, depth: NDArray[np.float32], colour: NDArray[np.uint8], stamp: Time) -> PointCloud2:
        fill_cloud(self._cloud, depth, self._xtion)
        fill_colour(self._cloud, colour)
        self._message.header = Header(0, stamp, OPTICAL_FRAME)
        return self._message
