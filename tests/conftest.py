# SPDX-License-Identifier: BSD-3-Clause
"""For every test."""
import signal

# A shell's background job ignores SIGINT, and so would every process that a test starts, and ends as Ctrl-C does.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
