#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The whole stack of tests/stack.test: simulator, multiplexer, frames and the node, before the cabinet."""
import sys
import unittest

import numpy as np
import rospy
import rostest
from geometry_msgs.msg import PointStamped
from sensor_msgs.msg import CameraInfo, Image, PointCloud2
from tf2_msgs.msg import TFMessage

from observer import CAMERA_X, FRONT, Observer

GAZEBO_START, GAZEBO_STOP = 1.887, (0.46, 0.50)  # [m] camera to front, of the reference run in Gazebo 11


class Stack(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.seen = Observer()

    def setUp(self):
        self.seen.until("the node sees", lambda: self.seen.states and self.seen.states[-1].cause_text == "SEEN")
        self.seen.reset()
        self.seen.states.clear()

    def test_from_gazebos_start_the_robot_stands_where_it_did_in_gazebo(self):
        self.seen.place(FRONT - GAZEBO_START - CAMERA_X)
        self.seen.until("it is there", lambda: abs(self.seen.camera_to_front - GAZEBO_START) < 0.05)
        self.seen.states.clear()
        self.seen.until("Danger", lambda: self.seen.zones[-1:] == ["Danger"])
        self.seen.until_it_stands()
        rospy.sleep(1.0)
        self.assertEqual(self.seen.zones, ["Safe", "Warning", "Danger"])
        self.assertEqual(self.seen.touched, "")
        print(f"stands with the camera {self.seen.camera_to_front:.3f} m from the front")
        self.assertGreaterEqual(self.seen.camera_to_front, GAZEBO_STOP[0])
        self.assertLessEqual(self.seen.camera_to_front, GAZEBO_STOP[1])

    def test_the_node_drives_as_the_muxs_teleoperation(self):
        self.seen.until_it_drives()
        self.assertEqual(self.seen.holder, "Teleoperation")

    def test_a_box_dropped_with_publish_point_stops_the_robot_and_reset_takes_it_away(self):
        click = rospy.Publisher("/clicked_point", PointStamped, queue_size=1)
        self.seen.until("the simulator listens", lambda: click.get_num_connections() > 0)
        point = PointStamped()
        point.header.frame_id, point.point.x, point.point.y = "odom", 0.75, 0.0
        click.publish(point)
        self.seen.until("Danger", lambda: self.seen.zones[-1:] == ["Danger"])
        self.seen.until_it_stands()
        self.assertLess(self.seen.x, 0.75 - 0.15 - 0.178)
        self.seen.reset()
        self.seen.until_it_drives()

    def test_a_pose_in_another_frame_than_odom_moves_nothing(self):
        self.seen.place(-3.0, frame="camera_depth_optical_frame")
        rospy.sleep(0.5)
        self.assertGreater(self.seen.x, -0.5)

    def test_the_camera_says_what_the_real_one_says(self):
        cloud = rospy.wait_for_message("/camera/depth/points", PointCloud2, timeout=10)
        self.assertEqual((cloud.width, cloud.height, cloud.point_step), (640, 480, 32))
        self.assertEqual(cloud.header.frame_id, "camera_depth_optical_frame")
        depth = rospy.wait_for_message("/camera/depth/image_raw", Image, timeout=10)
        self.assertEqual(depth.encoding, "32FC1")
        self.assertTrue(np.isfinite(np.frombuffer(depth.data, np.float32)).mean() > 0.5)
        self.assertEqual(rospy.wait_for_message("/camera/rgb/image_raw", Image, timeout=10).encoding, "rgb8")
        info = rospy.wait_for_message("/camera/depth/camera_info", CameraInfo, timeout=10)
        self.assertAlmostEqual(info.K[0], 554.256, 2)

    def test_the_clouds_come_20_times_a_simulated_second(self):
        stamps = []
        listener = rospy.Subscriber(
            "/camera/depth/camera_info", CameraInfo, lambda info: stamps.append(info.header.stamp.to_sec()))
        self.seen.until("twenty pictures", lambda: len(stamps) > 20)
        listener.unregister()
        self.assertTrue(np.allclose(np.diff(stamps), 0.05))

    def test_the_frames_lead_from_the_base_to_the_camera(self):
        static = rospy.wait_for_message("/tf_static", TFMessage, timeout=10)
        links = {transform.child_frame_id: transform.header.frame_id for transform in static.transforms}
        frame, way = "camera_depth_optical_frame", []
        while frame in links:
            frame = links[frame]
            way.append(frame)
        self.assertEqual(way, ["camera_depth_frame", "base_link", "base_footprint"])


if __name__ == "__main__":
    rostest.rosrun("safety_control_cloud", "stack", Stack, sys.argv)
