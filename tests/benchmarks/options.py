# SPDX-License-Identifier: BSD-3-Clause
"""What to measure, by the command line; needs Python alone."""
import argparse
from typing import Optional, Sequence

from peer_checkout import checkout_of

from safety_control_cloud.commands.arguments import count
from safety_control_cloud.view.options import writable

PARTS = ("kernel", "nodes", "depth", "cameras", "guard", "judge", "workers")
EPILOG = """\
A fresh cloud has not been looked at before and lies in no cache: every look takes another one, of more than any cache
holds together. A camera's cloud is such a one: the driver or the network has just written its megabytes from the first
to the last, and a core's own cache keeps one of them or two. kernel_vs_read is of fresh clouds; kernel_vs_read_cached
is of one cloud again and again, in the caches as far as it fits, which no camera sends.

Every repetition runs every case once. A figure is the median of its repetitions, a spread is (slowest - fastest) /
median. "worst" and "median" in the JSON are of all cases."""


def arguments(words: Optional[Sequence[str]] = None) -> argparse.Namespace:
    """Of these words, or of the command line."""
    parser = argparse.ArgumentParser(
        prog="scripts/bench", description="Measures what a decision costs, and beside what.", epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", type=writable, metavar="FILE", help="write all figures there")
    parser.add_argument("--plot", type=writable, metavar="FILE", help="draw time over points there")
    parser.add_argument("--quick", action="store_true", help="VGA only, less often, no callgrind: < 2 minutes")
    parser.add_argument("--only", choices=PARTS, action="append", help="this part; may be repeated")
    parser.add_argument("--repetitions", type=count, metavar="N", help="of every case; medians are shown (3, quick: 2)")
    parser.add_argument("--clouds", type=count, metavar="N", help="through processes, a repetition (50, quick: 20)")
    parser.add_argument("--peer", type=checkout_of, metavar="PATH",
                        help="beside the guard, safety_limiter from your checkout of at-wat/neonavigation there and of neonavigation_msgs, "
                             "as in a workspace's src or cloned beside it; needs --only guard")
    parser.add_argument("--without-highway", action="store_true", help="the kernel as it is where Highway is not installed; --only kernel")
    parser.add_argument("--store-instructions", action="store_true", help="hold the kernel to today's from now on")
    given = parser.parse_args(words)
    if given.without_highway and given.only != ["kernel"]:
        parser.error("--without-highway needs --only kernel")
    if given.peer and "guard" not in (given.only or ()):
        parser.error("--peer needs --only guard")
    if given.plot and (given.quick or given.only):
        parser.error("--plot needs a full run")
    return given
