# SPDX-License-Identifier: BSD-3-Clause
"""A command that lacks its packages says what to do about it."""
from types import SimpleNamespace

import pytest

from safety_control_cloud import optional


@pytest.fixture(autouse=True)
def nothing_installed(monkeypatch):
    monkeypatch.setattr(optional, "find_spec", lambda name: None)


def test_it_names_the_command_that_installs_them():
    with pytest.raises(optional.MissingPackages, match="needs rosbags, rich, pyarrow, xxhash: scripts/setup --with judge"):
        optional.require("judge")


def test_it_names_the_python_that_no_command_installs(monkeypatch):
    monkeypatch.setattr(optional, "sys", SimpleNamespace(version_info=(3, 8, 10), version="3.8.10 (default)"))
    with pytest.raises(optional.MissingPackages, match="rerun, and these Python 3.11 or newer: this is 3.8.10"):
        optional.require("view")
