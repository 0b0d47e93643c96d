# SPDX-License-Identifier: BSD-3-Clause
"""What ROS adds to a node's command line; needs Python alone."""
from __future__ import annotations

from collections.abc import Sequence


def without_remappings(arguments: Sequence[str]) -> list[str]:
    """As rospy.myargv has it: roslaunch adds __name:=, __log:= and the remapped topics, and none is an argument of ours."""
    return [argument for argument in arguments if ":=" not in argument]
