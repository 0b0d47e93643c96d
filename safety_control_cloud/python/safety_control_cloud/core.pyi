# SPDX-License-Identifier: BSD-3-Clause
"""The decision of safety_control_cloud: the same C++ code that the node runs.

Frame: optical (x right, y down, z forward) [m]. Points are float32. Clouds are borrowed, never copied; the GIL is
released while one is looked at, so do not write to it from another thread meanwhile.
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
    """Why a decision is what it is; with every cause but SEEN the robot stands. Numbers as in SafetyState.msg."""

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
    name: str
    def __int__(self) -> int: ...

class Settings:
    """Every parameter of the node, by its ROS name without the ~ and with the node's default.

    Raises AttributeError for a name that is no parameter.
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
    near_loss_distance: float
    near_loss_timeout: float
    frozen_clouds: int
    sensor_period: float
    base_timeout: float
    base_deceleration: float
    publish_rate: float
    method: str
    input: str
    def __init__(self, **parameters: Union[float, int, str]) -> None: ...
    def as_dict(self) -> Dict[str, Any]: ...
    def problems(self) -> List[str]:
        """A sentence for everything that makes these settings unfit to drive with; empty if they are fit."""

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

        Its points are those of depth_image_proc/point_cloud_xyz. Raises TypeError for another type of pixel, ValueError
        for another shape or for pixels of a row that do not follow each other.
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
    lost: int  # pixels without a return whose last one was near and in the corridor
    @property
    def crop(self) -> Optional[np.ndarray]:
        """The returns in the corridor, (inside, 3) float32 in the cloud's order; None unless asked for."""

class Decision:
    """How fast the robot may go, and why."""

    zone: Zone
    speed: float  # [m/s] forward
    cause: Cause
    reason: str  # the cause in words, with its figures
    nearest: Optional[Obstacle]  # what the zone was decided by
    sight: Sight

class SafetyControl:
    """Decides one cloud at a time.

    `now` [s] is any clock that never goes back, the same one in every call; `stamp` and `ros_now` [s] are the cloud's
    stamp and the clock it was stamped by. Left out, they are taken for `now`: the cloud is fresh.
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
    ) -> Decision:
        """The decision for a cloud that has just arrived; an unreadable one is decided on too (UNREADABLE, 0 m/s)."""
    def without_cloud(self, now: float, ros_now: Optional[float] = None) -> Decision:
        """The decision that holds when no cloud arrives: the last one until source_timeout, then SILENT."""
    def forget_losses(self) -> None:
        """Forgets the near obstacles that were lost from sight (NEAR_LOSS): somebody has looked."""

def look(cloud: Union[Cloud, np.ndarray], settings: Settings = ..., crop: bool = False) -> Sight:
    """One pass over the bytes. Raises ValueError with the reason if the cloud is unreadable."""

def passthrough(cloud: Union[Cloud, np.ndarray], settings: Settings = ..., crop: bool = False) -> Sight:
    """The same Sight by pcl::PassThrough and pcl::getMinMax3D. Raises ValueError if the cloud is unreadable."""

def instruction_sets() -> List[str]:
    """What look() can use on this machine, best first, as "AVX2" or "NEON"; "PORTABLE" is plain C++."""

def use_instruction_set(name: str = "") -> None:
    """For tests and benchmarks: look() uses this one from now on, or the best again for "".

    Raises ValueError if the machine lacks it. Not to be called while another thread looks.
    """

def zone_at(distance: float, settings: Settings = ...) -> Zone:
    """The zone of an obstacle at this distance [m]; NaN is DANGER."""

def speed_for(zone: Zone, settings: Settings = ...) -> float:
    """[m/s] forward."""
