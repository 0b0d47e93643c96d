# SPDX-License-Identifier: BSD-3-Clause
"""The decision of safety_control_cloud: the same C++ code that the node runs.

Frame: optical (x right, y down, z forward) [m]. Points are float32. Clouds are borrowed, never copied; the GIL is
released while one is looked at, so do not write to it, nor call the same control, from another thread meanwhile.
"""
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

class Zone:
    """How near the obstacle is. int(zone): DANGER 0, WARNING 1, SAFE 2, as in SafetyState.msg."""

    DANGER: Zone
    WARNING: Zone
    SAFE: Zone
    name: str
    def __int__(self) -> int: ...

class Cause:
    """Why a decision is what it is. With every cause but SEEN, NEAR_LOSS and LOW_OBSTACLE the robot stands. Numbers as
    in SafetyState.msg."""

    SEEN: Cause
    NO_CLOUD: Cause
    SILENT: Cause
    UNREADABLE: Cause
    BLIND: Cause
    STALE: Cause
    FUTURE: Cause
    CLOCK_JUMP: Cause
    NEAR_LOSS: Cause
    FROZEN: Cause
    NO_TRANSFORM: Cause
    TWO_SOURCES: Cause
    LOW_OBSTACLE: Cause
    TWO_COMMANDERS: Cause
    WRONG_VIEW: Cause
    NO_TIME: Cause
    NO_COMMAND: Cause
    BAD_COMMAND: Cause
    NO_ODOMETRY: Cause
    BUMPER: Cause
    CLIFF: Cause
    name: str
    def __int__(self) -> int: ...

class Settings:
    """Every parameter of the node, by its ROS name without the ~ and with the node's default.

    Raises AttributeError for a name that is no parameter, TypeError or ValueError, with the name, for what is no value
    of it.
    """

    x_min: float
    x_max: float
    y_min: float
    y_max: float
    target_frame: str
    left: float
    right: float
    bottom: float
    top: float
    range_min: float
    min_points: int
    warning_distance: float
    danger_distance: float
    safe_speed: float
    warning_speed: float
    release_clouds: int
    release_time: float
    source_timeout: float
    stamp_tolerance: float
    min_valid_ratio: float
    min_returns: int
    near_loss_distance: float
    near_loss_timeout: float
    blind_range: float
    frozen_clouds: int
    sensor_period: float
    base_timeout: float
    base_deceleration: float
    hull: float
    mode: str
    base_frame: str
    odom_frame: str
    footprint: str
    radius: float
    margin: float
    self_boxes: str
    command_type: str
    command_max_age: float
    command_timeout: float
    min_speed: float
    max_speed: float
    max_turn: float
    zone_caps: bool
    escape_speed: float
    unseen_speed: float
    override_max: float
    override_speed: float
    latency: float
    base_reaction: float
    angular_deceleration: float
    obstacle_speed: float
    noise: float
    memory_distance: float
    memory_time: float
    odometry_drift: float
    sensors: List[Dict[str, Any]]
    switches: List[Dict[str, Any]]
    switch_release_time: float
    publish_rate: float
    depth_minus_inf: str
    inf_is_free: bool
    zero_is_inf: bool
    method: str
    input: str
    def __init__(self, **parameters: Union[float, int, str]) -> None: ...
    def as_dict(self) -> Dict[str, Any]: ...
    def problems(self) -> List[str]:
        """A sentence for everything that makes these settings unfit to drive with; empty if they are fit."""

class CameraClaims:
    """What a sensor_msgs/CameraInfo says, by its names; roi is (x_offset, y_offset, height, width)."""

    def __init__(
        self,
        height: int,
        width: int,
        D: Sequence[float],
        K: Sequence[float],
        P: Sequence[float],
        binning_x: int = 0,
        binning_y: int = 0,
        roi: Tuple[int, int, int, int] = ...,
    ) -> None: ...

