#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A depth image leads to what the cloud that depth_image_proc makes of it leads to; a bad one to standing still."""
import tempfile
import unittest
from pathlib import Path

import numpy as np
import rosbag
import rospy
import rostest
from damaged import cut_short, damaged
from depth_images import binned_region, camera_of, depths, image_of, with_claims
from listening import Heard, eventually, is_sending
from sensor_msgs.msg import CameraInfo, Image, PointCloud2
from std_srvs.srv import Trigger

from safety_control_cloud.msg import SafetyState
from safety_control_cloud.processes import process

IMAGE, RAW, CAMERA = (f"/camera/depth/{name}" for name in ("image_rect", "image_raw", "camera_info"))
FIRST = 1_600_000_000_000_000_000  # [ns]
PERIOD = 50_000_000  # [ns]
DISTORTED = [0.1, -0.2, 0.0, 0.0, 0.05]


class Ears:
    def __init__(self, node):
        self.node = node
        self.states, self.output = Heard(f"/{node}/state", SafetyState), Heard(f"/{node}/output", PointCloud2)

    def state_at(self, stamp):
        return self.states.until(lambda state: state.header.stamp == stamp)

    def output_at(self, stamp):
        return self.output.until(lambda cloud: cloud.header.stamp == stamp)


def without_seq(message):
    message.header.seq = 0
    return message


def without_moments(state):
    """Two nodes lose a thing at two moments."""
    state.stuck_since = bool(state.stuck_since.to_nsec())
    return without_seq(state)


