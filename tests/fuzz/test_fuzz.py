# SPDX-License-Identifier: BSD-3-Clause
"""Twenty seconds of each fuzzer, the same at each run; SAFETY_CONTROL_FUZZ=600 makes them ten minutes of inputs never tried.

Their corpora stay in build/fuzz, so that the next run goes on. What breaks a promise is printed so that another
machine can try it: base64 -d <<< TEXT > input; decide_fuzz input (or guard_fuzz).
"""
import base64
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "fuzz"
SECONDS = int(os.environ.get("SAFETY_CONTROL_FUZZ", "20"))
SEED = 0 if "SAFETY_CONTROL_FUZZ" in os.environ else 1  # 0: another one at each run
FUZZERS = ("decide_fuzz", "guard_fuzz")
PYTHON = "/usr/bin/python3"  # ROS's own, see scripts/setup


def run(*command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)


def broken_by(told: str) -> str:
    """The sentence that does not hold, and the input."""
    said = re.findall(r"^(?:not so: .*|.*ERROR: .*|SUMMARY: .*)$", told, re.MULTILINE)
    written = re.search(r"Test unit written to (\S+)", told)
    unit = base64.b64encode(Path(written[1]).read_bytes()).decode() if written else told[-4000:]
    return "\n".join([*said, unit])


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """The folder of the fuzzer and of what writes its seeds."""
    if shutil.which("clang++") is None:
        pytest.skip("clang is not installed (scripts/setup --checks installs it)")
    source = tmp_path_factory.mktemp("fuzz") / "nothing.cpp"
    source.write_text('extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }')
    linked = run("clang++", "-fsanitize=fuzzer,address", source, "-o", source.with_suffix(""))
    if linked.returncode != 0:
        pytest.skip("clang has no libFuzzer (scripts/setup --checks installs it): " + linked.stdout)
    configure = run(
        "cmake", "-S", ROOT, "-B", BUILD, "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1 -gline-tables-only",
        "-DCMAKE_CXX_COMPILER=clang++", "-DSAFETY_CONTROL_FUZZ=ON", "-DSAFETY_CONTROL_SANITIZE=address,undefined",
        "-DCATKIN_ENABLE_TESTING=OFF", "-DSAFETY_CONTROL_PRECOMPILE=ON",
        f"-DPython3_EXECUTABLE={PYTHON}", f"-DPYTHON_EXECUTABLE={PYTHON}",
        env={**os.environ, "PATH": "/usr/bin:" + os.environ["PATH"]})
    assert configure.returncode == 0, configure.stdout
    build = run("cmake", "--build", BUILD, "--target", *FUZZERS, "fuzz_seeds", "-j2")
    assert build.returncode == 0, build.stdout
    return BUILD / "devel" / "lib" / "safety_control_cloud"


@pytest.mark.slow
@pytest.mark.parametrize("fuzzer", FUZZERS)
def test_no_input_breaks_a_promise(programs, tmp_path, fuzzer):
    corpus, seeds = BUILD / "corpus" / fuzzer, {each: tmp_path / each for each in FUZZERS}
    for folder in (corpus, *seeds.values()):
        folder.mkdir(parents=True, exist_ok=True)
    assert run(programs / "fuzz_seeds", *seeds.values()).returncode == 0
    fuzzing = run(
        programs / fuzzer, f"-seed={SEED}", f"-max_total_time={SECONDS}", "-timeout=10", "-max_len=8192", "-rss_limit_mb=3000",
        "-print_final_stats=1", f"-artifact_prefix={BUILD}/", corpus, seeds[fuzzer], timeout=SECONDS + 120)
    print("\n".join(line for line in fuzzing.stdout.splitlines() if "DONE" in line or "stat::" in line))
    assert fuzzing.returncode == 0, broken_by(fuzzing.stdout)
