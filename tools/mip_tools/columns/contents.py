"""Lists the contents of a log: the number of fields of each type, and their rates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..binding import Field, registry
from . import layout, times
from .intervals import Intervals
from .packets import Packets
from .scan import Array


@dataclass(frozen=True)
class TypeCount:
    """The number of fields of a type in a log."""

    set: int  # the set of their packets
    descriptor: int
    type: type[Field] | None  # None: unknown, or not decodable
    name: str
    count: int
    rate: float | None  # of the packets that have any, without gaps, in Hz; None without times


class _Span(NamedTuple):
    """The number of some fields and of the packets that have any, and the first and the last of these packets."""

    rows: int
    packets: int
    first: int
    last: int

    @classmethod
    def of(cls, packet: Array) -> _Span:
        """Returns that of the fields in these packets, in their order."""
        return cls(len(packet), 1 + int(np.count_nonzero(np.diff(packet))), int(packet[0]), int(packet[-1]))

    def and_(self, other: _Span) -> _Span:
        rows, packets = self.rows + other.rows, self.packets + other.packets
        return _Span(rows, packets, min(self.first, other.first), max(self.last, other.last))


def ordered_types(log: Packets) -> list[TypeCount]:
    """Returns the types in the order of sets and descriptors; fields that cannot be decoded are last in each set."""
    rate = _Rates(log).of
    return [
        TypeCount(n, d, kind, name, span.rows, rate(n, span) if kind else None)
        for n, d, kind, name, span in _types(log)
    ]


class _Rates:
    """The intervals between the packets of each set, by the same clock as in `mip info`."""

    def __init__(self, log: Packets) -> None:
        self._log = log
        self._intervals: dict[int, Intervals] = {}
        pieces = [(piece.sets, piece.number) for piece in log.pieces()]
        self._sets = np.concatenate([sets for sets, _ in pieces]) if pieces else np.zeros(0, np.uint8)

    def of(self, number: int, span: _Span) -> float | None:
        """Returns the rate of some fields of a set, in Hz."""
        if number < 0x80:
            return None
        if number not in self._intervals:
            self._intervals[number] = times.intervals(self._log, number)
        same = np.count_nonzero(self._sets[span.first : span.last + 1] == number)
        return self._intervals[number].rate_of(span.packets, int(same))


def decodable(log: Packets) -> list[tuple[int, type[Field]]]:
    """Returns the sets and types of all fields that can be decoded, in the same order."""
    return [(n, kind) for n, _, kind, *_ in _types(log) if kind is not None]


def _types(log: Packets) -> list[tuple[int, int, type[Field] | None, str, _Span]]:
    rows: list[tuple[int, int, type[Field] | None, str, _Span]] = []
    for (number, descriptor), lengths in sorted(_lengths(log).items()):
        every = _together(list(lengths.values()))
        left = every.rows
        for kind in registry.types(number, descriptor):
            span = _decodable(log, number, kind, lengths)
            if span is not None:
                rows.append((number, descriptor, kind, kind.name_in(number), span))
                left -= span.rows
        if left:
            name = f"0x{number:02X},0x{descriptor:02X}"
            rows.append((number, descriptor, None, name, every._replace(rows=left)))
    return rows


def _together(spans: list[_Span]) -> _Span:
    total = spans[0]
    for span in spans[1:]:
        total = total.and_(span)
    return total


def _decodable(log: Packets, number: int, kind: type[Field], lengths: dict[int, _Span]) -> _Span | None:
    """Counts the decodable fields of a type; None if there are none."""
    shape = layout.layout(kind)
    if shape is not None and shape.plain and len(registry.types(number, kind.DESCRIPTOR)) == 1:
        spans = [span for length, span in lengths.items() if length >= shape.dtype.itemsize]
        return _together(spans) if spans else None
    packet = log.column(kind, number).packet
    return _Span.of(packet) if len(packet) else None


def _lengths(log: Packets) -> dict[tuple[int, int], dict[int, _Span]]:
    """(set, descriptor) -> length of the data -> the fields."""
    by_key: dict[tuple[int, int], dict[int, _Span]] = {}
    for piece in log.pieces():
        packets: dict[tuple[int, int, int], list[Array]] = {}
        for run in piece.runs or ():
            packets.setdefault((run.set, run.descriptor, run.length), []).append(run.packet + piece.number)
        for (number, descriptor, length), several in packets.items():
            span = _Span.of(several[0] if len(several) == 1 else np.sort(np.concatenate(several)))
            lengths = by_key.setdefault((number, descriptor), {})
            old = lengths.get(length)
            lengths[length] = span if old is None else old.and_(span)
    return by_key