class Cloud:
    """A cloud, or a depth image, in borrowed memory. An array of points may stand wherever a Cloud is asked for."""

    def __init__(self, points: np.ndarray) -> None:
        """Points of shape (N, 3), or (H, W, 3) if organised, with any strides that do not run backwards.

        Raises TypeError unless float32 in this machine's byte order, ValueError for another shape.
        """
    @staticmethod
    def of_bytes(
        data: Union[bytes, bytearray, memoryview, np.ndarray],
        height: int,
        width: int,
        fields: Sequence[Tuple[str, int, int, int]],
        is_bigendian: bool,
        point_step: int,
        row_step: int,
    ) -> Cloud:
        """The content of a sensor_msgs/PointCloud2; fields are (name, offset [byte], datatype code, count).

        A layout that contradicts itself makes an unreadable cloud, as it does in the node; it does not raise.
        """
    @staticmethod
    def of_depth(image: np.ndarray, fx: float, fy: float, cx: float, cy: float) -> Cloud:
        """A rectified depth image of shape (H, W), float32 [m] or uint16 [mm], and its camera [px].

        Its points are those of depth_image_proc/point_cloud_xyz, but for -Inf: see depth_minus_inf. Raises TypeError for another type of pixel, ValueError
        for another shape or for pixels of a row that do not follow each other.
        """
    @staticmethod
    def of_image(
        data: Union[bytes, bytearray, memoryview, np.ndarray],
        height: int,
        width: int,
        encoding: str,
        is_bigendian: bool,
        step: int,
        rectified: bool,
        camera: CameraClaims,
    ) -> Cloud:
        """The content of a sensor_msgs/Image of depths, and its camera; `rectified`: the image is, whatever D says.

        What contradicts itself makes an unreadable cloud, as it does in the node; it does not raise.
        """
    @staticmethod
    def of_scan(
        ranges: np.ndarray,
        angle_min: float,
        angle_max: float,
        angle_increment: float,
        range_min: float,
        range_max: float,
        time_increment: float = 0.0,
        scan_time: float = 0.0,
    ) -> Cloud:
        """The content of a sensor_msgs/LaserScan, for a GuardControl alone; ranges are (N,), and copied.

        What contradicts itself makes an unreadable cloud, as it does in the node. Raises ValueError for another shape.
        """
    @property
    def unreadable(self) -> Optional[str]:
        """Why the points cannot be read, or None if they can."""

class Obstacle:
    """A point that the robot would run into."""

    @property
    def distance(self) -> float:
        """[m] along z from the sensor."""
    @property
    def point(self) -> Tuple[float, float, float]:
        """x, y, z [m]; the origin if the sensor reported "too close" (-Inf, REP 117)."""

class Sight:
    """What one cloud shows in the corridor."""

    nearest: Optional[Obstacle]  # the min_points-th smallest z; None: seen, and nothing there
    inside: int  # returns in the corridor
    too_close: int  # points at -Inf that cannot be placed outside the corridor
    returns: int  # points with finite x, y, z and z > range_min
    total: int  # points of the cloud
    @property
    def crop(self) -> Optional[np.ndarray]:
        """The returns in the corridor, (inside, 3) float32 in the cloud's order; None unless asked for."""

class Decision:
    """How fast the robot may go, and why."""

    zone: Zone
    speed: float  # [m/s] forward
    cause: Cause
    reason: str  # the cause in words, with its figures
    stuck_since: Optional[float]  # [s] of `now`, while it stands for what nobody sees any more
    hint: str  # what would free it then
    nearest: Optional[Obstacle]  # what the zone was decided by
    sight: Sight

class SafetyControl:
    """Decides one cloud at a time.

    `now` [s] is any clock that never goes back, the same one in every call; `stamp` and `ros_now` [s] are the cloud's
    stamp and the clock it was stamped by; 0 is no time (NO_TIME). Left out, they are taken for `now`: the cloud is fresh.
    """

    def __init__(self, settings: Settings = ...) -> None:
        """Raises ValueError with all settings.problems(), if there are any."""
    def decide(
        self,
        cloud: Union[Cloud, np.ndarray],
        now: float,
        crop: bool = False,
        stamp: Optional[float] = None,
        ros_now: Optional[float] = None,
        camera: Optional[Union[np.ndarray, str]] = None,
        source: str = "",
        frame: str = "",
    ) -> Decision:
        """The decision for a cloud that has just arrived; an unreadable one is decided on too (UNREADABLE, 0 m/s).

        With a target_frame, `camera` is where the camera is in it: the matrix, (3, 4) or (4, 4), that takes points of
        the optical frame to target_frame (x forward, y left, z up) [m]; or a sentence that says why that is not known.
        Left out, the robot stands (NO_TRANSFORM). `source`: who sent the cloud, `frame`: that its header
        names. Raises ValueError for another shape.
        """
    def without_cloud(self, now: float, ros_now: Optional[float] = None) -> Decision:
        """The decision that holds when no cloud arrives: the last one until source_timeout, then SILENT."""
    def forget_losses(self) -> None:
        """Forgets the near obstacles that were lost from sight (NEAR_LOSS), and how much and how soon the camera used to
        show (BLIND, STALE): somebody has looked."""
    def remembered(self) -> List[str]:
        """What is near or lost, a text for each camera, as the node keeps it in ~lost/things; empty if nothing is."""

class Command:
    """A velocity command as it comes, a geometry_msgs/Twist."""

    linear: List[float]  # [m/s] x forward, y left, z up
    angular: List[float]  # [rad/s] about them; about z: turning left
    def __init__(self, linear: Sequence[float] = ..., angular: Sequence[float] = ...) -> None: ...

