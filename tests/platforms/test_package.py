# SPDX-License-Identifier: BSD-3-Clause
"""scripts/package: what it is told to depend on, and what lies in the .deb that it made. platforms/run installs one."""
import re
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "package"
RUN_TIME = {
    one.text for tag in ("depend", "exec_depend") for one in ElementTree.parse(ROOT / "package.xml").getroot().iter(tag)}
LIBRARIES_ALONE = {"eigen", "libpcl-all-dev"}  # and headers
IN_DEBIAN = 'set -euo pipefail; cd "$1"; . scripts/setup; . scripts/package_parts/depends.sh; run_time_packages '
OF_TESTS = re.compile(r"(^|/)(tests?|conftest\.py|test_[^/]*|[^/]*_test(\.[^/]*)?|[^/]*rostest[^/]*)(/|$)")


def sh(code, *arguments):
    return subprocess.run(
        ["bash", "-c", code, "bash", ROOT, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


@pytest.mark.parametrize("arguments", [["--out"], ["--in", "/tmp"], ["now"]], ids=" ".join)
def test_an_option_that_is_not_known_is_refused(arguments):
    result = subprocess.run([SCRIPT, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)
    assert result.returncode == 2 and result.stderr.startswith("Usage: scripts/package ")


@pytest.mark.parametrize("out", ["/proc/nowhere", "/dev/null"])
def test_a_folder_that_cannot_be_written_is_refused_before_the_build(out):
    result = subprocess.run([SCRIPT, "--no-packages", "--out", out], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)
    assert (result.returncode, result.stderr.splitlines()[-1]) == (2, f"package: cannot write {out}")


@pytest.mark.parametrize("name", sorted(RUN_TIME - LIBRARIES_ALONE))
def test_it_is_known_what_debian_calls_a_package_that_is_wanted_at_run_time(name):
    assert name.startswith("python3-") or sh(f'cd "$1"; . scripts/setup; [[ -v run_time_on_debian[{name}] ]]').returncode == 0


def test_a_package_of_which_nobody_has_said_what_debian_calls_it_ends_the_packing(tmp_path):
    result = sh(IN_DEBIAN.replace("run_time_packages", "unset 'run_time_on_debian[rviz]'; run_time_packages") + "debian12")
    assert result.returncode == 1 and "rviz" in result.stderr


def test_with_a_ros_of_ubuntus_they_bear_the_distributions_name():
    packages = sh(IN_DEBIAN + "one").stdout.split()
    assert {"ros-one-roscpp", "ros-one-robot-state-publisher", "python3-numpy"} <= set(packages)
    assert len(packages) == len(RUN_TIME - LIBRARIES_ALONE)


@pytest.fixture(scope="module")
def made():
    """The .deb that lies where scripts/package puts it."""
    found = sorted((ROOT / "build" / "package" / "deb").glob("*.deb"), key=lambda path: path.stat().st_mtime)
    if not found:
        pytest.skip("no .deb was made: scripts/package")
    return found[-1]


@pytest.fixture(scope="module")
def field(made):
    return lambda name: subprocess.run(["dpkg-deb", "--field", made, name], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()


@pytest.fixture(scope="module")
def unpacked(made, tmp_path_factory):
    folder = tmp_path_factory.mktemp("unpacked")
    subprocess.run(["dpkg-deb", "--extract", made, folder], check=True)
    return folder


@pytest.fixture(scope="module")
def files(unpacked):
    return {str(path.relative_to(unpacked)): path for path in sorted(unpacked.rglob("*")) if path.is_file()}


@pytest.fixture(scope="module")
def prefix(field):
    distribution = re.fullmatch(r"ros-(\w+)-safety-control-cloud", field("Package"))
    assert distribution or field("Package") == "safety-control-cloud"
    return f"opt/ros/{distribution.group(1)}" if distribution else "usr"


def test_its_version_is_the_packages_and_tells_the_release(field):
    version = ElementTree.parse(ROOT / "package.xml").findtext("version")
    release = sh('cd "$1"; . scripts/setup; release').stdout.replace(" ", "").strip()
    assert field("Version") == f"{version}-1~{release}"


def test_it_depends_on_all_that_is_wanted_at_run_time(field, prefix):
    machine = "debian" if prefix == "usr" else prefix.split("/")[-1]
    wanted = set(sh(IN_DEBIAN + machine).stdout.split())
    told = {one.split(" ")[0] for one in field("Depends").split(", ")}
    assert len(wanted) > 10 and wanted - told == set()
    assert {"libc6", "python3"} <= told and any(one.startswith("libpcl-common") for one in told)
    assert [one for one in told if one.endswith("-dev")] == []


@pytest.mark.parametrize("folder", ["config", "launch", "rviz", "urdf", "ros/nodelet.xml"])
def test_what_launch_files_find_is_in_it(folder, files, prefix):
    at = f"{prefix}/share/safety_control_cloud/safety_control_cloud/{folder}"
    assert any(name == at or name.startswith(at + "/") for name in files)


def test_each_program_is_in_it_and_can_be_run(files, prefix):
    installed = re.findall(r"\bscripts/(\w+)", (ROOT / "CMakeLists.txt").read_text())
    for name in (*installed, "safety_control_node"):
        assert files[f"{prefix}/lib/safety_control_cloud/{name}"].stat().st_mode & 0o555 == 0o555


def test_the_nodelet_lies_where_the_systems_pluginlib_looks(files, prefix):
    """Such as rviz's own plugins."""
    beside = [path.parent for path in (Path("/") / prefix / "lib").rglob("librviz_default_plugin.so")]
    if not beside:
        pytest.skip("rviz is not installed here")
    assert [name for name in files if name.endswith("libsafety_control_nodelet.so")] == [f"{beside[0]}/libsafety_control_nodelet.so"[1:]]


def test_nothing_of_the_build_or_the_tests_is_in_it(files):
    assert [name for name in files if OF_TESTS.search(name) or name.endswith((".pyc", ".o", ".a", ".log"))] == []
    outside = [name for name in files if not name.startswith(("usr/", "opt/ros/"))]
    assert outside == []


def test_nothing_of_catkins_own_is_in_it(files):
    """In the prefix of a ROS, each of these belongs to ROS itself."""
    names = {"setup.bash", "setup.sh", "setup.zsh", "local_setup.bash", "_setup_util.py", "env.sh", ".catkin", ".rosinstall"}
    assert [name for name in files if Path(name).name in names] == []


def test_no_file_names_the_folder_in_which_it_was_built(files):
    assert [name for name, path in files.items() if str(ROOT).encode() in path.read_bytes()] == []


def test_a_compiled_file_is_searched_for_its_libraries_where_the_system_has_them(files):
    compiled = [path for path in files.values() if path.read_bytes()[:4] == b"\x7fELF"]
    assert len(compiled) == 3  # node, nodelet, Python module
    for path in compiled:
        told = subprocess.run(["readelf", "--dynamic", path], stdout=subprocess.PIPE, text=True, check=True).stdout
        assert "NEEDED" in told and not re.search(r"R(UN)?PATH", told), told


def test_whoever_installs_it_owns_nothing_and_others_may_read_all(made):
    listing = subprocess.run(["dpkg-deb", "--contents", made], stdout=subprocess.PIPE, text=True, check=True).stdout
    for line in listing.splitlines():
        mode, owner = line.split()[:2]
        assert owner == "root/root" and mode[7] == "r" and mode[5] == mode[8] == "-", line
