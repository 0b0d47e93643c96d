# SPDX-License-Identifier: BSD-3-Clause
"""Scans of a laser, as the guard's sensors take them."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Union

import numpy as np

from safety_control_cloud import core
from safety_control_cloud.replay.bags import Bags, Recorded
from safety_control_cloud.replay.eyes import CloudEye, DepthEye, Sighting, eye_for
from safety_control_cloud.replay.topics import Source
from safety_control_cloud.replay.wire import header_in


@dataclass(frozen=True)
class Scan:
    """What of a sensor_msgs/LaserScan is shown to people."""

    ranges: np.ndarray  # (N,) [m]
    angle_min: float
    angle_increment: float
    range_min: float
    range_max: float

    def points(self) -> np.ndarray:
        """(M, 3) float32 [m] of its returns, in the laser's frame."""
        there = (self.ranges >= self.range_min) & (self.ranges <= self.range_max)
        bearings = self.angle_min + self.angle_increment * np.flatnonzero(there)
        far = self.ranges[there]
        return np.stack([far * np.cos(bearings), far * np.sin(bearings), np.zeros(len(far))], axis=1).astype(np.float32)


class ScanEye:
    def __init__(self, bags: Bags) -> None:
        self._bags, self._seen = bags, 0

    def sighting_of(self, message: Recorded) -> Optional[Sighting]:
        """Raises BagError."""
        scan = self._bags.content_of(message)
        cloud = core.Cloud.of_scan(
            scan.ranges, scan.angle_min, scan.angle_max, scan.angle_increment, scan.range_min, scan.range_max,
            scan.time_increment, scan.scan_time)
        content = Scan(scan.ranges, scan.angle_min, scan.angle_increment, scan.range_min, scan.range_max)
        self._seen += 1
        return Sighting(self._seen - 1, message.time, header_in(scan), message.source, cloud, (message,), content)


def any_eye_for(bags: Bags, source: Source) -> Union[CloudEye, DepthEye, ScanEye]:
    return ScanEye(bags) if source.input == "scan" else eye_for(bags, source)
