#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""/output is exactly what the decision was made of."""
import unittest

import numpy as np
import rospy
import rostest
from listening import Heard, by_stamp, eventually, is_sending, play
from recordings import FRAME, MadeCloud, inside, wall_at
from sensor_msgs.msg import PointCloud2

from safety_control_cloud.msg import SafetyState

STEP = 300_000_000  # [ns]
ODD = 1_600_000_000_123_456_789  # [ns] a stamp that neither a double nor a microsecond can hold


def points_of(cloud):
    assert [(field.name, field.datatype) for field in cloud.fields[:3]] == [("x", 7), ("y", 7), ("z", 7)]
    parts = {"names": list("xyz"), "formats": ["<f4"] * 3, "offsets": [field.offset for field in cloud.fields[:3]],
             "itemsize": cloud.point_step}
    table = np.frombuffer(cloud.data, np.dtype(parts))
    return np.stack([table[axis] for axis in "xyz"], axis=1)


class Output(unittest.TestCase):
    def setUp(self):
        self.states = Heard("/safety_control_cloud/state", SafetyState)

    def tearDown(self):
        self.states.close()

    def heard_through(self, clouds):
        """What /output said to these clouds."""
        output = Heard("/output", PointCloud2)
        eventually(lambda: is_sending("/safety_control_cloud", "/output"))
        play(clouds)
        self.states.until(lambda state: state.header.stamp.to_nsec() == clouds[-1].stamp)
        readable = [cloud for cloud in clouds if not cloud.changes]
        output.until(lambda cloud: cloud.header.stamp.to_nsec() == readable[-1].stamp)
        output.close()
        eventually(lambda: not is_sending("/safety_control_cloud", "/output"))
        return by_stamp(output.all())

    def test_the_crop_has_the_clouds_stamp_and_frame_and_the_corridors_points_in_order(self):
        random = np.random.default_rng(1)
        clouds = [MadeCloud(random.uniform((-1, -1, -1), (1, 1, 3), (2000, 3)).astype(np.float32), ODD + n * STEP)
                  for n in range(3)]

        heard = self.heard_through(clouds)

        self.assertEqual(sorted(heard), [cloud.stamp for cloud in clouds])
        for cloud in clouds:
            crop = inside(cloud.points)
            crop = crop[crop[:, 2] > 0.0]
            self.assertGreater(len(crop), 50)
            self.assertEqual(heard[cloud.stamp].header.frame_id, FRAME)
            np.testing.assert_array_equal(points_of(heard[cloud.stamp]), crop)

    def test_a_free_corridor_is_an_empty_cloud_and_an_unreadable_cloud_is_none(self):
        free = MadeCloud(np.float32([[5.0, 0.0, 1.0]]), 100 * STEP)
        unreadable, wall = wall_at(1.0, 101 * STEP, point_step=3), wall_at(1.0, 102 * STEP)

        heard = self.heard_through([free, unreadable, wall])

        self.assertEqual(sorted(heard), [free.stamp, wall.stamp])
        self.assertEqual((heard[free.stamp].width * heard[free.stamp].height, len(heard[free.stamp].data)), (0, 0))
        np.testing.assert_array_equal(points_of(heard[wall.stamp]), inside(wall.points))

    def test_nothing_of_the_time_before_somebody_subscribed_is_published(self):
        before, after = wall_at(1.0, 200 * STEP), wall_at(1.0, 201 * STEP)
        play([before])
        self.states.until(lambda state: state.header.stamp.to_nsec() == before.stamp)

        self.assertEqual(list(self.heard_through([after])), [after.stamp])


if __name__ == "__main__":
    rospy.init_node("output")
    rostest.rosrun("safety_control_cloud", "output", Output)
