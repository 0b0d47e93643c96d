# SPDX-License-Identifier: BSD-3-Clause
"""Somebody tries to hit things, in every direction, and the node in mode guard stands between him and the base."""
from __future__ import annotations

import time
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING
from xml.etree.ElementTree import ParseError

import numpy as np
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rich.console import Console
from std_msgs.msg import String

from ..nodes.messages import to_pose, to_twist, to_velocity
from ..processes import Process
from ..simulation.base import Pose, Velocity
from ..simulation.furniture import Furniture, furniture_of
from ..simulation.world_files import world_file
from ..trials.guarded.drawing import Block, Spot, draw
from ..trials.guarded.drivers import PERIOD, Rude
from .run import Options, stage
from .watch import SIMULATOR

if TYPE_CHECKING:
    from safety_control_cloud.msg import SafetyState

BEGINS = 2.0  # [s] after the first cloud was believed
_SPOKEN_APART = 0.5  # [s] between two lines at least


def run_guarded(options: Options, seconds: float, seed: int) -> bool:
    """Did it touch nothing? Raises ProcessError if ROS does not come up, BadWorld for a world that nobody can drive in."""
    options.folder.mkdir(parents=True, exist_ok=True)
    console = Console(highlight=False, soft_wrap=True)
    try:
        furniture = furniture_of(world_file(options.world))
    except (ValueError, ParseError) as error:
        raise BadWorld(f"cannot drive in {options.world}: {error}") from error
    with stage(options, "guard:=true") as launch:
        ride = Ride(console)
        ride.drive(_rude(furniture, seed), seconds, launch)
    return _report(ride, furniture, options, console)


class BadWorld(ValueError):
    """str() says in a line what it lacks."""


class Ride:
    """What somebody wanted and what became of it; `spots` has one for each of his commands."""

    def __init__(self, console: Console) -> None:
        from safety_control_cloud.msg import SafetyState

        self._console, self._lock = console, Lock()
        self._odometry: Odometry | None = None
        self._state: SafetyState | None = None
        self._said, self._said_at = "", -1.0
        self.spots: list[Spot] = []
        self.touched: list[tuple[str, Pose]] = []
        self._wish = rospy.Publisher("/teleop/cmd_vel", Twist, queue_size=1)
        rospy.Subscriber("/odom", Odometry, self._on_odometry, queue_size=1)
        rospy.Subscriber("/safety_control_cloud/state", SafetyState, self._on_state, queue_size=1)
        rospy.Subscriber(f"{SIMULATOR}/contacts", String, self._on_contacts, queue_size=10)

    def drive(self, driver: Rude, seconds: float, launch: Process) -> None:
        """So long, of simulated time."""
        self._console.print("[dim]   time    wanted                 given  why[/]")
        begins: float | None = None
        rate = rospy.Rate(1 / PERIOD)
        while launch.exit_code is None and (begins is None or rospy.get_time() < begins + seconds):
            if self._odometry is None or self._state is None:
                time.sleep(0.05)
                continue
            begins = rospy.get_time() if begins is None else begins
            now, odometry = rospy.get_time() - begins, self._odometry
            pose, velocity = to_pose(odometry.pose.pose), to_velocity(odometry.twist.twist)
            wanted = driver.wants(now, pose, velocity) if now > BEGINS else Velocity()
            self._wish.publish(to_twist(wanted))
            self._take_down(now, pose)
            rate.sleep()
        self._wish.publish(Twist())

    def _take_down(self, now: float, pose: Pose) -> None:
        with self._lock:
            state = self._state
            spot = Spot(now, pose, to_velocity(state.wanted), to_velocity(state.given), state.factor)
            self.spots.append(spot)
        said = "stopped" if spot.is_stopped else "slowed" if spot.factor < 0.99 else "passes"
        if said != self._said and now > self._said_at + _SPOKEN_APART:
            self._said, self._said_at = said, now
            colour = {"stopped": "red", "slowed": "yellow", "passes": "green"}[said]
            self._console.print(f"{now:6.2f} s  {spot.wanted.linear:5.2f} m/s {spot.wanted.angular:5.2f} rad/s  "
                                f"[{colour}]{100 * spot.factor:4.0f} %[/]  {state.cause_text}, {state.reason}")

    def _on_odometry(self, odometry: Odometry) -> None:
        self._odometry = odometry

    def _on_state(self, state: SafetyState) -> None:
        with self._lock:
            self._state = state

    def _on_contacts(self, touched: String) -> None:
        if touched.data and self.spots:
            with self._lock:
                self.touched.append((touched.data, self.spots[-1].pose))
            self._console.print(f"[bold red]{self.spots[-1].time:6.2f} s  touches {touched.data}[/]")


def _rude(furniture: Furniture, seed: int) -> Rude:
    places = [(thing.place.of(shape.place).x, thing.place.of(shape.place).y)
              for thing in furniture.things for shape in thing.shapes if shape.kind != "plane"]
    return Rude(lambda now: places, np.random.Generator(np.random.SFC64(seed)))


def _blocks(furniture: Furniture) -> list[Block]:
    made = []
    for thing in furniture.things:
        for shape in thing.shapes:
            place = thing.place.of(shape.place)
            if shape.kind == "box":
                made.append(Block(place.x, place.y, place.yaw, 2 * shape.size[0], 2 * shape.size[1]))
            elif shape.kind == "cylinder":
                made.append(Block(place.x, place.y, place.yaw, 2 * shape.size[0], 2 * shape.size[0], True))
    return made


def _report(ride: Ride, furniture: Furniture, options: Options, console: Console) -> bool:
    spots, picture = ride.spots, options.folder / "run.png"
    console.print()
    if not spots:
        console.print("[bold red]the node said nothing[/]")
        return False
    wishes = [spot for spot in spots if abs(spot.wanted.linear) > 0.02 or abs(spot.wanted.angular) > 0.05]
    whole = sum(spot.factor == 1.0 for spot in wishes)
    stopped = sum(spot.is_stopped for spot in wishes)
    console.print(f"{len(wishes)} wishes: {whole} passed as they were, {len(wishes) - whole - stopped} slowed, {stopped} stopped")
    names = sorted({name for name, _ in ride.touched})
    console.print(f"[bold red]touched {', '.join(names)}[/]" if names else "[bold green]touched nothing[/]")
    draw(picture, f"World “{Path(options.world).stem}”: somebody tries to hit things, with the guard", spots, _blocks(furniture),
         None, [(pose.x, pose.y) for _, pose in ride.touched])
    console.print(f"Picture {picture}, bag {options.folder / 'run.bag'}")
    return not names
