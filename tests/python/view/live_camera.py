# SPDX-License-Identifier: BSD-3-Clause
"""A camera that looks at a wall which comes nearer: organised clouds, ten a second. With "guard", a driver too."""
import sys

import numpy as np
import rospy
from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Twist, Vector3
from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

WIDTH, HEIGHT, FOCAL = 160, 120, 140.0


def main() -> None:
    rospy.init_node("camera")
    topic = rospy.Publisher("camera/depth/points", PointCloud2, queue_size=1)
    fields = [PointField(name, 4 * place, PointField.FLOAT32, 1) for place, name in enumerate("xyz")]
    v, u = np.indices((HEIGHT, WIDTH), np.float32)
    number = 0
    transforms = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
    transforms.publish(TFMessage([TransformStamped(Header(0, rospy.Time.now(), "base_footprint"), "camera", Transform(
        Vector3(-0.087, 0.0, 0.2972), Quaternion(-0.5, 0.5, -0.5, 0.5)))]))
    wish = rospy.Publisher("cmd_vel_in", Twist, queue_size=1) if "guard" in sys.argv else None
    curve = Twist(Vector3(0.3, 0.0, 0.0), Vector3(0.0, 0.0, 0.4))
    while not rospy.is_shutdown():
        z = np.full((HEIGHT, WIDTH), max(2.0 - 0.03 * number, 0.45), np.float32)
        points = np.stack([(u - 79.5) / FOCAL * z, (v - 59.5) / FOCAL * z, z], -1)
        cloud = PointCloud2(height=HEIGHT, width=WIDTH, fields=fields, point_step=12, row_step=12 * WIDTH, data=points.tobytes())
        cloud.header.stamp, cloud.header.frame_id = rospy.Time.now(), "camera"
        topic.publish(cloud)
        if wish:
            wish.publish(curve)
        number += 1
        rospy.sleep(0.1)


if __name__ == "__main__":
    try:
        main()
    except rospy.ROSInterruptException:
        pass
