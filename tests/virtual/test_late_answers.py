"""Late answers: what is written and read back is never the value of an earlier command, in any language."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from conformance.client_model import TIMEOUT, Client
from support import model, rounds, uses
from virtual.commands import Trial, commands
from virtual.session import Session, Witness
from virtual.test_clients import device, repeat

pytestmark = uses()  # the clients at hand

#: In seconds: up to 2.4 times the time-out, as 0.6 s are to 0.25 s.
LATE = (0.15, 2.4 * TIMEOUT / 1000)

NAME = "3dm-cv7-gnss-ins"

#: The device has the first two sets, and refuses the last one.
SETS = (0x80, 0x82, 0x7E)


class Pairs:
    """Writes a message format and reads it back, each time of another set; counts answers of other commands."""

    def __init__(self, pairs: int, barrier: bool = True, seed: int = 1, **faults: Any) -> None:
        of = model("real")
        if not barrier:
            of = replace(of, protocol=replace(of.protocol, barrier=(0, 0)))
        self.session = Session(device(NAME), Witness(seed=seed, **faults), client=Client(of), seed=seed)
        self.field = next(s.field for s in commands(device(NAME)) if s.field.full_name == "3dm.message_format")
        self.wrong = self.missed = 0
        for number in range(pairs):
            shown = SETS[number % len(SETS)]
            formats = [{"descriptor": 0x11, "decimation": number + 1}] if shown == 0x82 else []
            for function, entries in ((1, formats), (2, [])):
                values = {"function": function, "descriptor_set": shown, "num_descriptors": len(entries)}
                answer = self.ask({**values, "descriptors": entries})
                self.missed += answer["event"] == "timed_out"
                self.wrong += answer["event"] == "missing_response" or answer["event"] in (
                    ("acknowledged",) if shown == 0x7E else ("refused",)
                )
                if answer["event"] == "acknowledged" and function == 2:
                    self.wrong += answer["response"]["values"]["descriptor_set"] != shown
        self.session.end()

    def ask(self, values: dict[str, Any]) -> dict[str, Any]:
        events = self.session.ask(Trial(self.field, values, True))
        return next(e for e in events if e.get("command") == len(self.session.trials) - 1)

    @property
    def seconds(self) -> float:
        return self.session.virtual.now / 1e9


FAULTS = {
    "late": {"late_answer": LATE},
    "late and twice": {"late_answer": LATE, "double_packet": 0.1},
    "late and lost": {"late_answer": LATE, "lose_answer": 0.05, "lose_packet": 0.03, "command_lose": 0.002},
}


@pytest.mark.parametrize("faults", sorted(FAULTS))
def test_none_is_taken_for_the_answer_of_a_later_command(faults: str) -> None:
    pairs = Pairs(rounds(100, 1000), **FAULTS[faults])
    assert pairs.missed > 10 and pairs.wrong == 0
    repeat([pairs.session])


def test_without_a_barrier_they_are() -> None:
    assert Pairs(100, barrier=False, **FAULTS["late"]).wrong > 0


if __name__ == "__main__":  # the figures of docs/conformance.md
    for name, faults in FAULTS.items():
        for barrier in (False, True):
            p = Pairs(1000, barrier=barrier, **faults)
            what = "with" if barrier else "without"
            print(f"{name}, {what}: {p.wrong} of 2000 wrong, {p.missed} unanswered, {p.seconds:.0f} s", flush=True)
