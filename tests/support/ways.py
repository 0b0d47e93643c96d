# SPDX-License-Identifier: BSD-3-Clause
"""Where a base's footprint goes: driven in small steps, or on the path that it is judged by."""
import numpy as np

from safety_control_cloud import core

RESOLUTION = 0.003  # [m] of the path that is looked along, and of the base's steps


def body_points(shape):
    """Resting points where the footprint's corners are now: as far as they stray in the robot's frame, so does it."""
    if not shape.corners:
        return np.zeros((1, 2))
    return np.array(shape.corners)


def drive(base, wanted, brakes_after):
    """Poses, 10 ms apart, of a base that is told this now, and to stand so that it begins to brake then [s]."""
    law = base.law
    base.command(wanted)
    poses = []
    braking = False
    while base.time < brakes_after or max(map(abs, base.twist)) > 1e-3:
        if not braking and base.time >= brakes_after - law.latency - law.base_reaction:
            base.command((0.0, 0.0, 0.0))
            braking = True
        base.drive(0.01)
        poses.append((base.x, base.y, base.heading))
    return np.array(poses)


def corners_in_world(poses, corners):
    """(M, N, 2)"""
    x, y, heading = poses.T[:, :, None]
    return np.stack(
        [
            x + np.cos(heading) * corners[:, 0] - np.sin(heading) * corners[:, 1],
            y + np.sin(heading) * corners[:, 0] + np.cos(heading) * corners[:, 1],
        ],
        axis=2,
    )


def poses_on_path(wanted, way):
    """600 poses of a robot that obeys at once; the origin goes where a resting point would come from."""
    places = np.linspace(0, way, 600)
    backward = tuple(-value for value in wanted)
    origin = np.array([core.moved([(0, 0)], backward, place)[0] for place in places])
    return np.column_stack([origin, places * wanted[2]])
