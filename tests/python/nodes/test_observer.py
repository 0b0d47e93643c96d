# SPDX-License-Identifier: BSD-3-Clause
"""How the rostests of the whole stack look on, on a computer that is too slow for it."""
from types import SimpleNamespace

import observer
import pytest


@pytest.mark.parametrize("draws_slowly, zones", [
    (True, ["Safe", "Warning", "Danger"]),
    (False, ["Safe", "Danger", "Safe", "Warning", "Danger"]),
])
def test_only_between_pictures_that_come_slowly_a_silent_zone_is_none_that_was_seen(draws_slowly, zones):
    said = [("Safe", "SEEN"), ("Danger", "SILENT"), ("Safe", "SEEN"), ("Warning", "SEEN"), ("Danger", "SILENT"), ("Danger", "SEEN")]
    states = [SimpleNamespace(zone_text=zone, cause_text=cause) for zone, cause in said]
    assert observer.Observer.zones.fget(SimpleNamespace(states=states, draws_slowly=draws_slowly)) == zones


def times(monkeypatch, simulated, real):
    """The clocks go on by so much [s] at each turn."""
    clock = SimpleNamespace(simulated=0.0, real=0.0)

    def sleep(seconds):
        clock.simulated, clock.real = clock.simulated + simulated, clock.real + real

    monkeypatch.setattr(observer.rospy, "get_time", lambda: clock.simulated)
    monkeypatch.setattr(observer, "time", SimpleNamespace(monotonic=lambda: clock.real, sleep=sleep))
    return clock


def test_a_slow_simulator_is_waited_for(monkeypatch):
    clock = times(monkeypatch, simulated=0.01, real=1.0)
    observer.Observer.until(None, "it stands", lambda: clock.simulated > 5.0, seconds=10.0)
    assert clock.real > 400


@pytest.mark.parametrize("simulated, real", [(0.1, 0.1), (0.0, 0.1)], ids=["goes on", "stands still"])
def test_what_never_comes_is_not_waited_for_for_ever(monkeypatch, simulated, real):
    times(monkeypatch, simulated, real)
    with pytest.raises(AssertionError, match="in vain: it stands"):
        observer.Observer.until(None, "it stands", lambda: False, seconds=10.0)
