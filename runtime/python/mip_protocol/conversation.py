"""The communication between a program and a device, without input or output: requests, data,
settings.

`Device` and `aio.Device` transfer the bytes and wait; the state of the device is kept here. Nothing
in this module waits or locks: its callers do.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from copy import copy
from dataclasses import dataclass, replace
from math import nan
from typing import Any, NamedTuple, TypeAlias, TypeVar, cast

from ._clocks import CLOCKS

# needs: session
from ._index import IDENTIFY, information
from .client import Answer, Client, Event, Outcome, Received, Skipped, TimedOut, check_seconds
from .errors import NoAnswer, Refused
from .exceptions import PortClosed
from .field import Command, Field, Response
from .packet import Packet, RawField
from .protocol import FunctionSelector
from .registry import decode_packet, types

F = TypeVar("F", bound=Field)
# needs: session or baud rates
T = TypeVar("T")

#: Seconds without a byte after which an incomplete packet is discarded.
SILENCE = 1.0
#: Packets that wait for the program, by default.
CAPACITY = 10_000


@dataclass(frozen=True, slots=True)
class Stamp:
    """The times of a field in seconds: by the device, and when it arrived."""

    device: float
    """The time in its packet, which `Arrival.device_time` has in nanoseconds; NaN if there is
    none: some devices, such as the 3DM-GX3-25, send no timestamps."""
    clock: str
    """The clock of this time: "gps" counts in UTC since 1970, others from their start; "" if there
    is no time."""
    arrived: float
    """When it had been read, as `Arrival.time`: since 1970, UTC, by the clock of this computer."""


@dataclass(frozen=True, slots=True)
class Arrival:
    """A packet with fields that do not answer a command, usually data, and its time of arrival."""

    packet: Packet
    time: float
    """When its last bytes had been read: seconds since 1970, UTC, by the clock of this computer."""
    monotonic: float
    """The same time by `time.monotonic()`, a clock that is never set."""
    taken: frozenset[int] = frozenset()
    """The indices of the fields that answered a command."""
    model: str | None = None
    """The id of the device's model, if `Device.model` was known when it arrived."""

    @property
    def fields(self) -> tuple[RawField, ...]:
        """The fields that do not answer a command, up to a malformed one."""
        return Received(self.packet, self.taken).fields

    def find(self, kind: type[F]) -> F | None:
        """Returns the first field of this type, or None. Raises DecodeError."""
        return kind.find(self.packet)

    def find_all(self, kind: type[F]) -> Iterator[F]:
        """Yields the fields of this type, in order; some messages have one for each satellite.
        Raises DecodeError at a field that cannot be decoded."""
        return kind.find_all(self.packet)

    def device_time(self, clock: str = "gps") -> int | None:
        """Returns the time in the packet by one of the device's clocks, in nanoseconds; None if the
        packet does not contain it, or if it is not valid.

        `clock`: "gps" counts in UTC since 1970; "external" and "reference" count from their start.
        For the time in a field, see `timestamps.time_of`.
        """
        from .timestamps import moments

        if clock not in CLOCKS:
            raise ValueError(f"{clock!r} is not a clock; use one of {', '.join(CLOCKS)}")
        return moments(self.packet, self.model).get(clock)

    def stamp(self, device: str | None = None) -> Stamp:
        """Returns the time of its fields, by the first clock of which the packet contains a valid
        time: one with a date, if there is one. `device` is the device's id, if it is not `model`.
        """
        from .timestamps import moments

        times = moments(self.packet, device or self.model)
        clock = next((clock for clock in CLOCKS if times.get(clock) is not None), "")
        time = times.get(clock)
        return Stamp(nan if time is None else time / 1e9, clock, self.time)

    def decode(self) -> list[Field | RawField]:
        """Returns all fields of the packet, as `registry.decode_packet` does."""
        return list(decode_packet(self.packet))


class Ticket:
    """A command that was sent, and its outcome."""

    __slots__ = ("command", "done", "outcome", "sent")

    def __init__(self, command: Command) -> None:
        self.command = command
        self.sent = copy(command)  # the client compares identities; one object may be sent twice
        self.outcome: Outcome | None = None
        self.done = False

    def end(self, outcome: Outcome | None) -> None:
        self.outcome = outcome
        self.done = True


@dataclass(frozen=True)
class News:
    """What has changed, so that the callers that wait for it can be woken."""

    answers: bool = False
    arrivals: bool = False


