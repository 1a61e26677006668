"""The command client, without input or output.

The caller transfers the bytes and provides the time:

    client = Client()
    port.write(client.send(Ping(), now=time.monotonic()))
    while client.pending:
        for event in client.receive(port.read(), now=time.monotonic()):
            ...

Times are seconds on any clock that does not jump.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from .exceptions import DecodeError, EncodeError, MissingResponse
from .field import Command, Response
from .packet import Packet, PacketBuilder, RawField
from .parser import Parser
from .protocol import BARRIER, Acknowledge
from .types import AckCode

#: The number of different barriers. The replies to their 2 to 63 commands fit into one packet.
BARRIERS = 62


@dataclass(frozen=True)
class Answer:
    """The device has answered a command; `response` is present if the command requests one.

    If a requested response is missing, `error` is the reason: the device sent none
    (`MissingResponse`), or one that cannot be decoded, which is in `raw`.
    """

    command: Command
    code: AckCode
    response: Response | None = None
    error: DecodeError | MissingResponse | None = None
    raw: RawField | None = None

    @property
    def accepted(self) -> bool:
        return self.code == 0


@dataclass(frozen=True)
class TimedOut:
    """The device has not answered in time."""

    command: Command


@dataclass(frozen=True)
class Received:
    """A packet with fields that do not answer a command: data, or an unexpected reply."""

    packet: Packet
    taken: frozenset[int] = frozenset()
    """The indices of the fields that answered a command."""

    @property
    def fields(self) -> tuple[RawField, ...]:
        """The fields that do not answer a command, up to a malformed one."""
        return tuple(f for i, f in enumerate(self.packet.fields) if i not in self.taken)


@dataclass(frozen=True)
class Skipped:
    """Bytes between packets: NMEA sentences, noise, packets with a wrong checksum.

    Events of this kind come only from `Client(skipped=True)`, in order with those of packets.
    """

    data: bytes


#: The outcome of a command.
Outcome = Answer | TimedOut
Event = Outcome | Received | Skipped


def check_seconds(seconds: float, name: str = "timeout") -> None:
    """Raises TypeError or ValueError if this is not a valid number of seconds to wait."""
    try:
        right = seconds >= 0
    except TypeError:
        raise TypeError(f"{name} {seconds!r}: must be a number of seconds") from None
    if not right:  # NaN, too
        raise ValueError(f"{name} {seconds}: must be a number of seconds, 0 or more")


@dataclass
class _Pending:
    command: Command
    expected: tuple[type[Response], ...]
    deadline: float
    behind: int  # the size of a barrier that must be answered first; 0: none


class Client:
    """Matches replies to the commands that wait for them. Data between replies is passed through.

    The reply to a command that has timed out may still arrive, and nothing in MIP distinguishes it
    from the reply to the next such command. `send` therefore first sends a barrier: a packet of
    several commands that change nothing. The device replies in order, and to all commands of a
    packet in one packet, whose size identifies the barrier. Before the reply to the barrier, no
    reply is matched to a command sent after it; after that, none is matched to a command sent
    before it, which has timed out. If the barrier is not answered, the commands after it time out,
    although the device may have carried them out.
    """

    def __init__(self, timeout: float = 1.0, skipped: bool = False) -> None:
        """`timeout`: seconds until a command times out, unless the specification states more.

        `skipped`: True to return bytes between packets as events, too.
        """
        check_seconds(timeout)
        self._timeout = timeout
        self._parser = Parser()
        self._wants_skipped = skipped
        self._pending: list[_Pending] = []
        self._missed = 0  # commands without a reply since the last answered barrier
        self._behind = 0  # the size of the last barrier, until it is answered

    @property
    def pending(self) -> tuple[Command, ...]:
        """The commands that wait for an answer, oldest first."""
        return tuple(p.command for p in self._pending)

    @property
    def skipped(self) -> int:
        """The number of bytes received that are not part of a packet."""
        return self._parser.skipped

    def send(
        self, *commands: Command, now: float, timeout: float | None = None, wait: bool = True
    ) -> bytes:
        """Returns the bytes to send: one packet with these commands, which must be of one
        descriptor set, preceded by a barrier if an earlier command was not answered.

        `timeout`: seconds for these commands, instead of their usual time-outs. `wait`: False to
        expect no replies; any that arrive are events, like data.

        Raises EncodeError if the commands do not fit into one packet, and ValueError if the
        time-out is NaN or negative; then nothing is waited for.
        """
        if not commands:
            raise EncodeError("missing", "send needs at least one command")
        if timeout is not None:
            check_seconds(timeout)
        for command in commands:
            if not isinstance(command, Command):
                raise EncodeError("set", f"{command!r} is not a command")
        builder = PacketBuilder(commands[0].SET)
        for command in commands:
            if command.SET != commands[0].SET:
                raise EncodeError("set", "the commands of one packet must be of one descriptor set")
            builder.add(command.DESCRIPTOR, command.encode())
        if not wait:
            self._miss(sum(command.answered for command in commands))
            return bytes(builder.build())
        barrier = self._barrier()
        for command in commands:
            if command.answered:
                allowed = max(self._timeout, command.TIMEOUT or 0.0) if timeout is None else timeout
                end = now + allowed
                self._pending.append(_Pending(command, command.expected, end, self._behind))
        return barrier + bytes(builder.build())

    def _barrier(self) -> bytes:
        number, descriptor = BARRIER
        if not number or not self._missed or self._behind == self._missed + 1:
            return b""
        self._miss(len(self._pending))  # they may be the same commands as in a barrier
        self._behind = self._missed + 1
        builder = PacketBuilder(number)
        for _ in range(self._behind):
            builder.add(descriptor, b"")
        return bytes(builder.build())

    def _miss(self, count: int) -> None:
        if count:
            self._missed = (self._missed + count - 1) % BARRIERS + 1

    def _passes(self, packet: Packet) -> list[Event] | None:
        """Returns the time-outs of commands before the last barrier, if this packet answers it."""
        number, descriptor = BARRIER
        if not self._behind or (packet.set, len(packet.payload)) != (number, 4 * self._behind):
            return None
        for at in range(0, len(packet.payload), 4):  # with any code
            if packet.payload[at : at + 3] != bytes((4, Acknowledge.DESCRIPTOR, descriptor)):
                return None
        before = [p for p in self._pending if p.behind != self._behind]
        self._pending = [p for p in self._pending if p.behind == self._behind]
        for waiting in self._pending:
            waiting.behind = 0
        if self._behind == self._missed + 1:
            self._missed = 0
        self._behind = 0
        return [TimedOut(p.command) for p in before]

    def receive(self, data: bytes, now: float) -> list[Event]:
        """Processes received bytes. Returns the events: answers, other packets, time-outs."""
        return self._events(self._parser.feed_all(data)) + self.poll(now)

    def flush(self, now: float) -> list[Event]:
        """Discards an incomplete packet, as at the end of a file, and searches its bytes."""
        return self._events(self._parser.flush_all()) + self.poll(now)

    def look_behind(self, now: float) -> list[Event]:
        """Discards an incomplete packet if a whole packet begins within it, because it was noise.

        Call this when no bytes have arrived for a while. A packet that arrives slowly is kept.
        """
        events: list[Event] = []
        while items := self._parser.look_behind_all():
            events += self._events(items)
        return events + self.poll(now)

    @property
    def deadline(self) -> float | None:
        """The time at which the next command times out; None if no command waits."""
        return min((p.deadline for p in self._pending), default=None)

    def cancel(self, command: Command, silent: bool = False) -> None:
        """Stops waiting for this command. A late reply to it is not matched to another one.

        `silent`: True if the device does not reply to it.
        """
        left = [p for p in self._pending if p.command is not command]
        if not silent:
            self._miss(len(self._pending) - len(left))
        self._pending = left

    def interrupt(self) -> list[Event]:
        """Handles a lost connection: waiting commands time out, and an incomplete packet is
        discarded. Replies over the next connection are not matched to later commands."""
        events = self._events(self._parser.flush_all())
        events += [TimedOut(p.command) for p in self._pending]
        self._miss(len(self._pending))
        self._pending = []
        return events

    def poll(self, now: float) -> list[Event]:
        """Returns the commands that have timed out, and other events.

        Noise that looks like the start of a long packet delays the packets after it. Before a
        command times out, they are processed. An incomplete packet is kept.
        """
        events: list[Event] = []
        while any(p.deadline <= now for p in self._pending):
            items = self._parser.look_behind_all()
            if not items:
                break
            events += self._events(items)
        late = [p for p in self._pending if p.deadline <= now]
        self._pending = [p for p in self._pending if p.deadline > now]
        self._miss(len(late))
        return [*events, *(TimedOut(p.command) for p in late)]

    def _events(self, items: Iterable[Packet | bytes]) -> list[Event]:
        events: list[Event] = []
        for item in items:
            if isinstance(item, Packet):
                events += self._taken(item)
            elif self._wants_skipped:
                events.append(Skipped(item))
        return events

    def _taken(self, packet: Packet) -> list[Event]:
        """Returns the answers in a packet, and the packet itself if it contains other fields."""
        if packet.set >= 0x80:
            return [Received(packet)]
        passed = self._passes(packet)
        if passed is not None:
            return passed
        fields, malformed = packet._walk()
        answers: list[Event] = []
        taken: set[int] = set()
        for i, raw in enumerate(fields):
            if i in taken or raw.descriptor != Acknowledge.DESCRIPTOR:
                continue
            answer = self._answer(raw, fields[i + 1] if i + 1 < len(fields) else None)
            if answer is not None:
                answers.append(answer)
                taken.update((i,) if answer.raw is None else (i, i + 1))
        if answers and len(taken) == len(fields) and not malformed:
            return answers
        return [*answers, Received(packet, frozenset(taken))]

    def _answer(self, raw: RawField, behind: RawField | None) -> Answer | None:
        """Returns the answer in an acknowledge and the field after it, for the oldest such command.

        A response is never matched to a command that does not request one, because it may be the
        late reply to another command. An acknowledge without a response is matched first to
        commands that request none.
        """
        try:
            ack = Acknowledge.decode(raw.data)
        except DecodeError:
            return None
        left_alone: _Pending | None = None
        for waiting in self._pending:
            command = waiting.command
            if waiting.behind or (command.SET, command.DESCRIPTOR) != (raw.set, ack.command):
                continue
            if ack.code != 0:
                return self._done(waiting, Answer(command, ack.code))
            if behind is None or all(r.DESCRIPTOR != behind.descriptor for r in command.RESPONSES):
                if not waiting.expected:
                    return self._done(waiting, Answer(command, ack.code))
                left_alone = left_alone or waiting
            elif (response := _response(waiting, ack.code, behind)) is not None:
                return self._done(waiting, response)
        if left_alone is None:
            return None
        error = MissingResponse(left_alone.command.NAME)
        return self._done(left_alone, Answer(left_alone.command, ack.code, error=error))

    def _done(self, waiting: _Pending, answer: Answer) -> Answer:
        self._pending = [p for p in self._pending if p is not waiting]
        return answer


def _response(waiting: _Pending, code: AckCode, raw: RawField) -> Answer | None:
    """Returns the answer with this response, if it is the one that the command requests."""
    command = waiting.command
    layouts = [t for t in waiting.expected if t.DESCRIPTOR == raw.descriptor]
    kind = next((t for t in layouts if t.matches(raw.data)), None)
    if kind is None:
        return None
    try:
        return Answer(command, code, kind.decode(raw.data), None, raw)
    except DecodeError as error:
        if error.kind == "constant":  # another layout of the descriptor
            return None
        return Answer(command, code, None, error, raw)
