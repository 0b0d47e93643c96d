# SPDX-License-Identifier: BSD-3-Clause
"""Where pluginlib looks for a nodelet's library."""
import os
import sysconfig
from contextlib import suppress
from pathlib import Path


def prefixes(folder: Path) -> str:
    """CMAKE_PREFIX_PATH with one, in this folder, by which Debian 11's nodelets are found: they are described as in lib/, and
    lie in lib/<machine>."""
    prefix = folder / "prefix"
    prefix.mkdir(exist_ok=True)
    with suppress(FileExistsError):
        (prefix / "lib").symlink_to(Path("/usr/lib") / (sysconfig.get_config_var("MULTIARCH") or ""))
    return os.pathsep.join([*filter(None, [os.environ.get("CMAKE_PREFIX_PATH")]), str(prefix)])