class Conversation:
    """The state of a device at a port."""

    def __init__(
        self,
        timeout: float = 1.0,
        capacity: int = CAPACITY,
        on_skipped: Callable[[bytes], object] | None = None,
    ) -> None:
        if capacity < 1:
            raise ValueError(f"capacity {capacity}: must be at least 1 packet")
        check_seconds(timeout)
        if not timeout:
            raise ValueError(f"timeout {timeout}: must be above 0: a device needs time to reply")
        self.arrivals: deque[Arrival] = deque()
        self.dropped = 0
        self.model: str | None = None  # the device's id
        self.identified = False  # by its answer from this port, or by the program
        self._named = False  # by the program
        self._capacity = capacity
        self._on_skipped = on_skipped
        self._tickets: list[Ticket] = []
        self._settings: dict[tuple[int, int], Field] = {}
        self._client = Client(timeout, skipped=on_skipped is not None)
        self._heard = 0.0
        self._incomplete = False

    def restart(self) -> None:
        """Prepares for a port that has been opened again. Data that waits to be read is kept."""
        self._settings.clear()
        self.identified = self._named
        self._handle(self._client.interrupt(), time.monotonic(), time.time())
        self._incomplete = False

    @property
    def skipped(self) -> int:
        return self._client.skipped

    def name(self, model: str | None) -> None:
        """Names the device's model, whatever the device answers; None if it shall say that itself."""
        from .lookup import device_id

        self.model = None if model is None else device_id(model)
        self._named = self.identified = model is not None

    # ----------------------------------------------------------------- commands

    def send(
        self, commands: Sequence[Command], now: float, timeout: float | None, wait: bool = True
    ) -> tuple[bytes, list[Ticket]]:
        """Returns the packet to write and a ticket for each command. Raises EncodeError.

        A command that the device does not acknowledge is done at once. Without `wait`, all commands
        are done at once, and replies are treated as data.
        """
        tickets = [Ticket(command) for command in commands]
        packet = self._client.send(*(t.sent for t in tickets), now=now, timeout=timeout, wait=wait)
        for ticket in tickets:
            if not wait or not ticket.command.answered:
                ticket.end(None)
            elif self._silenced(ticket.command):
                self._client.cancel(ticket.sent, silent=True)
                ticket.end(None)
        self._tickets += [t for t in tickets if not t.done]
        return packet, tickets

    def forget(self, tickets: Sequence[Ticket]) -> None:
        """Notes that no caller waits for these commands any more."""
        for ticket in tickets:
            if not ticket.done:
                self._client.cancel(ticket.sent)
        self._tickets = [t for t in self._tickets if t not in tickets]

    def question(self, command: Command) -> Command | None:
        """Returns the command that reads whether `command` will be acknowledged, if unknown."""
        for number, descriptor, _, _ in command.SILENCED_BY:
            if command.answered and (number, descriptor) not in self._settings:
                for kind in types(number, descriptor):
                    read, required = getattr(kind, "read", None), getattr(kind, "REQUIRED", {})
                    if read and required.get(FunctionSelector["READ"]) == 0:
                        return cast(Command, read())
        return None

    def settle(self, question: Command, outcome: Outcome | None) -> None:
        """Notes that the device lacks a setting if it rejected the question: it is asked once."""
        if isinstance(outcome, Answer) and not outcome.accepted:
            self._settings[question.SET, question.DESCRIPTOR] = question

    def _silenced(self, command: Command) -> bool:
        """Does a device setting suppress the acknowledge of this command?"""
        return any(
            getattr(self._settings.get((number, descriptor)), name, None) == value
            for number, descriptor, name, value in command.SILENCED_BY
        )

    def _learn(self, answer: Answer) -> None:
        """Records a setting that the device has reported or accepted."""
        command = answer.command
        if not answer.accepted or command.SILENCED_BY:
            return
        key = (command.SET, command.DESCRIPTOR)
        # needs: session
        if key == IDENTIFY and answer.response is not None and not self._named:
            from .lookup import model_id

            self.model = model_id(information(answer.response))
            self.identified = True
        # By name: a specification may have none of these functions.
        function = getattr(getattr(command, "function", None), "name", None)
        if answer.response is not None and function == "READ":
            self._settings[key] = answer.response
        elif function == "WRITE":
            self._settings[key] = command
        elif function not in ("READ", "SAVE"):
            self._settings.clear()  # it may have loaded others, or restarted

    def clear(self, set: int | None) -> None:
        """Discards the data of one set, or all data, that has not been read yet."""
        kept = [a for a in self.arrivals if set not in (None, a.packet.set)]
        self.arrivals.clear()
        self.arrivals.extend(kept)

    # ------------------------------------------------------------- received bytes

    def receive(self, data: bytes, monotonic: float, clock: float) -> News:
        """Processes bytes received at this time, by both clocks. No bytes: the line was idle."""
        if not data:
            return self._idle(monotonic, clock)
        self._heard = monotonic
        self._incomplete = True
        return self._handle(self._client.receive(data, monotonic), monotonic, clock)

    def _idle(self, monotonic: float, clock: float) -> News:
        # Noise may look like the start of a packet; packets after it must not wait for its end.
        if not self._incomplete:
            return self._handle(self._client.poll(monotonic), monotonic, clock)
        if monotonic - self._heard < SILENCE:
            return self._handle(self._client.look_behind(monotonic), monotonic, clock)
        self._incomplete = False
        return self._handle(self._client.flush(monotonic), monotonic, clock)

    def poll(self, monotonic: float) -> News:
        """Ends the commands that have timed out."""
        return self._handle(self._client.poll(monotonic), monotonic, time.time())

    def end(self, monotonic: float, clock: float) -> News:
        """Processes the remaining bytes of a lost port, from which no more will arrive."""
        return self._handle(self._client.flush(monotonic), monotonic, clock)

    @property
    def deadline(self) -> float | None:
        """The time at which the next command times out."""
        return self._client.deadline

    def _handle(self, events: list[Event], monotonic: float, clock: float) -> News:
        answers = arrivals = False
        skipped = []
        for event in events:
            if isinstance(event, Received):
                if len(self.arrivals) >= self._capacity:
                    self.arrivals.popleft()
                    self.dropped += 1
                self.arrivals.append(
                    Arrival(event.packet, clock, monotonic, event.taken, self.model)
                )
                arrivals = True
            elif isinstance(event, Skipped):
                skipped.append(event.data)
            else:
                if isinstance(event, Answer):
                    self._learn(event)
                answers = self._end(event) or answers
        if self._on_skipped is not None:
            for data in skipped:  # last, because it may raise an exception
                self._on_skipped(data)
        return News(answers, arrivals)

    def _end(self, outcome: Outcome) -> bool:
        for ticket in self._tickets:
            if ticket.sent is outcome.command:
                ticket.end(replace(outcome, command=ticket.command))
                self._tickets.remove(ticket)
                return True
        return False


