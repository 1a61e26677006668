"""The latest values of all fields that have arrived, with their rates by the time of the device."""

from __future__ import annotations

import argparse
import time
from collections import deque
from collections.abc import Callable, Iterator
from typing import NamedTuple

from ..binding import CLOCKS, SECOND, moments
from ..devices.known import KnownDevice
from ..logs import inputs
from ..logs.scan import Piece
from ..names.selection import Selection
from ..ports import connection
from ..ports.silence import Line
from ..text import show
from ..text.decoding import DecodedField, decoded_field, name_of, raw_fields
from ..text.numbers import hertz
from ..text.references import references

#: Seconds after which a value is old.
STALE = 3.0


class _Latest:
    """The last field of a kind, and the times of the last ones: of their arrival, and by a clock in their packets."""

    __slots__ = ("field", "times")

    def __init__(self, field: DecodedField) -> None:
        self.field = field
        self.times: deque[tuple[float, str, float]] = deque(maxlen=200)

    def rate(self, now: float) -> float | None:
        """Returns the rate in Hz over the last seconds."""
        recent = [(clock, time) for arrival, clock, time in self.times if now - arrival < STALE]
        times = [time for clock, time in recent if clock == recent[-1][0]]
        return (len(times) - 1) / (times[-1] - times[0]) if times and times[-1] > times[0] else None


class Shown(NamedTuple):
    """A field with its latest values."""

    set: int
    name: str  # in the set
    rate: float | None  # in Hz
    age: float  # in seconds
    values: list[str]

    @property
    def hertz(self) -> str:
        """The rate as text."""
        return "" if self.rate is None else f"{hertz(self.rate)} Hz"

    @property
    def old(self) -> str:
        """The time since its arrival, if it is long."""
        return "" if self.age < STALE else f"{self.age:.0f} s ago"


class Latest:
    """The latest values of all fields that have arrived."""

    def __init__(self, selection: Selection, device: str | None) -> None:
        self._selection = selection
        #: The device whose flags are shown.
        self.device = KnownDevice(device)
        self._latest: dict[tuple[int, str], _Latest] = {}
        self.packets = self.skipped = 0

    def add(self, piece: Piece, now: float) -> None:
        """Adds a piece that has arrived."""
        if piece.packet is None:
            self.skipped += len(piece.data)
            return
        self.packets += 1
        self.device.learn(piece.packet)
        found = {clock: time for clock, time in moments(piece.packet, self.device.id).items() if time is not None}
        clock = next((clock for clock in reversed(CLOCKS) if clock in found), "")
        for raw in raw_fields(piece.packet):
            if self._selection.has(raw.set, raw.descriptor):
                field = decoded_field(raw)
                latest = self._latest.setdefault((raw.set, name_of(field)), _Latest(field))
                latest.field = field
                latest.times.append((now, clock, found[clock] / SECOND if clock else now))

    @property
    def summary(self) -> str:
        """Summarizes the data that arrived."""
        return "; ".join([f"{self.packets} packets, {self.skipped} bytes skipped", *self.device.lines()])

    def shown(self, now: float) -> Iterator[Shown]:
        """Yields the fields, ordered by set and name."""
        for (number, _), latest in sorted(self._latest.items()):
            field = latest.field
            name = show.short(field, show.set_name(number))
            values = [show.inside(field, self.device.reads)]
            if field.value is not None:
                device = self.device.reads(type(field.value))
                values = list(show.leaves(field.value, device, references(field.value, number)))
            yield Shown(number, name, latest.rate(now), now - latest.times[-1][0], values)

    def lines(self) -> list[str]:
        """Formats all values as lines."""
        lines, set_number = [self.summary], None
        for shown in self.shown(time.monotonic()):
            if shown.set != set_number:
                set_number = shown.set
                lines.append(f"{show.set_name(set_number)} (0x{set_number:02X})")
            old = f", {shown.old}" if shown.old else ""
            lines.append(f"  {shown.name:<26} {shown.hertz:>9}{old}")
            lines += [f"      {text}" for text in shown.values]
        return lines


def device_pieces(
    options: argparse.Namespace, latest: Latest, say: Callable[[str], object] | None = None
) -> Iterator[Piece | None]:
    """Yields data as it arrives, from a device that is asked who it is, until the time is over. Raises Failure, or Lost
    like `connection.port_pieces`."""
    if inputs.is_port(options.input):
        line = Line(options.input, options.baud, "monitor", options.timeout)
        yield from connection.port_pieces(line, options.duration, latest.device.ask, say)
        return
    end = None if options.duration is None else time.monotonic() + options.duration
    for piece in inputs.arriving(options.input, progress=False):
        yield piece
        if end is not None and time.monotonic() >= end:
            return
