# SPDX-License-Identifier: BSD-3-Clause
"""scripts/turtlebot_sim: a TurtleBot with an Xtion in a world, for ROS."""
from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from ..simulation.base import LIMITS
from ..simulation.world_files import world_argument, world_names
from .arguments import not_negative, picture_size, positive, seed, yes
from .complaint import complain
from .remappings import without_remappings

if TYPE_CHECKING:
    from ..nodes.life import Life
    from ..nodes.turtlebot_sim import TurtlebotSim
    from ..simulation.world import World


def parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="turtlebot_sim", description=__doc__.split(": ", 1)[1],
        formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--world", type=world_argument, default="cabinet", help=f"{', '.join(world_names())}, or an MJCF file")
    parser.add_argument("--size", default="640x480", type=picture_size, help="of the camera's pictures [px]")
    parser.add_argument("--camera-rate", default=20.0, type=_camera_rate, help="pictures a simulated second; their distance is rounded to 10 ms")
    parser.add_argument("--depth-encoding", default="32FC1", choices=("32FC1", "16UC1"), help="of the depth image")
    parser.add_argument("--wheels", default="driver", choices=sorted(LIMITS),
                        help="with the driver's acceleration limits, or obeying at once as in Gazebo")
    parser.add_argument("--rate", default=1.0, type=not_negative, help="simulated seconds a real one; 0: as fast as it goes")
    parser.add_argument("--seed", default=0, type=seed, help="of the depth's noise and the body's rocking")
    parser.add_argument("--no-noise", action="store_true", help="true depth and no rocking")
    parser.add_argument("--viewer", nargs="?", const=True, default=False, type=yes, help="open MuJoCo's own window")
    return parser


def main(argv: list[str]) -> int:
    arguments = parser().parse_args(without_remappings(argv[1:]))
    import rospy  # after the arguments: --help needs Python alone

    try:
        from ..nodes.life import Life
        from ..nodes.turtlebot_sim import Options, TurtlebotSim
        from ..simulation.sensor import Xtion
        from ..simulation.turtlebot import TurtleBot
        from ..simulation.world import World
    except ModuleNotFoundError as missing:
        if missing.name != "mujoco":
            raise
        return complain("turtlebot_sim", "this needs MuJoCo, which scripts/setup installs beside the package")

    try:
        world = World.load(arguments.world, Xtion(*arguments.size, rate=arguments.camera_rate))
    except ValueError as error:
        return complain("turtlebot_sim", f"cannot simulate {arguments.world}: {' '.join(str(error).split())}")
    life = Life("turtlebot_sim")
    rospy.set_param("/use_sim_time", True)
    noise = None if arguments.no_noise else arguments.seed
    robot = TurtleBot(world, LIMITS[arguments.wheels], noise)
    simulator = TurtlebotSim(robot, Options(arguments.rate, arguments.depth_encoding, noise))
    if arguments.viewer:
        _run_in_window(simulator, world, life)
    else:
        simulator.run(life)
    return 0


def _camera_rate(text: str) -> float:
    """No more than one picture a tick of the simulators."""
    rate = positive(text)
    if rate > 100.0:
        raise argparse.ArgumentTypeError(f"{text} is more than 100")
    return rate


def _run_in_window(simulator: TurtlebotSim, world: World, life: Life) -> None:
    import mujoco.viewer  # needs a display

    from ..simulation.robot import BODY, GROUP

    with mujoco.viewer.launch_passive(world.model, world.data, show_left_ui=False, show_right_ui=False) as window:
        window.opt.geomgroup[GROUP] = 1
        window.cam.type, window.cam.trackbodyid = mujoco.mjtCamera.mjCAMERA_TRACKING, world.model.body(BODY).id
        window.cam.distance, window.cam.azimuth, window.cam.elevation = 4.0, 25.0, -25.0
        simulator.run(life, window.sync)


if __name__ == "__main__":
    sys.exit(main(sys.argv))
