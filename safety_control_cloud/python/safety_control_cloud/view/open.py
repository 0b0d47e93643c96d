# SPDX-License-Identifier: BSD-3-Clause
"""Opens a recording: in a window where there is a screen, else for browsers."""
from __future__ import annotations

import os
import socket
import subprocess
from importlib.util import find_spec
from pathlib import Path
from typing import Dict, List, Mapping



def viewer() -> str:
    """The program itself: `python -m rerun` would leave it running when it is ended."""
    found = find_spec("rerun_cli")
    assert found and found.submodule_search_locations
    return str(Path(found.submodule_search_locations[0]) / "rerun")


def command(recording: Path, environment: Mapping[str, str], web_port: int = 0, data_port: int = 0) -> List[str]:
    if environment.get("DISPLAY") or environment.get("WAYLAND_DISPLAY"):
        return [viewer(), str(recording), "--port", "auto", "--hide-welcome-screen"]
    ports = ["--web-viewer-port", str(web_port), "--port", str(data_port)]
    return [viewer(), str(recording), "--serve-web", *ports, "--bind", "127.0.0.1", "--hide-welcome-screen"]


def look_at(recording: Path) -> int:
    """Until the window is closed, or Ctrl-C. The viewer's exit code."""
    web, data = free_port(), free_port()
    asked = command(recording, os.environ, web, data)
    if "--serve-web" in asked:
        from safety_control_cloud.view.sink import address

        print(f"no screen here: {address('127.0.0.1', web, data)} shows it until Ctrl-C", flush=True)
    return subprocess.run(asked, env=quiet(os.environ)).returncode


def quiet(environment: Mapping[str, str]) -> Dict[str, str]:
    return {"RUST_LOG": "error", **environment}


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])