class Guarded:
    """What the guard lets through, and why no more."""

    wanted: Command
    given: Command
    factor: float  # given is so much of wanted; 1: nothing was taken from it
    time_to_contact: float  # [s] of wanted; infinite if nothing is touched before the robot could stand
    sensor: str  # that decided; empty: none did
    cause: Cause
    reason: str  # the cause in words, with its figures
    hint: str  # what would free it, if it stands for what nobody sees any more
    in_view: bool  # some sensor looks where what is wanted leads
    open: int  # while it is stuck: bits of the directions in which it may move, as in SafetyState.msg
    override_left: float  # [s] for which what is seen is not asked; 0: it is
    sight: Sight  # what the latest cloud held
    @property
    def point(self) -> Optional[Tuple[float, float]]:
        """x, y [m] in base_frame, that decided; None: none did."""
    @property
    def stuck_since(self) -> Optional[float]:
        """[s] of `now`, while something is wanted and nothing is given."""

class GuardControl:
    """Mode guard: what is safe of what somebody else wants. Times as in SafetyControl."""

    def __init__(self, settings: Settings) -> None:
        """Raises ValueError with all settings.problems(), if there are any."""
    def see(
        self,
        cloud: Union[Cloud, np.ndarray],
        now: float,
        stamp: Optional[float] = None,
        ros_now: Optional[float] = None,
        camera: Optional[Union[np.ndarray, str]] = None,
        source: str = "",
        frame: str = "",
        sensor: int = 0,
    ) -> None:
        """A cloud has come, readable or not; `camera` is where it is in base_frame, else as in SafetyControl.decide.
        `sensor`: which of settings.sensors sent it. Raises IndexError if there is none."""
    def want(
        self,
        linear: Sequence[float],
        angular: Sequence[float],
        now: float,
        stamp: Optional[float] = None,
        ros_now: Optional[float] = None,
    ) -> None:
        """Somebody wants this, three numbers each; `stamp` [s]: of a TwistStamped."""
    @property
    def answer_period(self) -> float:
        """[s] after which there is to be a new answer, though nobody says anything."""
    def note_odometry(self, stamp: float, pose: Sequence[float], twist: Sequence[float],
                      base: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """The base says at `stamp` [s, ROS time] that it is at x, y [m], heading [rad] of a frame that rests, and moves
        with vx, vy [m/s], w [rad/s] of its own; or a part of it, on which base_frame is at `base`."""
    def note_pose(self, stamp: float, pose: Sequence[float]) -> None:
        """The same of whom tells no twist, as TF."""
    def note_outside(self, cause: Optional[Cause], reason: str = "") -> None:
        """What is in doubt outside of the sensors: from the next answer on it stands for it, until there is none."""
    def note_switch(self, which: str, side: str, touched: bool, now: float, who: str = "driver") -> None:
        """The switch of this name says of a side of the robot whether it is touched there; `who`, a node's name, speaks
        for it."""
    def ask_override(
        self, seconds: float, speed: float, now: float, ros_now: Optional[float] = None, even_in_doubt: bool = False
    ) -> Tuple[bool, str]:
        """Whether for a while nobody asks what is seen, and why not or what holds now."""
    def answer(self, now: float, ros_now: Optional[float] = None) -> Guarded:
        """What holds now; it is taken for said to the base."""
    def until_silent(self, now: float) -> float:
        """[s] until the next sensor counts as silent; infinite if none will."""
    def adopt(self, settings: Settings) -> None:
        """Goes on with other settings; raises as the constructor does and then keeps the old ones."""
    def forget_losses(self) -> None:
        """As SafetyControl's."""
    def remembered(self) -> List[str]:
        """As SafetyControl's."""
    def recall(self, remembered: List[str]) -> bool:
        """Goes on with what another one remembered; False if not with all of it: for the rest the robot stands."""

def look(
    cloud: Union[Cloud, np.ndarray], settings: Settings = ..., crop: bool = False, camera: Optional[np.ndarray] = None
) -> Sight:
    """One pass over the bytes; `camera` as in decide().

    Raises ValueError with the reason if the cloud is unreadable, or if the settings name a target_frame and `camera` is
    left out, or the other way round.
    """

def passthrough(
    cloud: Union[Cloud, np.ndarray], settings: Settings = ..., crop: bool = False, camera: Optional[np.ndarray] = None
) -> Sight:
    """The same Sight by pcl::PassThrough and pcl::getMinMax3D. Raises as look() does."""

def instruction_sets() -> List[str]:
    """What look() can use on this machine, best first, as "AVX2" or "NEON"; built without Highway "GNU_AVX2", "GNU_NEON"."""

def use_instruction_set(name: str = "") -> None:
    """For tests and benchmarks: look() uses this one from now on, or the best again for "".

    Raises ValueError if the machine lacks it. Not to be called while another thread looks.
    """

def zone_at(distance: float, settings: Settings = ...) -> Zone:
    """The zone of an obstacle at this distance [m]; NaN is DANGER."""

def speed_for(zone: Zone, settings: Settings = ...) -> float:
    """[m/s] forward."""

Vector = Tuple[float, float]  # x forward, y left [m]
Motion = Tuple[float, float, float]  # vx forward, vy left [m/s], w turning left [rad/s]; in base_frame (REP 103)

class Footprint:
    """What the robot covers of the floor, in base_frame (x forward, y left) [m], and a margin kept clear around it."""

    def __init__(self, polygon: Sequence[Vector] = ..., radius: float = 0.0, margin: float = 0.0) -> None:
        """A polygon, convex or not, or a circle around the origin. Raises ValueError with all problems_in_footprint."""
    def signed_distance(self, points: np.ndarray) -> np.ndarray:
        """(N,) [m] from the footprint without its margin, of (N, 2) points; inside, minus that to the nearest side."""

def problems_in_footprint(polygon: Sequence[Vector] = ..., radius: float = 0.0, margin: float = 0.0) -> List[str]:
    """A sentence for everything that makes this no footprint; empty if it is one."""

class Law:
    """What decides how fast one may approach; core/speed/law.hpp says what each figure means."""

    sensor_period: float  # [s]
    latency: float  # [s]
    base_reaction: float  # [s]
    linear_deceleration: float  # [m/s2]
    angular_deceleration: float  # [rad/s2]
    obstacle_speed: float  # [m/s]
    escape_speed: float  # [m/s]
    noise: float  # [m]
    min_points: int
    def __init__(self, **figures: Union[float, int]) -> None:
        """Raises AttributeError for a name that is none of these, ValueError for a value that is unfit."""

class Limit:
    """What a robot may drive of a wish, and why not all of it."""

    factor: float  # in [0, 1], for limited()
    time: float  # [s] of the wanted twist until what decided is touched; infinite: nothing is
    point: Optional[int]  # which of the points that is
    is_escape: bool  # the way leads out of the margin, at escape_speed

def time_to_contact(
    footprint: Footprint, twist: Motion, points: np.ndarray, widening: float = 0.0, horizon: float = ...
) -> np.ndarray:
    """(N,) [s] of the twist until each of (N, 2) resting points touches the footprint, widened by margin and widening
    [m]; 0 inside it, infinite if not within a full turn or the horizon [s]. Raises ValueError for another shape."""

def moved(points: np.ndarray, twist: Motion, time: float) -> np.ndarray:
    """(N, 2) where resting points stand in base_frame after so many seconds of the twist."""

def reduced(points: np.ndarray, cell: float) -> Tuple[np.ndarray, List[int], float]:
    """One point for each cell [m] of a grid, the returns it stands for, and how far they lie from it at most [m]."""

def limited(twist: Motion, factor: float) -> Motion:
    """The twist as a whole times a factor in [0, 1]; at 1 equal in every bit."""

def greatest_factor(time: float, delay: float, reaction: float, braking: float, share: float = 0.0) -> float:
    """The greatest s in [0, 1] with s reaction + s^2 braking / 2 <= time [s], for a robot that drives `share` of the
    twist already and goes on with that for the delay."""

def straying(
    footprint: Footprint,
    law: Law,
    under_way: Motion,
    wanted: Motion,
    least: float = 0.0,
    most: float = 1.0,
    age: float = 0.0,
) -> Tuple[float, float]:
    """How much of the wanted twist the robot drives already, and how far it leaves its path at most [m], if it comes to
    drive it at a factor between least and most."""

def fan(
    footprint: Footprint,
    law: Law,
    under_way: Motion,
    wanted: Motion,
    least: float = 0.0,
    most: float = 1.0,
    age: float = 0.0,
) -> Optional[Tuple[float, List[Motion], float]]:
    """The same as arcs on which the robot may come to drive and to stop: its share, the arcs, and how far it leaves the
    nearest of them at most [m]. None where the two motions do not lead in the same direction."""

def limit(
    footprint: Footprint,
    law: Law,
    points: np.ndarray,
    wanted: Motion,
    under_way: Sequence[Motion] = ...,
    age: float = 0.0,
) -> Limit:
    """The greatest factor from which the robot still stops before it touches one of (N, 2) points. `age` [s] is theirs;
    `under_way`: its twist of now and the commands that may not yet have reached the base; none: it stands."""
