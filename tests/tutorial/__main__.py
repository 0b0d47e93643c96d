# SPDX-License-Identifier: BSD-3-Clause
"""Takes the tutorial's pictures anew: python tests/tutorial, after scripts/setup --checks, with the package sourced."""
import argparse
import os
import sys
import tempfile
from functools import partial
from pathlib import Path

from page import PAGE, steps_of

INTERRUPTED = 130  # exit code


def main() -> int:
    argparse.ArgumentParser(prog="python tests/tutorial", description=__doc__).parse_args()
    from follow import NotSo, follow, keep_picture  # after the arguments: --help needs Python alone

    from safety_control_cloud.processes import ProcessError, end_on_sigterm
    from safety_control_cloud.ros_session import roscore
    from safety_control_cloud.virtual_screen import virtual_screen

    end_on_sigterm()
    try:
        with tempfile.TemporaryDirectory() as name, virtual_screen(1440, 900) as display, roscore():
            folder = Path(name)
            os.environ.update(DISPLAY=display, LIBGL_ALWAYS_SOFTWARE="1")
            follow(steps_of(PAGE.read_text()), folder, partial(keep_picture, folder=folder, page=PAGE), windows=True)
    except KeyboardInterrupt:
        return INTERRUPTED
    except (NotSo, ProcessError) as error:
        print(f"tutorial: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
