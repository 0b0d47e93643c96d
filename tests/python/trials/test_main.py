# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import pytest
from rich.console import Console

from safety_control_cloud.trials import names
from safety_control_cloud.trials.families import FAMILIES
from safety_control_cloud.trials.options import options
from safety_control_cloud.trials.replay import replay


def test_every_family_can_be_asked_for_by_name():
    assert names.FAMILIES == tuple(FAMILIES)


def test_a_drive_to_replay_is_named_by_family_and_seed():
    assert options(["--replay", "wall:7"]).replay == ("wall", 7)


@pytest.mark.parametrize(
    "arguments", [["--replay", "wall"], ["--replay", "nowhere:1"], ["--jobs", "0"], ["--video", "a.gif"], ["--family", "x"]]
)
def test_what_cannot_be_driven_is_refused(arguments, capsys):
    with pytest.raises(SystemExit) as ended:
        options(arguments)
    assert ended.value.code == 2
    assert "usage" in capsys.readouterr().err


def test_a_drive_is_told_and_filmed(tmp_path):
    console = Console(record=True, width=130)
    replay("wall_in_the_blind_zone", 1, ["tutorial"], tmp_path / "out.gif", console)
    told = console.export_text()
    assert "wall_in_the_blind_zone:1" in told and "end" in told
    assert (tmp_path / "out.gif").stat().st_size > 10_000
