# SPDX-License-Identifier: BSD-3-Clause
"""The rospy side: everything here wires topics to `simulation`, which knows no ROS."""
