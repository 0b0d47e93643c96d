# SPDX-License-Identifier: BSD-3-Clause
"""A simulated robot that is put elsewhere tells the node, which remembers what was near."""
from queue import Queue
from types import SimpleNamespace

import pytest
import rospy

from safety_control_cloud.nodes import node_memory


@pytest.fixture
def asked(monkeypatch):
    """The node's answers, by which it is asked: True, False, or an exception."""
    answers, calls = Queue(), Queue()

    def reset():
        calls.put("reset")
        answer = answers.get_nowait() if not answers.empty() else True
        if isinstance(answer, Exception):
            raise answer
        return SimpleNamespace(success=answer)

    monkeypatch.setattr(node_memory.rospy, "ServiceProxy", lambda name, kind: reset)
    monkeypatch.setattr(node_memory, "_UNDER_WAY", 0.01)
    monkeypatch.setattr(node_memory, "_ONCE_IN", 0.01)
    return answers, calls


def test_the_nodes_memory_is_reset_once_for_every_new_place(asked):
    _, calls = asked
    memory = node_memory.NodeMemory()
    for _ in range(2):
        memory.forget()
        assert calls.get(timeout=5) == "reset"


def test_a_node_that_refuses_because_it_has_just_forgotten_is_asked_again(asked):
    answers, calls = asked
    answers.put(False)
    node_memory.NodeMemory().forget()
    assert [calls.get(timeout=5) for _ in range(2)] == ["reset", "reset"]


def test_without_a_node_the_simulator_goes_on(asked):
    answers, calls = asked
    answers.put(rospy.ServiceException("no such service"))
    memory = node_memory.NodeMemory()
    memory.forget()
    calls.get(timeout=5)
    memory.forget()
    assert calls.get(timeout=5) == "reset"
