# SPDX-License-Identifier: BSD-3-Clause
"""Tells what the safety node would have said to every cloud of a bag."""
from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Dict, Optional, Sequence, Tuple

from safety_control_cloud.processes import ProcessError, end_on_sigterm
from safety_control_cloud.replay.bags import BagError
from safety_control_cloud.replay.lockstep import BadParameters, NoAnswer
from safety_control_cloud.replay.replay import Request, replay

FAILED, UNUSABLE, INTERRUPTED = 1, 2, 130  # exit codes; argparse too says 2
PICTURES = (".png", ".pdf", ".svg")


def request_of(arguments: Optional[Sequence[str]] = None) -> Request:
    parser = argparse.ArgumentParser(prog="replay", description=__doc__, epilog="Exit code 2: nothing to replay.")
    parser.add_argument("bags", metavar="BAG", nargs="+", type=Path, help="a ROS 1 bag, or the folder of a ROS 2 bag")
    parser.add_argument("--topic", metavar="T", help="needed where clouds were recorded on several topics")
    parser.add_argument("--method", choices=("one_pass", "pcl"), help="how the node searches the corridor")
    parser.add_argument("--param", metavar="NAME=VALUE", type=_parameter, action="append", default=[],
                        help="a private parameter of the node, e.g. --param danger_distance=0.6; may be repeated")
    parser.add_argument("--json", metavar="F", type=_writable, help="write the table as a list of objects")
    parser.add_argument("--plot", metavar="F.png", type=_picture, help="draw distance and speed over time")
    given = parser.parse_args(arguments)
    parameters: Dict[str, str] = dict(given.param)
    if given.method:
        parameters["method"] = given.method
    return Request(tuple(given.bags), given.topic, parameters, given.json, given.plot)


def _parameter(text: str) -> Tuple[str, str]:
    name, equals, value = text.partition("=")
    if not (name and equals and value):
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=VALUE")
    return name.lstrip("~_"), value


def _writable(text: str) -> Path:
    path = Path(text)
    if path.is_dir() or not path.absolute().parent.is_dir():
        raise argparse.ArgumentTypeError(f"cannot write {text}")
    return path


def _picture(text: str) -> Path:
    if Path(text).suffix not in PICTURES:
        raise argparse.ArgumentTypeError(f"{text!r} does not end in {', '.join(PICTURES)}")
    return _writable(text)


def main() -> int:
    request = request_of()
    end_on_sigterm()
    try:
        replay(request)
    except (BagError, BadParameters) as error:
        return _complain(error, UNUSABLE)
    except (NoAnswer, ProcessError, OSError) as error:
        return _complain(error, FAILED)
    except KeyboardInterrupt:
        return INTERRUPTED
    return 0


def _complain(error: Exception, code: int) -> int:
    print(f"replay: {error}", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
