# SPDX-License-Identifier: BSD-3-Clause
"""scripts/turtlebot_sim: a TurtleBot with an Xtion in a world, for ROS."""
from __future__ import annotations

import argparse
import os
import sys

import rospy

from ..nodes.turtlebot_sim import Options
from ..simulation.base import LIMITS
from ..simulation.sensor import Xtion


def parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="turtlebot_sim", description=__doc__.split(": ", 1)[1])
    parser.add_argument("--world", default="cabinet", help="cabinet, closed_cabinet, hall, playground, posts, or an MJCF file (%(default)s)")
    parser.add_argument("--size", default="640x480", type=_size, help="of the camera's pictures [px] (%(default)s)")
    parser.add_argument("--camera-rate", default=20.0, type=float, help="pictures a simulated second (%(default)s)")
    parser.add_argument("--depth-encoding", default="32FC1", choices=("32FC1", "16UC1"), help="of the depth image (%(default)s)")
    parser.add_argument("--wheels", default="driver", choices=sorted(LIMITS), help="the driver's acceleration limits, or Gazebo's wheels that obey at once (%(default)s)")
    parser.add_argument("--rate", default=1.0, type=float, help="simulated seconds a real one; 0: as fast as it goes (%(default)s)")
    parser.add_argument("--seed", default=0, type=int, help="of the depth's noise and the body's rocking (%(default)s)")
    parser.add_argument("--no-noise", action="store_true", help="true depth and no rocking")
    parser.add_argument("--viewer", nargs="?", const=True, default=False, type=_yes, help="open MuJoCo's own window")
    return parser


def main(argv: list[str]) -> None:
    arguments = parser().parse_args(rospy.myargv(argv)[1:])
    if arguments.viewer:
        os.environ["MUJOCO_GL"] = "glfw"  # the window and the camera must share one OpenGL
    rospy.init_node("turtlebot_sim")
    rospy.set_param("/use_sim_time", True)
    _simulate(arguments)


def _simulate(arguments: argparse.Namespace) -> None:
    try:
        from ..nodes.turtlebot_sim import TurtlebotSim
        from ..simulation.gl import mujoco  # MUJOCO_GL is read here
    except ModuleNotFoundError as missing:
        raise SystemExit(f"turtlebot_sim: {missing}; scripts/setup installs it") from missing
    from ..simulation.turtlebot import TurtleBot
    from ..simulation.world import World

    xtion = Xtion(*arguments.size, rate=arguments.camera_rate)
    seed = None if arguments.no_noise else arguments.seed
    robot = TurtleBot(World.load(arguments.world, xtion), LIMITS[arguments.wheels], seed)
    simulator = TurtlebotSim(robot, Options(arguments.rate, arguments.depth_encoding, seed))
    if not arguments.viewer:
        simulator.run()
        return
    import mujoco.viewer

    with mujoco.viewer.launch_passive(robot.world.model, robot.world.data) as window:
        window.opt.geomgroup[:] = 1
        simulator.run(window.sync)


def _size(text: str) -> tuple[int, int]:
    width, height = text.split("x")
    return int(width), int(height)


def _yes(text: str) -> bool:
    """roslaunch hands over `true` or `false`."""
    return text.strip().lower() in ("1", "true", "yes")


if __name__ == "__main__":
    main(sys.argv)
