# SPDX-License-Identifier: BSD-3-Clause
"""No file leans on the headers that CMakeLists.txt has parsed once for all: each would compile without them."""
import re
from functools import lru_cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
HOUSES = [ROOT / "safety_control_cloud" / house for house in ("core", "ros")]
LISTS = re.compile(r"^set\(PARSED_ONCE_IN_CORE (.*)\)$|^safety_control_precompile\(safety_control_ros (.*)\)$", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
COMMENT = re.compile(r"//.*")

ALGORITHMS = "all_of|any_of|clamp|copy|copy_n|count_if|equal|fill|find|find_if|lower_bound|max|max_element|min|min_element|" \
    "none_of|nth_element|partition|remove_if|replace|reverse|rotate|sort|stable_sort|transform|unique|upper_bound"
# What is taken from each of them, and where else it may come from.
TAKEN = {
    "algorithm": rf"\bstd::({ALGORITHMS})\(",
    "functional": r"\bstd::(function|ref|cref|hash|less|greater)\b",
    "map": r"\bstd::(multi)?map\b",
    "optional": r"\bstd::(optional|nullopt|make_optional)\b",
    "string": r"\bstd::(string|to_string)\b",
    "variant": r"\bstd::(variant|visit|get_if|holds_alternative|monostate)\b",
    "vector": r"\bstd::vector\b",
    "pcl/point_cloud.h": r"\bpcl::PointCloud\b",
    "pcl/point_types.h": r"\bpcl::PointXYZ\b",
    "ros/ros.h": r"\bros::\w",
    "sensor_msgs/PointCloud2.h": r"\bsensor_msgs::PointCloud2",
}
ELSEWHERE = {"ros/ros.h": re.compile(r"ros/|nodelet/|\w+_msgs/")}  # each brings what of it one has to know there


def parsed_once():
    found = LISTS.findall((ROOT / "CMakeLists.txt").read_text().replace("${PARSED_ONCE_IN_CORE} ", ""))
    return {header for line in found for header in " ".join(line).split()}


@lru_cache(maxsize=None)
def reached(file):
    """What a file includes in angle brackets, itself or over others of the package."""
    found = set()
    for bracket, name in INCLUDE.findall(file.read_text()):
        other = (file.parent / name).resolve()
        if bracket == "<":
            found.add(name)
        elif other.exists():
            found |= reached(other)
    return frozenset(found)


def missing_in(file):
    """The headers that a file uses and does not reach."""
    text = COMMENT.sub("", file.read_text())
    for header, use in TAKEN.items():
        brings = ELSEWHERE.get(header, re.compile(re.escape(header) + "$"))
        if re.search(use, text) and not any(map(brings.match, reached(file))):
            yield header


def test_all_headers_that_are_parsed_once_are_looked_for():
    assert parsed_once() == set(TAKEN)


@pytest.mark.parametrize("house", HOUSES, ids=lambda house: house.name)
def test_every_file_includes_what_it_uses(house):
    missing = {str(file.relative_to(ROOT)): list(missing_in(file)) for file in sorted(house.rglob("*.[ch]pp"))}
    assert len(missing) > 50
    assert {file: headers for file, headers in missing.items() if headers} == {}


def test_what_is_missing_is_found(tmp_path):
    (tmp_path / "eye.hpp").write_text("#include <optional>\n// std::map\n")
    eye = tmp_path / "eye.cpp"
    eye.write_text('#include "eye.hpp"\nstd::optional<int> a;\nstd::vector<int> b;\nros::Time c;\n')
    assert list(missing_in(eye)) == ["vector", "ros/ros.h"]
