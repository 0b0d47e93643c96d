# SPDX-License-Identifier: BSD-3-Clause
"""What replay --mode guard says of a bag, for tests."""
from __future__ import annotations

import json
import struct
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List

from safety_control_cloud.replay.options import request_of
from safety_control_cloud.replay.replay import replay as replay_in_process

SENSORS = [{"name": "camera_depth_points", "type": "cloud", "topic": "/camera/depth/points"},
           {"name": "scan", "type": "scan", "topic": "/scan"}]


def replay(*arguments: Any) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "safety_control_cloud.replay", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


def told(folder: Path, *arguments: Any) -> List[Dict[str, Any]]:
    """Every answer; in this process, which takes no second."""
    file = folder / "guarded.json"
    replay_in_process(request_of([*map(str, arguments), "--mode", "guard", "--json", str(file)]))
    return json.loads(file.read_text())


def to_commands(answers: List[Dict[str, Any]]) -> List[Dict[str, Any]]:
    return [answer for answer in answers if answer["asked_by"] == "command"]


def numbers(twist: Dict[str, List[float]]) -> List[float]:
    return [*twist["linear"], *twist["angular"]]


def bits(values: List[float]) -> bytes:
    return struct.pack("6d", *values)
