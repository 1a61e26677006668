"""A virtual device and a client beside each other, in stepped time.

The plain client of `conformance.client_model` decides how the conversation goes on. What it did, sent and received
is kept as the steps of a `client` request, which the drivers of all languages then repeat.
"""

from __future__ import annotations

import sys
from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import Any

from conformance.client_model import Client
from conformance.scenarios import END, Step, receive, time
from mipgen import model as m
from support import ROOT, model
from virtual.commands import Trial

sys.path.insert(0, str(ROOT / "generated/python"))

from mip_protocol import RawField
from mip_protocol.packet import SYNC
from mip_protocol.simulator.device import VirtualDevice
from mip_protocol.simulator.faults import Faults, Injected

Event = dict[str, Any]

#: Milliseconds between two looks at the line. No time-out is a multiple of it, so that no command is given up at the
#: very instant at which it may be: seconds as floats are not exact.
TICK = 11


@dataclass
class Answered:
    """What the device answered to a command, before and after the faults."""

    command: RawField
    meant: list[RawField]
    sent: list[RawField]


@dataclass
class Transmitted:
    """A packet or a sentence of the device, and what became of it."""

    packet: bytes
    pieces: list[bytes]

    @property
    def intact(self) -> bool:
        return self.packet[:2] == SYNC and self.packet in b"".join(self.pieces)


class Witness(Faults):
    """Sees what the device does."""

    def __init__(self, **rates: Any) -> None:
        self.injected: list[Injected] = []
        self.answers: list[Answered] = []
        self.packets: list[Transmitted] = []
        super().__init__(log=self.injected.append, **rates)

    def answer(self, now: int, command: RawField, answer: list[RawField]) -> tuple[int, list[RawField]]:
        delay, sent = super().answer(now, command, answer)
        self.answers.append(Answered(command, answer, sent))
        return delay, sent

    def transmit(self, now: int, packet: bytes, line: Hashable = None) -> list[tuple[int, bytes]]:
        pieces = super().transmit(now, packet, line)
        self.packets.append(Transmitted(packet, [p for _, p in pieces]))
        return pieces


@dataclass
class Session:
    """One conversation."""

    device: m.Device
    witness: Witness
    client: Client = field(default_factory=lambda: Client(model("real")))
    steps: list[Step] = field(default_factory=list)
    stream: bytearray = field(default_factory=bytearray)
    trials: list[Trial] = field(default_factory=list)  # by the number of the command
    seed: int = 0

    def __post_init__(self) -> None:
        self.virtual = VirtualDevice(self.device.id, seed=self.seed, faults=self.witness)
        self.link = self.virtual.connect()

    def step(self, step: Step) -> list[Event]:
        """What happens at one step."""
        self.steps.append(step)
        before = len(self.client.events)
        {"send": self.client.send, "receive": self.client.receive, "time": self.client.time, "end": self.client.end}[
            step["step"]
        ](step)
        return self.client.events[before:]

    def send(self, *trials: Trial) -> None:
        """One packet."""
        entries = [t.entry for t in trials]
        events = self.step({"step": "send", "set": trials[0].command.set, "fields": entries})
        assert events[0]["event"] == "sent", events
        self.trials += trials
        self.link.write(bytes.fromhex(events[0]["packet"]))
        self.read()

    def read(self) -> None:
        data = self.link.read()
        if data:
            self.stream += data
            self.step(receive(data))

    def wait(self, milliseconds: int) -> None:
        for _ in range(0, milliseconds, TICK):
            self.virtual.advance(TICK / 1000)
            self.read()
            self.step(time(TICK))

    def settle(self) -> None:
        """Until no command waits; time-outs bound it."""
        while self.client.waiting:
            self.wait(TICK)

    def ask(self, *trials: Trial) -> list[Event]:
        """Sends one packet and waits for the answers."""
        before = len(self.client.events)
        self.send(*trials)
        self.settle()
        return self.client.events[before:]

    def end(self) -> None:
        self.step(END)
