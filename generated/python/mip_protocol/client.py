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

from collections.abc import Iterable
from dataclasses import dataclass, replace

from .errors import DecodeError, EncodeError, PacketError
from .field import Command, Response
from .packet import Packet, PacketBuilder, RawField
from .parser import Parser
from .protocol import Acknowledge
from .types import AckCode


@dataclass(frozen=True)
class Answer:
    """The device has answered a command; `response` is there if it sent one.

    `error` says what is wrong with a response that came and could not be decoded.
    """

    command: Command
    code: AckCode
    response: Response | None = None
    error: DecodeError | None = None

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
            raise EncodeError("missing", "send needs at least one command")
        builder = PacketBuilder(commands[0].SET)
        for command in commands:
            if not isinstance(command, Command):
                raise EncodeError("set", f"{command!r} is no command")
            if command.SET != commands[0].SET:
                raise EncodeError("set", "the commands of one packet must be of one descriptor set")
            builder.add(command.DESCRIPTOR, command.encode())
        for command in commands:
            if command.answered:
                wait = max(self._timeout, command.TIMEOUT or 0.0)
                self._pending.append(_Pending(command, now + wait))
        return bytes(builder.build())

    def receive(self, data: bytes, now: float) -> list[Event]:
        """What these bytes and this moment bring: answers, other packets, time-outs."""
        return self._events(self._parser.feed(data), now)

    def flush(self, now: float) -> list[Event]:
        """Gives up a packet that is not complete, after a silence say, and looks behind it.

        Noise that looks like the beginning of a long packet holds an answer back until then.
        """
        return self._events(self._parser.flush(), now)

    @property
    def deadline(self) -> float | None:
        """When the next command times out; None if nothing waits."""
        return min((p.deadline for p in self._pending), default=None)

    def cancel(self, command: Command) -> None:
        """Waits for this command no longer."""
        self._pending = [p for p in self._pending if p.command is not command]

    def poll(self, now: float) -> list[Event]:
        """The commands whose time is over."""
        late = [p for p in self._pending if p.deadline <= now]
        self._pending = [p for p in self._pending if p.deadline > now]
        return [TimedOut(p.command) for p in late]

    def _events(self, packets: Iterable[Packet], now: float) -> list[Event]:
        events: list[Event] = []
        for packet in packets:
            events += self._answers(packet) or [Received(packet)]
        return events + self.poll(now)

    def _answers(self, packet: Packet) -> list[Answer]:
        if packet.set >= 0x80:
            return []
        answers: list[Answer] = []
        current = False  # does the last answer take the response that follows?
        try:
            for raw in packet:
                if raw.descriptor == Acknowledge.DESCRIPTOR:
                    answer = self._acknowledged(raw)
                    current = answer is not None
                    if answer is not None:
                        answers.append(answer)
                elif current and answers[-1].response is None and answers[-1].error is None:
                    answers[-1] = _completed(answers[-1], raw)
        except PacketError:
            pass  # what stands before a malformed field still counts
        return answers

    def _acknowledged(self, raw: RawField) -> Answer | None:
        try:
            ack = Acknowledge.decode(raw.data)
        except DecodeError:
            return None
        for i, waiting in enumerate(self._pending):
            if waiting.command.SET == raw.set and waiting.command.DESCRIPTOR == ack.command:
                del self._pending[i]
                return Answer(waiting.command, ack.code)
        return None


def _completed(answer: Answer, raw: RawField) -> Answer:
    """The answer with its response, if the field is one."""
    for kind in answer.command.RESPONSES:
        if kind.DESCRIPTOR == raw.descriptor and kind.matches(raw.data):
            try:
                return replace(answer, response=kind.decode(raw.data))
            except DecodeError as error:
                return replace(answer, error=error)
    return answer
