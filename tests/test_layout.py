# SPDX-License-Identifier: BSD-3-Clause
"""Folder = permission: what a C++ file may include follows from where it lies. tests/test_imports.py has the Python ones."""
import re

import pytest
from tree import CORE, SOURCES, files

# What each room may include beside itself; what lies straight in core/ or ros/ may include all of them. No arrow leads
# back up: whoever adds one that is missing here has found a new idea, or a mistake.
ROOMS_OF_CORE = {
    "text": set(),
    "input": {"text"},
    "look": {"text", "input"},
    "look/kernel": {"input", "look"},
    "look/without_highway/hwy": set(),
    "doubt": {"text", "input"},
    "memory": {"text", "input", "look", "doubt", "memory/kernel"},
    "memory/kernel": {"look"},
    "path": set(),
    "speed": {"text", "path"},
    "guard": {"text", "input", "look", "doubt", "memory", "path", "speed"},
}
KERNEL_OF_LOOK = "look/look.cpp"  # the one door from the room into its kernel
ROOMS_OF_ROS = {
    "time": set(), "graph": {"time"}, "command": {"time", "graph"}, "input": {"time", "graph"}, "memory": {"time"}, "output": {"time"},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD = re.compile(r"[a-z_0-9]+")  # <vector>, <cmath>: neither folder nor ending
OWN_LIBRARIES = ("Eigen/", "pcl/", "hwy/")
OF_PROCESSORS = ("arm_neon.h", "cpuid.h", "immintrin.h")  # the compiler's own
MADE_OF_THE_STUB = "docstrings.hpp"  # by the build
READS_A_CLOCK_OR_DOES_IO = {
    *("chrono", "ctime", "thread"),
    *("cstdio", "filesystem", "fstream", "iostream"),
}
IO_OF_PCL = ("pcl/console/", "pcl/io/", "pcl/visualization/")

def forbidden_in_core(file):
    """What a file of core/ includes beside the standard library, Eigen, PCL, Highway and core/ itself."""
    for bracket, name in INCLUDE.findall(file.read_text()):
        if bracket == '"':
            if CORE not in (file.parent / name).resolve().parents:
                yield name
        elif name in READS_A_CLOCK_OR_DOES_IO or name.startswith(IO_OF_PCL):
            yield name
        elif not STANDARD.fullmatch(name) and not name.startswith(OWN_LIBRARIES) and name not in OF_PROCESSORS:
            yield name


def room_of(file, house):
    """The room that a file lies in, as "look/kernel"; "" if it lies straight in the house."""
    return "/".join(file.relative_to(house).parts[:-1])


def own_includes(file, house):
    """The files of this house that a file of it includes."""
    for bracket, name in INCLUDE.findall(file.read_text()):
        target = (file.parent / name).resolve()
        if bracket == '"' and house in target.parents:
            yield target


def forbidden_between_rooms(file, house, rooms):
    """The files that a file includes from rooms that its own may not know."""
    room = room_of(file, house)
    for target in own_includes(file, house):
        other = room_of(target, house)
        door = other == "look/kernel" and str(file.relative_to(house)) == KERNEL_OF_LOOK
        if room and other != room and other not in rooms[room] and not door:
            yield str(target.relative_to(house))


def unit_of(file):
    """A header and its source are one: look/look.hpp and look/look.cpp."""
    return str(file.with_suffix(""))


def circles_in(house):
    """Units that include each other, over however many others."""
    arrows = {}
    for file in house.rglob("*.[ch]pp"):
        arrows.setdefault(unit_of(file), set()).update(unit_of(target) for target in own_includes(file, house))
    found, done = [], set()

    def walk(unit, path):
        if unit in path:
            found.append([*path[path.index(unit):], unit])
        if unit in path or unit in done:
            return
        for other in sorted(arrows.get(unit, set()) - {unit}):
            walk(other, [*path, unit])
        done.add(unit)

    for unit in sorted(arrows):
        walk(unit, [])
    return found


def includes_of(file, house):
    """All files of a house that a file includes, itself or over others."""
    seen, waiting = set(), [file]
    while waiting:
        for target in own_includes(waiting.pop(), house):
            if target not in seen:
                seen.add(target)
                waiting.append(target)
    return seen


def forbidden_in_bindings(file):
    """The binding is the core's: pybind11 and the core, no ROS."""
    for bracket, name in INCLUDE.findall(file.read_text()):
        if bracket == '"':
            if not {CORE, file.parent} & set((file.parent / name).resolve().parents):
                yield name
        elif not STANDARD.fullmatch(name) and not name.startswith(("pybind11/", MADE_OF_THE_STUB, *OWN_LIBRARIES)):
            yield name


@pytest.mark.parametrize("file", files(CORE, ".hpp", ".cpp"))
def test_the_core_knows_no_ros_no_clock_and_no_io(file):
    assert list(forbidden_in_core(file)) == []


HOUSES = {CORE: ROOMS_OF_CORE, SOURCES / "ros": ROOMS_OF_ROS}


@pytest.mark.parametrize("file", files(CORE, ".hpp", ".cpp") + files(SOURCES / "ros", ".hpp", ".cpp"))
def test_a_room_knows_only_the_rooms_below_it(file):
    house = next(house for house in HOUSES if house in file.parents)
    assert list(forbidden_between_rooms(file, house, HOUSES[house])) == []


def test_a_change_in_a_room_leaves_the_ros_parameters_alone_unless_it_is_one_of_settings():
    known = includes_of(SOURCES / "ros" / "parameters.cpp", SOURCES)
    assert {path.name for path in known if "memory" in path.parts or "doubt" in path.parts} == {"settings.hpp"}


@pytest.mark.parametrize("house", HOUSES, ids=lambda house: house.name)
def test_every_room_of_a_house_is_in_its_table(house):
    assert {room_of(file, house) for file in house.rglob("*.[ch]pp")} - {""} == set(HOUSES[house])


@pytest.mark.parametrize("house", HOUSES, ids=lambda house: house.name)
def test_no_unit_includes_itself_over_others(house):
    assert circles_in(house) == []


@pytest.mark.parametrize(
    "place, line, forbidden",
    [
        ("input/view.hpp", '#include "../look/sight.hpp"', ["look/sight.hpp"]),
        ("speed/zone.cpp", '#include "../memory/loss.hpp"', ["memory/loss.hpp"]),
        ("look/nearest.cpp", '#include "kernel/scan.hpp"', ["look/kernel/scan.hpp"]),
        ("look/look.cpp", '#include "kernel/scan.hpp"', []),
        ("memory/near_loss.hpp", '#include "../settings.hpp"', ["settings.hpp"]),
        ("memory/near_loss.hpp", '#include "../look/sight.hpp"', []),
        ("sensor.hpp", '#include "memory/near_loss.hpp"', []),
    ],
)
def test_an_include_between_rooms_that_is_not_allowed_is_found(place, line, forbidden, tmp_path):
    file = tmp_path / place
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(f"#pragma once\n#include <vector>\n{line}\n")
    assert list(forbidden_between_rooms(file, tmp_path, ROOMS_OF_CORE)) == forbidden


def test_a_circle_of_units_is_found(tmp_path):
    for name, line in {"a.hpp": "", "a.cpp": '#include "b.hpp"', "b.hpp": '#include "c.hpp"', "c.hpp": '#include "a.hpp"'}.items():
        (tmp_path / name).write_text(line + "\n")
    assert len(circles_in(tmp_path)) == 1


@pytest.mark.parametrize("file", files(SOURCES / "python", ".hpp", ".cpp"))
def test_the_binding_knows_the_core_alone(file):
    assert list(forbidden_in_bindings(file)) == []


@pytest.mark.parametrize(
    "line, name",
    [
        ("#include <ros/ros.h>", "ros/ros.h"),
        ("#include <pcl_ros/point_cloud.h>", "pcl_ros/point_cloud.h"),
        ("#include <pcl/io/pcd_io.h>", "pcl/io/pcd_io.h"),
        ('  #  include "../ros/messages.hpp"', "../ros/messages.hpp"),
        ("#include <chrono>", "chrono"),
        ("#include <unistd.h>", "unistd.h"),
    ],
)
def test_an_include_that_the_core_may_not_have_is_found(line, name, tmp_path):
    file = tmp_path / "file.hpp"
    file.write_text(f"#pragma once\n#include <vector>\n#include <pcl/point_types.h>\n{line}\n")
    assert list(forbidden_in_core(file)) == [name]
