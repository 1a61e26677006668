"""The client of Python in any order of calls, as hypothesis chooses them, against the plain model of a client.

python conversations.py COUNT SEED
"""

from __future__ import annotations

import sys
from random import Random
from typing import Any

import driver
import hypothesis
from conformance import client_model, scenarios
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule, run_state_machine_as_test
from mipgen import model as m
from support import model

CHANCES = st.randoms(use_true_random=False)  # hypothesis chooses and shrinks what is drawn from them
WORDS = scenarios.Words(model("real"))
COMMANDS = [f for f in WORDS.of.fields if f.role == m.COMMAND]


class Conversation(RuleBasedStateMachine):
    def __init__(self) -> None:
        super().__init__()
        self.plain = client_model.Client(WORDS.of)
        self.python = driver.Session()

    @initialize(set_=st.sampled_from(sorted({f.set for f in COMMANDS})), data=st.data())
    def begin(self, set_: int, data: st.DataObject) -> None:
        """Few commands, so that a reply may fit several of them."""
        own = st.sampled_from([f for f in COMMANDS if f.set == set_])
        self.set, self.commands = set_, data.draw(st.lists(own, min_size=1, max_size=3))

    def step(self, step: dict[str, Any]) -> None:
        self.python.play([step])
        getattr(self.plain, step["step"])(step)

    @rule(chance=CHANCES)
    def send(self, chance: Random) -> None:
        self.step(WORDS.send(*scenarios.entries(chance, self.commands)))

    @rule(eighths=st.integers(0, 20))
    def wait(self, eighths: int) -> None:
        self.step(scenarios.time(125 * eighths))

    @rule(chance=CHANCES, chunk=st.integers(1, 80))
    def receive(self, chance: Random, chunk: int) -> None:
        part = scenarios.part(chance, WORDS, self.set, list(self.plain.waiting), self.commands)
        self.step(scenarios.receive(part, chunk=chunk))

    @rule(data=st.binary(max_size=40))
    def noise(self, data: bytes) -> None:
        self.step(scenarios.receive(data))

    @rule()
    def end(self) -> None:
        self.step(scenarios.END)

    @invariant()
    def same(self) -> None:
        assert self.python.events == self.plain.events
        assert [self.python.number(c) for c in self.python.client.pending] == [w.number for w in self.plain.waiting]


if __name__ == "__main__":
    count, seed = map(int, sys.argv[1:])
    given = settings(max_examples=count, stateful_step_count=20, deadline=None, database=None,
                     suppress_health_check=list(HealthCheck))  # fmt: skip
    run_state_machine_as_test(hypothesis.seed(seed)(Conversation), settings=given)
    print(f"{count} conversations")
