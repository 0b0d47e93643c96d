# SPDX-License-Identifier: BSD-3-Clause
"""A real browser without a screen, and pictures of what it shows."""
from __future__ import annotations

import asyncio
import base64
import io
import json
import shutil
import subprocess
import urllib.request
from contextlib import contextmanager
from pathlib import Path
from typing import Callable, Iterator

import numpy as np
from PIL import Image
from patience import eventually
from tornado.websocket import websocket_connect  # Dask brings it

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
         "--disable-sync", "--disable-dev-shm-usage", "--hide-scrollbars", "--window-size=1500,900")
LARGEST = 1 << 26  # [byte] of an answer
PATIENCE = 180.0  # [s] the viewer is 60 MB of WebAssembly, and WebGL is drawn by the processor

Page = Callable[[], np.ndarray]


@contextmanager
def page(address: str, profile: Path) -> Iterator[Page]:
    """What to call for a picture (height, width, 3) of the page as it is now."""
    command = [CHROMIUM, *FLAGS, f"--user-data-dir={profile}", "--remote-debugging-port=0", address]
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        socket = eventually(lambda: _socket_of(profile), PATIENCE, 0.5)
        yield lambda: asyncio.run(_picture(socket))
    finally:
        running.kill()
        running.wait()


def _socket_of(profile: Path) -> str | None:
    """The page's, once the browser has written down its port."""
    file = profile / "DevToolsActivePort"
    if not file.exists() or not file.read_text():
        return None
    listing = urllib.request.urlopen(f"http://127.0.0.1:{file.read_text().split()[0]}/json", timeout=20)
    return next((one["webSocketDebuggerUrl"] for one in json.load(listing) if one["type"] == "page"), None)


async def _picture(socket: str) -> np.ndarray:
    connection = await websocket_connect(socket, max_message_size=LARGEST)
    await connection.write_message(json.dumps({"id": 1, "method": "Page.captureScreenshot"}))
    while True:
        answer = json.loads(await connection.read_message())
        if answer.get("id") == 1:
            connection.close()
            return np.asarray(Image.open(io.BytesIO(base64.b64decode(answer["result"]["data"]))).convert("RGB"))
