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

from mip_protocol.packet import SYNC
from mip_simulator.device import VirtualDevice
from mip_simulator.faults import Faults, Injected
from mip_simulator.faults.kinds import KINDS
from mip_tools.devices.profiles import assumed_rates, device_named

__all__ = ["KINDS", "START", "Event", "Session", "Witness", "assumed_rates", "device_named"]

Event = dict[str, Any]

#: Milliseconds between two looks at the line. No time-out is a multiple of it, so that no command times out at the very
#: instant of a look: seconds as floats are not exact.
TICK = 11

#: Milliseconds that a device needs to start.
START = 600


class Witness(Faults):
    """Observes every packet of the device, and its fate on the line."""

    def __init__(self, **rates: Any) -> None:
        self.injected: list[Injected] = []
        self.packets: list[tuple[bytes, bytes]] = []  # as sent, and as it is on the line
        super().__init__(log=self.injected.append, **rates)

    def transmit(self, now: int, packet: bytes, line: Hashable = None) -> list[tuple[int, bytes]]:
        pieces = super().transmit(now, packet, line)
        if packet[:2] == SYNC:  # no NMEA sentence
            self.packets.append((packet, b"".join(piece for _, piece in pieces)))
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
    when: list[int] = field(default_factory=list)  # each event happened, in nanoseconds of the device
    seed: int = 0

    def __post_init__(self) -> None:
        self.virtual = VirtualDevice(self.device.id, seed=self.seed, faults=self.witness)
        self.link = self.virtual.connect()

    def step(self, step: Step) -> list[Event]:
        """The events of one step."""
        self.steps.append(step)
        before = len(self.client.events)
        {"send": self.client.send, "receive": self.client.receive, "time": self.client.time, "end": self.client.end}[
            step["step"]
        ](step)
        happened = self.client.events[before:]
        self.when += [self.virtual.now] * len(happened)
        return happened

    def send(self, *trials: Trial) -> None:
        """Sends one packet."""
        entries = [t.entry for t in trials]
        events = self.step({"step": "send", "set": trials[0].command.set, "fields": entries})
        assert events[0]["event"] == "sent", events
        self.trials += trials
        self.connect()
        self.link.write(bytes.fromhex(events[0]["packet"]))
        self.read()

    def connect(self) -> None:
        """Connects again if the device has closed the line."""
        if self.link.closed:
            self.link = self.virtual.connect()

    def read(self) -> None:
        data = self.link.read()
        self.connect()
        if data:
            self.stream += data
            self.step(receive(data))

    def wait(self, milliseconds: int) -> None:
        for _ in range(0, milliseconds, TICK):
            self.virtual.advance(TICK / 1000)
            self.read()
            self.step(time(TICK))

    def settle(self) -> None:
        """Waits until no command is pending; time-outs bound it."""
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
