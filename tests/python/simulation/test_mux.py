# SPDX-License-Identifier: BSD-3-Clause
from pathlib import Path

import pytest
import yaml

from safety_control_cloud.simulation.mux import IDLE, TURTLEBOT_INPUTS, Input, Mux, table_from

SAFETY, TELEOP, SWITCH, NAVI = (one.name for one in TURTLEBOT_INPUTS)
CONFIG = Path(__file__).parents[3] / "safety_control_cloud/config/cmd_vel_mux.yaml"


def test_whoever_comes_first_may_drive():
    mux = Mux()
    assert mux.holder(0.0) == IDLE
    assert mux.passes(NAVI, 0.0)
    assert mux.holder(0.0) == NAVI


@pytest.mark.parametrize("low, high", [(NAVI, SWITCH), (SWITCH, TELEOP), (TELEOP, SAFETY), (NAVI, SAFETY)])
def test_a_higher_priority_takes_over_at_once_and_the_lower_one_waits(low, high):
    mux = Mux()
    assert mux.passes(low, 0.0)
    assert mux.passes(high, 0.01)
    assert not mux.passes(low, 0.02)
    assert mux.holder(0.02) == high


def test_the_holder_may_go_on_however_long():
    mux = Mux()
    assert all(mux.passes(TELEOP, 0.9 * turn) for turn in range(100))


@pytest.mark.parametrize("holder, timeout", [(SAFETY, 0.2), (TELEOP, 1.0), (SWITCH, 1.0), (NAVI, 1.0)])
def test_a_silent_holder_loses_the_mux_after_its_own_timeout(holder, timeout):
    mux = Mux()
    mux.passes(holder, 0.0)
    assert mux.holder(timeout - 0.01) == holder
    assert mux.holder(timeout) == IDLE


def test_a_lower_priority_drives_again_once_the_higher_one_is_silent():
    mux = Mux()
    mux.passes(TELEOP, 0.0)
    mux.passes(SAFETY, 0.05)
    assert not mux.passes(TELEOP, 0.1)
    assert mux.passes(TELEOP, 0.26)


def test_messages_that_do_not_pass_do_not_keep_the_holder_alive():
    mux = Mux()
    mux.passes(SAFETY, 0.0)
    assert not any(mux.passes(NAVI, 0.05 * turn) for turn in range(1, 4))
    assert mux.passes(NAVI, 0.2)


def test_after_the_clock_went_back_nobody_holds_the_mux():
    mux = Mux()
    mux.passes(TELEOP, 100.0)
    assert mux.holder(3.0) == IDLE
    assert mux.passes(NAVI, 3.0)


def test_equal_priority_does_not_take_over():
    mux = Mux([Input("a", "/a", 5, 1.0), Input("b", "/b", 5, 1.0)])
    mux.passes("a", 0.0)
    assert not mux.passes("b", 0.1)


def test_the_configuration_that_comes_with_the_package_is_the_turtlebots_table():
    table = table_from(yaml.safe_load(CONFIG.read_text()))
    assert table.publisher == "/mobile_base/commands/velocity"
    assert len(table.inputs) == len(TURTLEBOT_INPUTS)
    for configured, expected in zip(table.inputs, TURTLEBOT_INPUTS):
        assert (configured.name, configured.priority, configured.timeout) == (
            expected.name, expected.priority, expected.timeout)
        assert "/cmd_vel_mux/" + configured.topic == expected.topic


def test_a_table_is_refused_with_all_that_is_wrong_in_it():
    document = {"subscribers": [
        {"name": "a", "topic": "t", "priority": 1, "timeout": 0},
        {"name": "a", "topic": "t", "priority": 1, "timeout": 1},
        {"name": "no topic"},
        {"name": "b", "topic": "u", "priority": "high", "timeout": 1},
    ]}
    with pytest.raises(ValueError) as refused:
        table_from(document)
    for wrong in ("timeout must be above 0", "name 'a' is there 2", "topic 't'", "priority 1",
                  "subscriber 2", "subscriber 3"):
        assert wrong in str(refused.value)


def test_an_empty_table_is_refused():
    with pytest.raises(ValueError, match="no subscribers"):
        table_from({})
