# SPDX-License-Identifier: BSD-3-Clause
"""Every TEST of every gtest executable as a test of its own."""
import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
BUILDS = {"": ROOT / "build", "sanitized/": ROOT / "build" / "sanitized"}
SECONDS = 900  # for all tests of an executable, or, where that is too short, for half of them, and so on
ENDED = re.compile(r"^\[ RUN      \] (\S+)\n((?:.*\n)*?)\[ +(OK|SKIPPED|FAILED) +\] \1(?=[ ,])", re.MULTILINE)


def executables():
    """(label, path) of what tests/CMakeLists.txt lists; under the sanitizers what reads bytes which somebody else has laid
    out, and of `scripts/test --sanitize` all of the core."""
    some = "gtests" if "SAFETY_CONTROL_SANITIZE" in os.environ else "reading_gtests"
    for label, build in BUILDS.items():
        manifest = build / "tests" / (some if label else "gtests")
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


def some_of(names):
    """Of a test with parameters every second, another half of them from one test to the next: a sanitizer takes ten times
    as long as the test itself, and looks at the same code for each. `scripts/test --sanitize` has them all."""
    by_test = {}
    for name in names:
        by_test.setdefault(name.rpartition("/")[0] or name, []).append(name)
    for number, of_one in enumerate(by_test.values()):
        yield from of_one[number % 2::2] if len(of_one) > 1 else of_one


def parameters():
    for label, executable in executables():
        try:
            listing = subprocess.run([executable, "--gtest_list_tests"], stdout=subprocess.PIPE, text=True, timeout=SECONDS)
        except OSError:
            yield pytest.param(executable, None, id=label)
            continue
        names = names_in(listing.stdout)
        if label.startswith("sanitized/") and "SAFETY_CONTROL_SANITIZE" not in os.environ:
            names = some_of(names)
        yield from (pytest.param(executable, name, id=f"{label}/{name}") for name in names)


class Results:
    """Of some tests of one executable, run one after the other in one process: its start takes longer than most tests."""

    def __init__(self, executable, names):
        self.tests = {}  # name: what it printed, and "OK", "SKIPPED" or "FAILED"
        command = [executable, "--gtest_filter=" + ":".join(names)]
        try:
            result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired as late:
            self.output = f"not done after {SECONDS} s\n{(late.stdout or b'').decode(errors='replace')}"
            half = len(names) // 2  # each to its own end, for a sanitizer to have its say
            for some in (names[:half], names[half:]) if half else ():
                self.tests.update(Results(executable, some).tests)
            return
        self.output = f"exit {result.returncode}\n{result.stdout}"
        tests = {name: (said, end) for name, said, end in ENDED.findall(result.stdout)}
        # What a sanitizer finds when all is over is of no test, and so of every one.
        if result.returncode == 0 or "FAILED" in {end for _, end in tests.values()}:
            self.tests = tests

    def judge(self, name):
        said, end = self.tests.get(name, (self.output, "no end"))
        if end == "SKIPPED":
            pytest.skip(" ".join(said.split("\n", 1)[1].split()))  # what GTEST_SKIP() was given, after where it stands
        if end != "OK":
            pytest.fail(f"{end}\n{said}", pytrace=False)


@pytest.fixture(scope="module")
def results(request):
    """executable -> Results of all its tests that are chosen. They know no clock: as many run at once as there are cores."""
    chosen = {}
    for item in request.session.items:
        if item.function is request.module.test_gtest and item.callspec.params["name"]:
            chosen.setdefault(item.callspec.params["executable"], []).append(item.callspec.params["name"])
    slowest_first = sorted(chosen, key=lambda executable: BUILDS["sanitized/"] not in executable.parents)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        running = {executable: pool.submit(Results, executable, chosen[executable]) for executable in slowest_first}
        yield lambda executable: running[executable].result()
        for one in running.values():
            one.cancel()


@pytest.mark.parametrize("executable, name", parameters())
def test_gtest(executable, name, results):
    if name is None:
        pytest.fail(f"{executable} cannot be run; scripts/test builds it", pytrace=False)
    results(executable).judge(name)


def test_the_gtests_are_built():
    built = dict(executables())
    assert any(label.startswith("core/") for label in built)
    assert any(label.startswith("sanitized/core/") for label in built)


def test_a_sanitizer_has_some_of_each_test():
    names = ["Eye.Sees", "As/Eye.Blinks/Left", "As/Eye.Blinks/Right", "As/Eye.Turns/0", "As/Eye.Turns/1", "As/Eye.Turns/2",
             "As/Eye.Closes/0"]

    assert list(some_of(names)) == ["Eye.Sees", "As/Eye.Blinks/Right", "As/Eye.Turns/0", "As/Eye.Turns/2", "As/Eye.Closes/0"]


PROGRAM = """#!/bin/sh
echo "[ RUN      ] Eye.Sees
[       OK ] Eye.Sees (0 ms)
[ RUN      ] All/Eye.Blinks/0
eye_test.cpp:9: Failure
[  FAILED  ] All/Eye.Blinks/0, where GetParam() = 7 (3 ms)
[ RUN      ] Eye.Closes"
exit {exit}
"""


@pytest.mark.parametrize(
    "name, exit, end",
    [
        ("Eye.Sees", 1, None),
        ("Eye.Sees", 0, None),
        ("All/Eye.Blinks/0", 1, "FAILED\neye_test.cpp:9: Failure"),
        ("Eye.Closes", 139, "no end\nexit 139\n[ RUN"),
    ],
)
def test_a_test_is_judged_by_its_own_end(name, exit, end, tmp_path):
    program = tmp_path / "eye_test"
    program.write_text(PROGRAM.format(exit=exit))
    program.chmod(0o755)
    results = Results(program, [name])
    if end is None:
        results.judge(name)
    else:
        with pytest.raises(pytest.fail.Exception, match=re.escape(end)):
            results.judge(name)


def test_what_is_found_when_all_is_over_fails_every_test(tmp_path):
    program = tmp_path / "eye_test"
    program.write_text('#!/bin/sh\necho "[ RUN      ] Eye.Sees\n[       OK ] Eye.Sees (0 ms)\nLeakSanitizer: 8 bytes"; exit 23\n')
    program.chmod(0o755)
    with pytest.raises(pytest.fail.Exception, match="exit 23"):
        Results(program, ["Eye.Sees"]).judge("Eye.Sees")


SLOW_PROGRAM = """#!/bin/sh
case $1 in *:* | *Eye.Closes*) exec sleep 60 ;; esac
name=${1#*=}
echo "[ RUN      ] $name\n[       OK ] $name (0 ms)"
"""


def test_who_is_late_is_asked_for_fewer_at_a_time(tmp_path, monkeypatch):
    monkeypatch.setitem(globals(), "SECONDS", 1)
    program = tmp_path / "eye_test"
    program.write_text(SLOW_PROGRAM)
    program.chmod(0o755)
    results = Results(program, ["Eye.Sees", "Eye.Blinks", "Eye.Closes"])
    for name in ("Eye.Sees", "Eye.Blinks"):
        results.judge(name)
    with pytest.raises(pytest.fail.Exception, match="not done after 1 s"):
        results.judge("Eye.Closes")
