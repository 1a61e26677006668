"""Commands and their answers, without input or output.

The caller moves the bytes and knows the time:

    client = Client()
    port.write(client.send(Ping(), now=time.monotonic()))
    while client.pending:
        for event in client.receive(port.read(), now=time.monotonic()):
            ...

Times are seconds on any clock that does not jump.
"""

from __future__ import annotations

from dataclasses import dataclass

from .field import Command, Response
from .packet import Packet, PacketBuilder
from .parser import Parser
from .protocol import Acknowledge
from .types import AckCode


@dataclass(frozen=True)
class Answer:
    """The device has answered a command; `response` is there if it sent one."""

    command: Command
    code: AckCode
    response: Response | None = None

    @property
    def accepted(self) -> bool:
        return self.code == 0


@dataclass(frozen=True)
class TimedOut:
    """The device has not answered in time."""

    command: Command


@dataclass(frozen=True)
class Received:
    """A packet that answers nothing: data, or a reply that nobody waits for."""

    packet: Packet


Event = Answer | TimedOut | Received


@dataclass
class _Pending:
    command: Command
    deadline: float


class Client:
    """Keeps track of the commands that wait for an answer. Data between the answers pass through."""

    def __init__(self, timeout: float = 1.0) -> None:
        """`timeout`: seconds until a command is given up, unless it is known to take longer."""
        self._timeout = timeout
        self._parser = Parser()
        self._pending: list[_Pending] = []

    @property
    def pending(self) -> tuple[Command, ...]:
        """The commands that wait for an answer, oldest first."""
        return tuple(p.command for p in self._pending)

    @property
    def skipped(self) -> int:
        """Bytes received that belong to no packet."""
        return self._parser.skipped

    def send(self, *commands: Command, now: float) -> bytes:
        """The bytes to send: one packet with these commands, all of one descriptor set.

        Raises EncodeError, and waits for nothing, if they do not fit into one packet.
        """
        if not commands:
            raise ValueError("send needs at least one command")
        builder = PacketBuilder(commands[0].SET)
        for command in commands:
            if command.SET != commands[0].SET:
                raise ValueError("the commands of one packet must be of one descriptor set")
            builder.add(command.DESCRIPTOR, command.encode())
        for command in commands:
            if command.answered:
                wait = max(self._timeout, command.TIMEOUT or 0.0)
                self._pending.append(_Pending(command, now + wait))
        return bytes(builder.build())

    def receive(self, data: bytes, now: float) -> list[Event]:
        """What these bytes and this moment bring: answers, other packets, time-outs."""
        events: list[Event] = []
        for packet in self._parser.feed(data):
            events += self._answers(packet)
        return events + self.poll(now)

    def poll(self, now: float) -> list[Event]:
        """The commands whose time is over."""
        late = [p for p in self._pending if p.deadline <= now]
        self._pending = [p for p in self._pending if p.deadline > now]
        return [TimedOut(p.command) for p in late]

    def _answers(self, packet: Packet) -> list[Event]:
        if packet.set >= 0x80:
            return [Received(packet)]
        events: list[Event] = []
        answer: Answer | None = None
        try:
            for raw in packet:
                if raw.descriptor == Acknowledge.DESCRIPTOR:
                    if answer is not None:
                        events.append(answer)
                    answer = self._acknowledged(packet.set, Acknowledge.decode(raw.data))
                elif answer is not None and answer.response is None:
                    kinds = [
                        r
                        for r in answer.command.RESPONSES
                        if r.DESCRIPTOR == raw.descriptor and r.matches(raw.data)
                    ]
                    if kinds:
                        answer = Answer(answer.command, answer.code, kinds[0].decode(raw.data))
        except ValueError:
            pass  # what stands before a malformed field still counts
        if answer is not None:
            events.append(answer)
        return events or [Received(packet)]

    def _acknowledged(self, set: int, ack: Acknowledge) -> Answer | None:
        for i, waiting in enumerate(self._pending):
            if waiting.command.SET == set and waiting.command.DESCRIPTOR == ack.command:
                del self._pending[i]
                return Answer(waiting.command, ack.code)
        return None
