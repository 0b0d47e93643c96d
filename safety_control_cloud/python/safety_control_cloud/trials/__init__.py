# SPDX-License-Identifier: BSD-3-Clause
"""Randomised closed-loop drives without ROS: does the robot run into things, and the tutorial's beside it?

Read `episode.py` first. `families/` draws the scenarios, `run.py` drives many of them.
"""
