# SPDX-License-Identifier: BSD-3-Clause
"""A TurtleBot with an Xtion in a world, without ROS: stepped by its caller, the same for the same seed.

Read `turtlebot.py` first. `base` and `mux` need nothing but Python, `sensor` numpy, `world` and `camera` MuJoCo.
For Gazebo, without MuJoCo: `furniture` reads a world, `sdf` writes it, `hull` knows what the robot touches in it.
"""
