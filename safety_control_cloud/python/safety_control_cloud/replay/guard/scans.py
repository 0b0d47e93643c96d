# SPDX-License-Identifier: BSD-3-Clause
"""Scans of a laser, as the guard's sensors take them."""
from __future__ import annotations

from typing import Optional, Union

from safety_control_cloud import core
from safety_control_cloud.replay.bags import Bags, Recorded
from safety_control_cloud.replay.eyes import CloudEye, DepthEye, Sighting, eye_for
from safety_control_cloud.replay.topics import Source
from safety_control_cloud.replay.wire import Header


class ScanEye:
    def __init__(self, bags: Bags) -> None:
        self._bags, self._seen = bags, 0

    def sighting_of(self, message: Recorded) -> Optional[Sighting]:
        """Raises BagError."""
        scan = self._bags.content_of(message)
        header = Header(scan.header.stamp.sec * 10**9 + scan.header.stamp.nanosec, scan.header.frame_id)
        cloud = core.Cloud.of_scan(
            scan.ranges, scan.angle_min, scan.angle_max, scan.angle_increment, scan.range_min, scan.range_max,
            scan.time_increment, scan.scan_time)
        self._seen += 1
        return Sighting(self._seen - 1, message.time, header, message.source, cloud, (message,), None)


def any_eye_for(bags: Bags, source: Source) -> Union[CloudEye, DepthEye, ScanEye]:
    return ScanEye(bags) if source.input == "scan" else eye_for(bags, source)
