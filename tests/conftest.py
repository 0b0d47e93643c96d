# SPDX-License-Identifier: BSD-3-Clause
"""For every test."""
import os
import signal
from pathlib import Path

import skips

SUPPORT = str(Path(__file__).parent / "support")
# The programs that tests start, rostests and workers among them, find there what .pytest.ini gives pytest itself.
os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, [SUPPORT, os.environ.get("PYTHONPATH")]))

# A shell's background job ignores SIGINT, and so would every process that a test starts, and ends as Ctrl-C does.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_configure(config):
    config.pluginmanager.register(skips.Watch(skips.allowed_in(skips.LIST), skips.platform()), "skips")
