# SPDX-License-Identifier: BSD-3-Clause
"""Every TEST of every gtest executable as a test of its own, in a process of its own."""
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
BUILDS = {"": ROOT / "build", "sanitized/": ROOT / "build" / "sanitized"}
SECONDS = 120


def executables():
    """(label, path) of what tests/CMakeLists.txt lists; under the sanitizers only the core is built."""
    for label, build in BUILDS.items():
        manifest = build / "tests" / "gtests"
        for name in manifest.read_text().split() if manifest.exists() else []:
            if not label or name.startswith("core/"):
                yield label + name, manifest.parent / name


def names_in(listing):
    """The full names in what --gtest_list_tests prints."""
    suite = ""
    for line in listing.splitlines():
        name = line.split("#")[0].rstrip()
        if name.startswith("  "):
            yield suite + name.strip()
        elif name.endswith("."):
            suite = name


def parameters():
    for label, executable in executables():
        try:
            listing = subprocess.run([executable, "--gtest_list_tests"], stdout=subprocess.PIPE, text=True, timeout=SECONDS)
        except OSError:
            yield pytest.param(executable, None, id=label)
            continue
        yield from (pytest.param(executable, name, id=f"{label}/{name}") for name in names_in(listing.stdout))


def reason_in(output):
    """What GTEST_SKIP() was given, which stands between "[ RUN      ]" and "[  SKIPPED ]"."""
    return " ".join(output.split("[ RUN      ]")[-1].split("[  SKIPPED ]")[0].split("\n", 1)[1].split())


@pytest.mark.parametrize("executable, name", parameters())
def test_gtest(executable, name):
    if name is None:
        pytest.fail(f"{executable} cannot be run; scripts/test builds it", pytrace=False)
    result = subprocess.run(
        [executable, f"--gtest_filter={name}"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=SECONDS
    )
    if result.returncode != 0:
        pytest.fail(f"exit {result.returncode}\n{result.stdout}", pytrace=False)
    if "[  SKIPPED ]" in result.stdout:
        pytest.skip(reason_in(result.stdout))
    assert "[  PASSED  ] 1 test" in result.stdout


def test_the_gtests_are_built():
    built = dict(executables())
    assert any(label.startswith("core/") for label in built)
    assert any(label.startswith("sanitized/core/") for label in built)
