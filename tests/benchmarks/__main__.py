# SPDX-License-Identifier: BSD-3-Clause
"""scripts/bench: options.py has the arguments, measuring.py what is done with them."""
import sys

from options import arguments

INTERRUPTED = 130  # exit code


def main() -> int:
    given = arguments()
    from measuring import bench  # after the arguments: --help needs Python alone

    from safety_control_cloud.processes import ProcessError, end_on_sigterm

    end_on_sigterm()
    try:
        bench(given)
    except KeyboardInterrupt:
        return INTERRUPTED
    except ProcessError as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
