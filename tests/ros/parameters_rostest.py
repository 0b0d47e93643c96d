#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A node with parameters that are unfit to drive with does not start, and says all that is wrong."""
import unittest

import rospy
import rostest
from listening import PATIENCE, Heard, playing
from recordings import wall_at

from safety_control_cloud.msg import SafetyState
from safety_control_cloud.ros_session import node

NAME = "/safety_control_cloud"


class Parameters(unittest.TestCase):
    def setUp(self):
        if rospy.has_param(NAME):
            rospy.delete_param(NAME)  # a parameter outlives the node that was given it

    def refusal_of(self, **parameters):
        rospy.set_param(NAME, parameters)
        with node("safety_control_node") as running:
            self.assertNotEqual(running.wait(PATIENCE), 0)
            return running.output()

    def test_all_problems_are_listed_at_once(self):
        output = self.refusal_of(
            wraning_distance=2.0, colour="red", method="fast", min_points=0, x_min=1.0, safe_speed="quick",
            release_clouds=-1, source_timeout=float("nan"), diagnostic_period=0.0)

        for problem in (
                "there is no parameter ~wraning_distance; did you mean ~warning_distance?",
                "there is no parameter ~colour (it stays on the parameter server until: rosparam delete /safety_control_cloud/colour)\n", "~method must be one_pass or pcl", "min_points must be at least 1",
                "x_min must be less than x_max", "~safe_speed must be a number", "~release_clouds must not be negative",
                "source_timeout must be finite", "~diagnostic_period must be more than 0 s"):
            self.assertIn(problem, output.replace("\x1b[0m", "\n"))

    def test_one_problem_is_enough(self):
        self.assertIn("did you mean ~danger_distance?", self.refusal_of(danger_distanc=0.4))

    def test_what_lies_deeper_in_the_namespace_is_not_the_nodes(self):
        self.check_zone_at(0.75, "Warning", library={"of_another": 1})

    def test_ours_that_lie_deeper_are_misplaced(self):
        for name in ("safety_control_cloud", "library"):
            output = self.refusal_of(**{name: {"danger_distance": 0.9, "colour": "red"}})
            self.assertIn(f"~{name}/danger_distance is not read: put ~danger_distance right under the node's name", output)
            self.assertNotIn("colour", output)

    def test_a_whole_number_does_for_a_distance(self):
        self.check_zone_at(1.5, "Warning", warning_distance=2)

    def test_a_parameter_moves_the_limit(self):
        self.check_zone_at(0.75, "Danger", danger_distance=0.8)

    def check_zone_at(self, distance, zone, **parameters):
        rospy.set_param(NAME, {"source_timeout": 10.0, "stamp_tolerance": 0, **parameters})
        states = Heard(NAME + "/state", SafetyState)
        with node("safety_control_node"), playing([wall_at(distance, 1)]):
            state = states.until(lambda state: state.cause_text == "SEEN")
        states.close()
        self.assertEqual(state.zone_text, zone)


if __name__ == "__main__":
    rospy.init_node("parameters")
    rostest.rosrun("safety_control_cloud", "parameters", Parameters)
