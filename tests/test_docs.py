# SPDX-License-Identifier: BSD-3-Clause
"""What the pages say is what the code does: their size, links, parameters, causes, topics and folders."""
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml

ROOT = Path(__file__).resolve().parent.parent
SOURCES = ROOT / "safety_control_cloud"
README = ROOT / "README.md"
PAGES = [README, *sorted(SOURCES.rglob("*.md")), *sorted((ROOT / "tests").rglob("*.md"))]
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
FILE = re.compile(r"`((?:tests|scripts|safety_control_cloud)/[\w./-]+)`")
TEST_FILE = re.compile(r"`(\w+_test\.cpp|test_\w+\.py)`")  # wherever it lies under tests/
LAUNCHED = re.compile(r"roslaunch safety_control_cloud ([^\s`]+)([^\n`#]*)")
MADE_BY_THE_BUILD = ("safety_control_cloud/SafetyState",)

pages = pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))


def anchors_in(page):
    """As GitHub makes them of headings."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading).strip().lower().replace(" ", "-") for heading in headings}


def test_the_readme_is_one_page():
    text = README.read_text()
    assert len(text.splitlines()) <= 110 and len(text.split()) <= 1300


@pages
def test_every_link_leads_somewhere(page):
    for link in LINK.findall(page.read_text()):
        if "://" in link:
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        assert target.exists(), link
        assert not anchor or anchor in anchors_in(target), link


def missing_files(text):
    """Those that a page names and that are not there."""
    yield from (name for name in FILE.findall(text) if name not in MADE_BY_THE_BUILD and not (ROOT / name).exists())
    yield from (name for name in TEST_FILE.findall(text) if not any((ROOT / "tests").rglob(name)))


@pages
def test_every_file_that_is_named_is_there(page):
    assert list(missing_files(page.read_text())) == []


@pytest.mark.parametrize("name", ["tests/core/no_such_test.cpp", "scripts/no_such", "no_such_test.cpp", "test_no_such.py"])
def test_a_file_that_is_named_and_is_not_there_is_found(name):
    assert list(missing_files(f"held by `zone_test.cpp`, `tests/test_docs.py` and `{name}`")) == [name]


@pages
def test_every_page_is_reached_from_the_readme(page):
    seen, waiting = set(), [README]
    while waiting:
        one = waiting.pop()
        if one in seen:
            continue
        seen.add(one)
        for link in LINK.findall(one.read_text()):
            target = (one.parent / link.partition("#")[0]).resolve()
            waiting += [page for page in (target, target / "README.md") if page.suffix == ".md" and page.is_file()]
    assert page in seen


def causes_in_the_core():
    """Number and meaning by name, as SafetyState.msg writes them."""
    found = re.findall(r"^  (\w+) = (\d+),\s+///< (.*)$", (SOURCES / "core/doubt/cause.hpp").read_text(), re.MULTILINE)
    return {re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).upper(): (int(number), meaning) for name, number, meaning in found}


def test_the_message_has_the_cores_causes_with_their_numbers_and_meanings():
    text = (ROOT / "msg/SafetyState.msg").read_text().split("DANGER=0")[1]
    found = re.findall(r"^uint8 (\w+)=(\d+)\s+# (.*)$", text, re.MULTILINE)
    assert {name: (int(number), meaning) for name, number, meaning in found} == causes_in_the_core()


def test_python_has_the_cores_causes():
    from safety_control_cloud import core

    members = {name: int(getattr(core.Cause, name)) for name in causes_in_the_core()}
    assert members == {name: number for name, (number, _) in causes_in_the_core().items()}
    assert set(core.Cause.__members__) == set(members)


def test_the_stub_has_the_cores_causes():
    stub = (SOURCES / "python/safety_control_cloud/core.pyi").read_text()
    cause = stub.split("class Cause:")[1].split("\nclass ")[0]
    assert set(re.findall(r"^    ([A-Z_]+): Cause$", cause, re.MULTILINE)) == set(causes_in_the_core())


def test_the_readme_names_every_cause_and_the_design_explains_each():
    told = README.read_text().split("| else | Danger | 0 |")[1].split("[What each means]")[0]
    assert set(re.findall(r"\b[A-Z]+(?:_[A-Z]+)*\b", told)) == set(causes_in_the_core())
    rows = re.findall(r"^\| ([A-Z_, ]+) \|", (SOURCES / "README.md").read_text(), re.MULTILINE)
    assert {name for row in rows for name in row.split(", ")} == set(causes_in_the_core())


@pytest.mark.parametrize("file", ["ros/output/diagnostics.cpp", "ros/output/messages.cpp", "ros/output/reports.cpp"])
def test_what_is_published_of_a_cause_is_the_cores_name(file):
    assert re.search(r"name_of\(decision_?\.cause\)", (SOURCES / file).read_text())


def test_the_readmes_topics_are_the_nodes():
    table = README.read_text().split("## Topics")[1].split("\n## ")[0] + (SOURCES / "GUARD.md").read_text()
    told = set(re.findall(r"^\| (?:in|out|service) \| `[~/]?([\w/]+)` \|", table, re.MULTILINE))
    sources = "".join(path.read_text() for path in sorted((SOURCES / "ros").rglob("*.cpp")))
    made = set(re.findall(r'(?:named_in\(handle, |(?:advertise(?:Service)?|subscribe)(?:<[\w:]+>)?\(\s*)"([\w/]+)"', sources))
    made |= set(re.findall(r'"(camera/depth/\w+)"', sources)) | {"tf", "diagnostics"}  # by libraries
    assert told == made


def test_the_readmes_parameters_have_the_defaults_that_it_says():
    from safety_control_cloud import core

    rows = re.findall(r"^\| `~(\w+)` \| `([^`]+)` \|", README.read_text(), re.MULTILINE)
    assert len(rows) == 6
    for name, value in rows:
        assert yaml.safe_load(value) == pytest.approx(core.Settings().as_dict()[name])


@pages
def test_every_parameter_that_a_page_sets_exists(page):
    from safety_control_cloud import core

    known = {*core.Settings().as_dict(), "image_transport"}
    named = re.findall(r"`_?(\w+): [-\d.\w]+`", page.read_text()) + re.findall(r"`~([a-z_]+)(?:[:=][^`]*)?`", page.read_text())
    topics = {"override", "state", "blocked", "markers", "reset", "active", "contacts"}
    assert set(named) - known - topics == set()


def wrong_launches(text):
    """Launch files that a page starts and that are not there, and arguments that they do not declare."""
    for name, given in LAUNCHED.findall(text):
        launch = SOURCES / "launch" / name
        if not launch.is_file():
            yield name
            continue
        declared = {arg.get("name") for arg in ElementTree.parse(launch).getroot().findall("arg")}
        yield from (f"{name} {argument}" for argument in re.findall(r"(\w+):=", given) if argument not in declared)


@pages
def test_every_launch_file_that_a_page_starts_takes_the_arguments_that_it_is_given(page):
    assert list(wrong_launches(page.read_text())) == []


@pytest.mark.parametrize("command, wrong", [
    ("guard.launch mux:=false base:=/cmd_vel  # x:=y", []),
    ("guard.launch mux:=false bass:=/cmd_vel", ["guard.launch bass"]),
    ("demo.launch mux:=false", ["demo.launch mux"]),  # it gives that to a file that it includes
    ("gard.launch", ["gard.launch"]),
])
def test_a_launch_that_would_not_start_is_found(command, wrong):
    assert list(wrong_launches(f"```sh\nroslaunch safety_control_cloud {command}\n```")) == wrong


def test_every_folder_has_its_line():
    design = (SOURCES / "README.md").read_text()
    table = design.split("| folder |")[1].split("\n\n")[0]
    for folder in ("core", "ros", "python"):
        assert f"`safety_control_cloud/{folder}`" in table


def test_the_example_of_the_python_page_runs():
    page = (SOURCES / "python/README.md").read_text()
    code = re.search(r"```python\n(.*?)```", page, re.DOTALL).group(1)
    printed = []
    exec(code.replace("print(", "printed.append("), {"printed": printed})  # noqa: S102
    assert printed[0].nearest.distance == pytest.approx(0.8)
    assert repr(printed[0]).startswith("Decision(zone=Warning, speed=0.1, cause=SEEN, nearest=Obstacle(distance=0.800")