class AtPort:
    """The base of both devices: a device at a port, however its callers wait."""

    _closed = True  # until there is a port
    _url = ""  # of a port that `open_port` has opened
    _closes = 0
    _end: PortClosed | None = None  # why no more data arrives
    _talk: Conversation
    _port: Any

    def __repr__(self) -> str:
        return f"<Device at {self._url or 'a port'}{', closed' * self._closed}>"

    @property
    def closed(self) -> bool:
        """Is the port closed or lost? Data already received can still be read."""
        return self._end is not None

    @property
    def dropped(self) -> int:
        """The number of packets dropped because they were not read in time."""
        return self._talk.dropped

    @property
    def skipped(self) -> int:
        """The number of bytes that are not part of a packet."""
        return self._talk.skipped

    @property
    def waiting(self) -> int:
        """The number of packets that can be read without waiting."""
        return len(self._talk.arrivals)

    @property
    def model(self) -> str | None:
        """The id of the device's model, such as "3dm-gx5-25", as which the flags of times are read;
        None if it is not known. It is known from the device's answer to the command that identifies
        it, which `stream` sends, or if you set it: by any name of the model. Setting it raises
        UnknownName."""
        return self._talk.model

    @model.setter
    def model(self, name: str | None) -> None:
        self._talk.name(name)

    @property
    def baud(self) -> int | None:
        """The baud rate of the port; None if it has none."""
        return getattr(self._port, "baudrate", None)

    @baud.setter
    def baud(self, rate: int) -> None:
        """Changes the rate of the port, not that of the device; see `change_baud`. Raises
        ValueError if the port has no rate, and whatever the port raises if it does not support this
        one."""
        if self.baud is None:
            raise ValueError("the port has no baud rate")
        self._port.baudrate = rate

    def _must_be_open(self) -> None:
        if self._end is not None:
            raise PortClosed(self._end.detail) from self._end.__cause__


# needs: session or baud rates
class Step(NamedTuple):
    """A command to send, and the seconds for its reply; without a command, the seconds to wait."""

    command: Command[Any] | None
    seconds: float | None = None


# needs: session or baud rates
#: Yields steps. The caller sends the response of each into it, or throws Refused or NoAnswer.
Dialog: TypeAlias = Generator[Step, Any, T]


def response(ticket: Ticket, tickets: Sequence[Ticket]) -> Response | None:
    """Returns the device's response, or raises the error that explains its absence."""
    outcome = ticket.outcome
    if outcome is None:
        return None
    if isinstance(outcome, TimedOut):
        raise NoAnswer(ticket.command, [t.outcome for t in tickets])
    if not outcome.accepted:
        raise Refused(ticket.command, outcome.code, [t.outcome for t in tickets])
    if outcome.error is not None:
        raise outcome.error
    return outcome.response


def responses(tickets: Sequence[Ticket]) -> tuple[Response | None, ...]:
    """Returns the responses to one packet's commands. Raises the first failed one's error."""
    return tuple(response(ticket, tickets) for ticket in tickets)
