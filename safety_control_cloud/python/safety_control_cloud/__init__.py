# SPDX-License-Identifier: BSD-3-Clause
"""safety_control_cloud in Python: `core` is the C++ decision, `simulation` a TurtleBot without ROS, `nodes` the rospy side."""
