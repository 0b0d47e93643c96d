# SPDX-License-Identifier: BSD-3-Clause
"""Defaults stand in Settings{} alone; the YAML file and the page beside it only repeat them."""
import re
from pathlib import Path

import pytest
import yaml

from safety_control_cloud import core

ROOT = Path(__file__).resolve().parents[2]
DEFAULTS = core.Settings().as_dict()


def same(repeated, default) -> bool:
    return repeated == default if isinstance(default, (str, bool, list)) else float(repeated) == pytest.approx(default, rel=1e-6)


def assert_repeats_the_defaults(repeated):
    assert set(repeated) == set(DEFAULTS)
    assert [name for name in DEFAULTS if not same(repeated[name], DEFAULTS[name])] == []


def test_the_yaml_file_names_every_parameter_with_its_default():
    assert_repeats_the_defaults(yaml.safe_load((ROOT / "safety_control_cloud/config/default.yaml").read_text()))


def test_the_page_of_the_parameters_names_every_parameter_with_its_default():
    rows = re.findall(r"^\| `~(\w+)` \| `([^`]+)` \|", (ROOT / "safety_control_cloud/config/README.md").read_text(), re.MULTILINE)
    assert_repeats_the_defaults({name: yaml.safe_load(value) for name, value in rows})


def test_the_stub_names_every_parameter():
    stub = (ROOT / "safety_control_cloud/python/safety_control_cloud/core.pyi").read_text()
    settings = stub.split("class Settings:")[1].split("def __init__")[0]
    assert set(re.findall(r"^    (\w+): ", settings, re.MULTILINE)) == set(DEFAULTS)
