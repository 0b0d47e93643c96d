# SPDX-License-Identifier: BSD-3-Clause
"""A command that lacks its packages says what to do about it."""
from importlib import import_module
from types import SimpleNamespace

import pytest

from safety_control_cloud import optional


@pytest.fixture(autouse=True)
def nothing_installed(monkeypatch):
    monkeypatch.setattr(optional, "find_spec", lambda name: None)


def test_it_names_the_command_that_installs_them():
    with pytest.raises(optional.MissingPackages, match="needs rosbags, rich, pyarrow, xxhash: scripts/setup --with judge"):
        optional.require("judge")


@pytest.mark.parametrize("command, arguments, missing", [
    ("replay", ["ok.bag"], "rosbags, rich"), ("demo", [], "rich"), ("demo", ["guard"], "rich"), ("trials", [], "rich, mujoco")])
def test_a_command_whose_packages_every_setup_installs_names_them_in_a_line(command, arguments, missing, monkeypatch, tmp_path, capsys):
    main = import_module(f"safety_control_cloud.{command}.__main__").main
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", [command, *arguments])
    assert main(*[arguments] * (command == "demo")) == 2
    assert capsys.readouterr().err == f"{command}: this needs {missing}: scripts/setup, or pip where the package is installed\n"
    assert list(tmp_path.iterdir()) == []


def test_it_names_the_python_that_no_command_installs(monkeypatch):
    monkeypatch.setattr(optional, "sys", SimpleNamespace(version_info=(3, 8, 10), version="3.8.10 (default)"))
    with pytest.raises(optional.MissingPackages, match="rerun, and these Python 3.11 or newer: this is 3.8.10"):
        optional.require("view")
