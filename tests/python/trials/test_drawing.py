# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
import pytest

from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.trials.drawing import box_about


@pytest.mark.parametrize("yaw", [0.0, 0.5, -2.0])
def test_a_box_is_drawn_about_its_centre_along_its_yaw(yaw):
    box = box_about(Pose(1.0, -2.0, yaw), 0.8, 0.2, "black")

    drawn = box.get_patch_transform().transform([(0.5, 0.5), (1.0, 0.5), (0.5, 1.0)])  # the centre, ahead and left of it

    along, across = np.array([np.cos(yaw), np.sin(yaw)]), np.array([-np.sin(yaw), np.cos(yaw)])
    np.testing.assert_allclose(drawn - (1.0, -2.0), [(0.0, 0.0), 0.4 * along, 0.1 * across], atol=1e-9)
