"""A host of a simulated device."""

from __future__ import annotations

from typing import Any

from mip_protocol import Answer, Client, Command, Packet, Parser, Received
from mip_simulator import VirtualDevice


class Host:
    """Sends commands to a device, and keeps the data that arrive in between."""

    def __init__(self, device: VirtualDevice, port: str | None = None) -> None:
        self.device = device
        self.link = device.connect(port)
        self.client = Client()
        self.data: list[Packet] = []

    def ask(self, *commands: Command, patience: float = 40.0) -> list[Any]:
        """The outcomes of commands in one packet; a silent command has none."""
        self.link.write(self.client.send(*commands, now=self.now))
        found: list[Any] = []
        end = self.now + patience
        while True:
            for event in self.client.receive(self.link.read(), now=self.now):
                if isinstance(event, Received):
                    self.data.append(event.packet)
                else:
                    found.append(event)
            if not self.client.pending or self.now >= end:
                return found
            self.device.advance(0.05)

    def ok(self, command: Command) -> Any:
        """The response to a command that must succeed."""
        (answer,) = self.ask(command)
        assert isinstance(answer, Answer) and answer.accepted and answer.error is None, answer
        return answer.response

    def refused(self, command: Command) -> int:
        (answer,) = self.ask(command)
        assert isinstance(answer, Answer) and not answer.accepted, answer
        return int(answer.code)

    def raw(self, data: bytes) -> list[Packet]:
        """The packets that come back for any bytes."""
        self.link.write(data)
        return Parser().feed(self.link.read())

    @property
    def now(self) -> float:
        return self.device.now / 1e9
