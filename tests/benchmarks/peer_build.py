# SPDX-License-Identifier: BSD-3-Clause
"""safety_limiter, built from the user's checkout in a folder of this clone's build/, with the ROS that this package has."""
import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Iterator, List, Optional

from exchange import PROGRAMS
from peer_checkout import PACKAGE, Checkout

from safety_control_cloud.processes import ProcessError

PYTHON = "/usr/bin/python3"  # ROS's own, whichever stands first in PATH
# Debian's ROS includes <boost/bind/bind.hpp>, which leaves out the _1 and _2 that Ubuntu's brings and the sources use.
FLAGS = "-DBOOST_BIND_GLOBAL_PLACEHOLDERS -include boost/bind.hpp"
OPTIONS = [
    "-DCMAKE_BUILD_TYPE=Release", "-DCATKIN_ENABLE_TESTING=OFF", f"-DCMAKE_CXX_FLAGS={FLAGS}",
    *(f"-D{name}_EXECUTABLE={PYTHON}" for name in ("Python", "Python3", "PYTHON")),
]
NOT_FOUND = re.compile(r'configuration\s+file\s+provided\s+by\s+"(\w+)"')


def program_of(checkout: Checkout) -> Path:
    """The program, built where it is not yet. Raises ProcessError, which says what is missing."""
    refuse_what_is_missing(checkout, list(prefixes()))
    workspace = PROGRAMS / "peer" / key_of(checkout)
    link(checkout, workspace / "src")
    build = workspace / "build"
    program = workspace / "devel" / "lib" / PACKAGE / PACKAGE
    if not program.exists():
        print(f"bench: building {PACKAGE} from {checkout.packages[PACKAGE]}, about a minute ...", file=sys.stderr)
    if not (build / "Makefile").exists():
        run(["cmake", "-S", str(workspace / "src"), "-B", str(build), f"-DCATKIN_DEVEL_PREFIX={workspace / 'devel'}", *OPTIONS], workspace)
    run(["cmake", "--build", str(build), "--target", PACKAGE], workspace)
    return program


def prefixes() -> Iterator[Path]:
    """Where packages are installed."""
    yield from (Path(folder) for folder in os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if folder)
    yield Path("/usr")


def refuse_what_is_missing(checkout: Checkout, installed: List[Path]) -> None:
    missing = [f"{name} (of {home})" for name, home in sorted(checkout.missing.items()) if share(name, installed) is None]
    if missing:
        raise ProcessError(f"{PACKAGE} needs {' and '.join(missing)}: not in the folder of --peer, no clone beside that, and not installed")


def share(package: str, installed: List[Path]) -> Optional[Path]:
    return next((folder / "share" / package for folder in installed if (folder / "share" / package / "package.xml").exists()), None)


def key_of(checkout: Checkout) -> str:
    """Another for other folders."""
    return hashlib.sha256("\n".join(str(folder) for folder in checkout.packages.values()).encode()).hexdigest()[:12]


def link(checkout: Checkout, src: Path) -> None:
    """A workspace's src of these packages alone."""
    catkin = share("catkin", list(prefixes()))
    if catkin is None:
        raise ProcessError("catkin is not installed")
    src.mkdir(parents=True, exist_ok=True)
    for name, target in {**checkout.packages, "CMakeLists.txt": catkin / "cmake" / "toplevel.cmake"}.items():
        if not (src / name).is_symlink():
            (src / name).symlink_to(target)


def run(command: List[str], workspace: Path) -> None:
    """ROS's Python first in PATH: CMake, genmsg and ament look for one by themselves."""
    log = workspace / "build.log"
    environment = {**os.environ, "PATH": os.pathsep.join(["/usr/bin", os.environ["PATH"]])}
    with log.open("w") as file:
        code = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT).returncode
    if code != 0:
        raise ProcessError(f"{PACKAGE} cannot be built: {reason_of(log.read_text(errors='replace'))}; all of it is in {log}")


def reason_of(log: str) -> str:
    """The package that CMake did not find, or the first error."""
    found = NOT_FOUND.search(log)
    if found:
        dashed = found[1].replace("_", "-")
        return f"{found[1]} is not installed (Debian: lib{dashed}-dev; Ubuntu: ros-noetic-{dashed})"
    errors = [line.strip() for line in log.splitlines() if "error" in line.lower()]
    return errors[0] if errors else "for an unknown reason"
