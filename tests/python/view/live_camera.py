# SPDX-License-Identifier: BSD-3-Clause
"""A camera that looks at a wall which comes nearer: organised clouds, ten a second."""
import numpy as np
import rospy
from sensor_msgs.msg import PointCloud2, PointField

WIDTH, HEIGHT, FOCAL = 160, 120, 140.0


def main() -> None:
    rospy.init_node("camera")
    topic = rospy.Publisher("camera/depth/points", PointCloud2, queue_size=1)
    fields = [PointField(name, 4 * place, PointField.FLOAT32, 1) for place, name in enumerate("xyz")]
    v, u = np.indices((HEIGHT, WIDTH), np.float32)
    number = 0
    while not rospy.is_shutdown():
        z = np.full((HEIGHT, WIDTH), max(2.0 - 0.03 * number, 0.45), np.float32)
        points = np.stack([(u - 79.5) / FOCAL * z, (v - 59.5) / FOCAL * z, z], -1)
        cloud = PointCloud2(height=HEIGHT, width=WIDTH, fields=fields, point_step=12, row_step=12 * WIDTH, data=points.tobytes())
        cloud.header.stamp, cloud.header.frame_id = rospy.Time.now(), "camera"
        topic.publish(cloud)
        number += 1
        rospy.sleep(0.1)


if __name__ == "__main__":
    try:
        main()
    except rospy.ROSInterruptException:
        pass