class Depth(unittest.TestCase):
    maxDiff = None
    sent = 0

    @classmethod
    def setUpClass(cls):
        cls.by_depth, cls.by_cloud, cls.by_raw_depth = (Ears(name) for name in ("by_depth", "by_cloud", "by_raw_depth"))
        cls.images, cls.raws = (rospy.Publisher(topic, Image, queue_size=5, tcp_nodelay=True) for topic in (IMAGE, RAW))
        cls.cameras = rospy.Publisher(CAMERA, CameraInfo, queue_size=5, tcp_nodelay=True)
        eventually(lambda: cls.images.get_num_connections() == 2 and cls.raws.get_num_connections() == 1)
        eventually(lambda: cls.cameras.get_num_connections() == 3)
        eventually(lambda: all(is_sending(f"/{node}", f"/{node}/output") for node in ("by_depth", "by_cloud")))
        eventually(lambda: is_sending("/to_cloud", "/camera/depth/points"))

    def setUp(self):
        """Both nodes know the same of what was near: a cloud that comes too fast after another is dropped."""
        for node in ("by_depth", "by_cloud"):
            eventually(lambda: rospy.ServiceProxy(f"/{node}/reset", Trigger)().success)

    def stamp(self):
        Depth.sent += 1
        return rospy.Time(nsecs=FIRST + self.sent * PERIOD)

    def send(self, image, camera=None):
        """Its stamp."""
        camera = camera or camera_of(image)
        image.header.stamp = camera.header.stamp = self.stamp()
        self.cameras.publish(camera)
        self.images.publish(image)
        self.raws.publish(image)
        return image.header.stamp

    def assert_same(self, image, camera=None):
        """The state that image and cloud lead to."""
        stamp = self.send(image, camera)
        seen, expected = (without_moments(ears.state_at(stamp)) for ears in (self.by_depth, self.by_cloud))
        self.assertEqual(repr(seen), repr(expected))  # NaN, too, in the same places
        crop, expected_crop = (without_seq(ears.output_at(stamp)) for ears in (self.by_depth, self.by_cloud))
        self.assertEqual(crop, expected_crop)
        return seen

    def test_an_image_leads_to_what_its_cloud_leads_to(self):
        causes = set()
        for seed in range(40):
            image = image_of(depths(seed, 120, 160), encoding=["32FC1", "16UC1"][seed // 2 % 2], padding=[0, 4, 64][seed % 3])
            causes.add(self.assert_same(image).cause_text)
        self.assertEqual(causes, {"SEEN", "NEAR_LOSS"})

    def test_so_does_one_of_vga_and_a_blank_one_and_one_of_no_pixels(self):
        self.assertGreater(self.assert_same(image_of(depths(100, 480, 640))).inside, 10_000)
        self.assertEqual(self.assert_same(image_of(np.full((24, 32), np.nan, np.float32))).cause_text, "BLIND")
        self.assertEqual(self.assert_same(Image(encoding="32FC1")).cause_text, "BLIND")

    def test_so_does_a_region_of_every_second_pixel(self):
        for seed in range(5):
            image = image_of(depths(seed, 60, 80), encoding="16UC1")
            self.assertGreater(self.assert_same(image, binned_region(image)).inside, 0)

    def test_a_rectified_image_of_a_distorted_camera_is_read_and_a_raw_one_is_not(self):
        image = image_of(depths(7, 60, 80))
        self.assertNotEqual(self.assert_same(image, camera_of(image, D=DISTORTED)).cause_text, "UNREADABLE")
        state = self.by_raw_depth.state_at(image.header.stamp)
        self.assertEqual((state.cause_text, state.speed), ("UNREADABLE", 0.0))
        self.assertIn("rectify it with image_proc", state.reason)
        self.send(image)
        self.assertNotEqual(self.by_raw_depth.state_at(image.header.stamp).cause_text, "UNREADABLE")

    def test_what_contradicts_itself_is_unreadable(self):
        metres = depths(8, 24, 32)
        whole = image_of(metres)
        contradictions = {
            "encoding rgb8": (image_of(metres, encoding="rgb8"), None),
            "encoding mono16": (image_of(metres, encoding="mono16"), None),
            "data has 3071 bytes": (image_of(metres, data=whole.data[:-1]), None),
            "data has 0 bytes": (image_of(metres, data=b""), None),
            "step 124": (image_of(metres, step=124), None),
            "its CameraInfo speaks of 64 x 24": (whole, camera_of(whole, width=64)),
            "K of the CameraInfo": (whole, camera_of(whole, K=[0] * 9)),
            "P of the CameraInfo": (whole, camera_of(whole, P=[0] * 12)),
        }
        for reason, (image, camera) in contradictions.items():
            state = self.by_depth.state_at(self.send(image, camera))
            self.assertEqual((state.cause_text, state.speed, state.zone_text), ("UNREADABLE", 0.0, "Danger"), reason)
            self.assertIn(reason, state.reason)
            self.assertNotEqual(self.by_depth.state_at(self.send(whole)).cause_text, "UNREADABLE")

    def test_a_message_that_cannot_be_deserialised_is_unreadable_without_its_camera_info(self):
        whole = image_of(depths(11, 24, 32))
        cut = damaged(whole, cut_short)
        cut.header.stamp = self.stamp()
        self.raws.publish(cut)
        state = self.by_raw_depth.state_at(cut.header.stamp)
        self.assertEqual((state.cause_text, state.speed), ("UNREADABLE", 0.0))
        self.assertEqual(state.reason, "the message ends before its contents")
        self.assertNotEqual(self.by_raw_depth.state_at(self.send(whole)).cause_text, "UNREADABLE")

    def test_images_without_their_camera_info_are_silence(self):
        image = image_of(depths(9, 24, 32))
        self.send(image)
        heard = len(self.by_depth.states.all())
        for _ in range(20):
            image.header.stamp = self.stamp()
            self.images.publish(image)
            rospy.sleep(0.05)
        state = self.by_depth.states.until(lambda state: state.cause_text == "SILENT", after=heard)
        self.assertEqual(state.speed, 0.0)
        self.assertLess(state.header.stamp, image.header.stamp)

    def test_images_of_two_cameras_in_turn_stop_the_robot(self):
        image = image_of(depths(10, 24, 32))
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "other_camera.bag")
            with rosbag.Bag(path, "w") as bag:
                for _ in range(60):
                    image.header.stamp = self.stamp()
                    bag.write(IMAGE, image, image.header.stamp)
                    bag.write(CAMERA, with_claims(camera_of(image), {"header": image.header}), image.header.stamp)
            with process(["rosbag", "play", "--quiet", path]) as player:
                while player.exit_code is None:
                    self.send(image)
                    rospy.sleep(0.05)
        doubted = [state for state in self.by_depth.states.all() if state.cause_text == "TWO_SOURCES"]
        self.assertEqual({state.speed for state in doubted}, {0.0})


if __name__ == "__main__":
    rospy.init_node("depth")
    rostest.rosrun("safety_control_cloud", "depth", Depth)
