# SPDX-License-Identifier: BSD-3-Clause
"""Whether Gazebo 11 with gazebo_ros is here, and how it is spoken with."""
from __future__ import annotations

import importlib.util

from .processes import ProcessError
from .ros_session import executable_of

WHEELS_TOPIC = "/turtlebot_sim/wheel_velocity"  # to the differential drive, which obeys at once
MISSING = (
    "Gazebo 11 with gazebo_ros is not installed; with ROS Noetic on Ubuntu 20.04:"
    " sudo apt-get install ros-noetic-gazebo-ros-pkgs (elsewhere, see tests/platforms/README.md)"
)


def gazebo_ros_executable(name: str) -> str:
    """The path of gazebo_ros' own `gzserver` or `gzclient`. Raises ProcessError with what to install."""
    try:
        if importlib.util.find_spec("gazebo_msgs"):
            return executable_of("gazebo_ros", name)
    except ProcessError:
        pass
    raise ProcessError(MISSING)
