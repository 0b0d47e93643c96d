# SPDX-License-Identifier: BSD-3-Clause
"""For every test."""
import signal
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))  # pytest's importlib mode does not
import skips  # noqa: E402

# A shell's background job ignores SIGINT, and so would every process that a test starts, and ends as Ctrl-C does.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_configure(config):
    config.pluginmanager.register(skips.Watch(skips.allowed_in(skips.LIST), skips.platform()), "skips")
