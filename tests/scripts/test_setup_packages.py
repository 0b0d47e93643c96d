# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/setup asks of apt: the real one, on a repository and lists of the test's own; only the install is acted."""
import shutil
import subprocess
from pathlib import Path

import pytest

SETUP = Path(__file__).resolve().parents[2] / "scripts" / "setup"
COMPILER = "g++-aarch64-linux-gnu"  # whose name is no regular expression for itself
OPTIONAL = "libhwy-dev"
DEBIANS = ("debian11", "debian12", "debian13")

APT_GET = """#!/bin/bash
case " $* " in
  *" update "*) echo update >>"{folder}/asked"; exec {apt_get} "$@" ;;
  *" install "*) for package in "${{@:6}}"; do echo "installed $package"; done | tee -a "{folder}/dpkg" >>"{folder}/asked" ;;
esac
"""
COMMANDS = {
    "apt-get": APT_GET,
    "dpkg-query": '#!/bin/bash\ncat "{folder}/dpkg"\n',
    "sudo": '#!/bin/bash\nif [[ $1 == -n ]]; then shift; fi\nexec "$@"\n',
}
RUN = 'source "$1"; machine() { echo debian12; }; root=$PWD log=$PWD/build/setup.log checks=yes; install_packages'

pytestmark = pytest.mark.skipif(shutil.which("apt-get") is None, reason="apt is not installed")


class Machine:
    """One with all packages but some; its apt knows those that `offer` names."""

    def __init__(self, folder):
        self._folder = folder
        for name in ("bin", "build", "repository", "apt/state/lists/partial", "apt/cache/archives/partial"):
            (folder / name).mkdir(parents=True)
        for name, text in COMMANDS.items():
            (folder / "bin" / name).write_text(text.format(folder=folder, apt_get=shutil.which("apt-get")))
            (folder / "bin" / name).chmod(0o755)
        (folder / "sources.list").write_text(f"deb [trusted=yes] file:{folder}/repository ./\n")
        (folder / "apt.conf").write_text(
            f'Dir::State "{folder}/apt/state";\nDir::State::status "{folder}/status";\nDir::Cache "{folder}/apt/cache";\n'
            f'Dir::Etc::sourcelist "{folder}/sources.list";\nDir::Etc::sourceparts "-";\nAPT::Sandbox::User "";\n')
        (folder / "status").touch()

    def offers(self, *packages):
        fields = "Version: 1\nArchitecture: all\nMaintainer: a test\nFilename: ./a.deb\nSize: 1\nSHA256: " + 64 * "0"
        (self._folder / "repository" / "Packages").write_text("".join(f"Package: {name}\n{fields}\n\n" for name in packages))

    def lacks(self, *packages):
        needed = subprocess.run(
            ["bash", "-c", 'source "$1"; checks=yes; needed_packages debian12', "bash", SETUP], stdout=subprocess.PIPE, text=True, check=True)
        there = sorted(set(needed.stdout.split()) - set(packages))
        (self._folder / "dpkg").write_text("".join(f"installed {name}\n" for name in there))

    def asked_by_setup(self):
        """What apt-get was asked by one call of setup: "update", "installed PACKAGE"."""
        (self._folder / "asked").write_text("")
        environment = {"PATH": f"{self._folder / 'bin'}:/usr/bin:/bin", "APT_CONFIG": str(self._folder / "apt.conf")}
        result = subprocess.run(
            ["bash", "-c", RUN, "bash", SETUP], cwd=self._folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        assert result.returncode == 0, result.stdout
        return (self._folder / "asked").read_text().splitlines()


@pytest.fixture
def machine(tmp_path):
    return Machine(tmp_path)


def test_a_package_with_a_plus_in_its_name_is_installed(machine):
    machine.lacks(COMPILER)
    machine.offers(COMPILER)
    assert machine.asked_by_setup() == ["update", f"installed {COMPILER}"]
    assert machine.asked_by_setup() == []


def test_a_package_that_this_release_does_not_have_is_asked_for_once(machine):
    machine.lacks(COMPILER, OPTIONAL)
    machine.offers(COMPILER)
    assert machine.asked_by_setup() == ["update", f"installed {COMPILER}"]
    assert machine.asked_by_setup() == []


def test_another_package_that_goes_missing_is_installed_all_the_same(machine):
    machine.lacks(OPTIONAL)
    machine.offers(COMPILER)
    assert machine.asked_by_setup() == ["update"]
    machine.lacks(COMPILER, OPTIONAL)
    assert machine.asked_by_setup() == ["update", f"installed {COMPILER}"]


def test_a_package_that_is_needed_is_asked_for_though_apt_does_not_know_it(machine):
    machine.lacks("cmake")
    machine.offers(COMPILER)
    assert machine.asked_by_setup() == ["update", "installed cmake"]


def test_nothing_is_asked_of_apt_where_nothing_is_missing(machine):
    machine.lacks()
    assert machine.asked_by_setup() == []


@pytest.mark.parametrize("release", ["debian 11", "debian 12", "debian 13"])
def test_a_debian_is_known_by_its_release(release):
    assert told(f'release() {{ echo "{release}"; }}; ros_folders=(); machine') == [release.replace(" ", "")]


@pytest.mark.parametrize("distribution", ["noetic", "one"])
def test_a_machine_with_ubuntus_ros_is_known_by_it_and_its_packages_bear_its_name(distribution, tmp_path):
    (tmp_path / distribution).mkdir()
    (tmp_path / distribution / "setup.bash").touch()
    assert told(f"ros_folders=({tmp_path}/noetic {tmp_path}/one); machine") == [distribution]
    needed = told(f"needed_packages {distribution}")
    assert f"ros-{distribution}-pcl-ros" in needed and f"ros-{distribution}-rostest" in needed
    assert not any(name.startswith("ros-core") for name in needed)


def test_each_debian_has_the_sanitizers_of_its_own_clang():
    found = {name: [package for package in told(f"needed_packages {name}") if "clang-rt" in package] for name in DEBIANS}
    assert found == {"debian11": [], "debian12": ["libclang-rt-14-dev"], "debian13": ["libclang-rt-dev"]}


def test_a_machine_that_is_not_known_is_told_what_is_needed(tmp_path):
    (tmp_path / "build").mkdir()
    run = 'release() { echo fedora 42; }; ros_folders=(); install_packages'
    result = sourced(f"cd {tmp_path}; {run}", check=False)
    assert result.returncode == 1 and "fedora 42" in result.stderr and "libpcl-dev" in result.stderr


def sourced(commands, check=True):
    return subprocess.run(
        ["bash", "-c", f'source "$1"; checks=yes; {commands}', "bash", SETUP], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        check=check)


def told(commands):
    return sourced(commands).stdout.split()
