# SPDX-License-Identifier: BSD-3-Clause
"""scripts/replay: bags through the node, see options.py."""
from __future__ import annotations

import sys

from safety_control_cloud.commands.complaint import complain
from safety_control_cloud.optional import MissingPackages, require
from safety_control_cloud.processes import ProcessError, end_on_sigterm
from safety_control_cloud.replay.options import request_of

FAILED, INTERRUPTED = 1, 130  # exit codes


def main() -> int:
    request = request_of()
    try:
        require("replay")
    except MissingPackages as error:
        return complain("replay", error)
    from safety_control_cloud.replay.bags import BagError  # after the arguments: --help needs Python alone
    from safety_control_cloud.replay.lockstep import BadParameters, NoAnswer
    from safety_control_cloud.replay.parameters import BadSettings
    from safety_control_cloud.replay.replay import replay

    end_on_sigterm()
    try:
        replay(request)
    except (BagError, BadParameters, BadSettings, MissingPackages) as error:
        return complain("replay", error)
    except (NoAnswer, ProcessError, OSError) as error:
        return complain("replay", error, FAILED)
    except KeyboardInterrupt:
        return INTERRUPTED
    return 0


if __name__ == "__main__":
    sys.exit(main())
