"""Lists the contents of a log: the number of fields of each type, and their rates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..binding import Field, registry
from . import layout, times
from .intervals import Intervals, Share
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
    """The number of some fields, and the instants that have any."""

    rows: int
    share: Share

    def and_(self, other: _Span) -> _Span:
        """Returns both; the other fields are later in the log."""
        return _Span(self.rows + other.rows, self.share.and_(other.share))


def ordered_types(log: Packets) -> list[TypeCount]:
    """Returns the types in the order of sets and descriptors; fields that cannot be decoded are last in each set."""
    rates = _Rates(log)
    return [
        TypeCount(n, d, kind, name, span.rows, rates.of(n, span.share) if kind else None)
        for n, d, kind, name, span in _types(log, rates.number)
    ]


class _Rates:
    """The intervals between the packets of each set, by the same clock as in `mip info`."""

    def __init__(self, log: Packets) -> None:
        self._intervals: dict[int, Intervals] = {}
        pieces = [piece.sets for piece in log.pieces()]
        sets = np.concatenate(pieces) if pieces else np.zeros(0, np.uint8)
        #: The number of the instant of each packet, in its set.
        self.number = np.zeros(len(sets), np.int64)
        for number in log.sets():
            stamps = times.steady_timestamps(log, number) if number >= 0x80 else None
            if stamps is not None:
                packets, made = np.flatnonzero(sets == number), Intervals()
                self.number[packets] = made.add_set(packets, stamps, {})
                self._intervals[number] = made

    def of(self, number: int, share: Share) -> float | None:
        """Returns the rate of some fields of a set, in Hz."""
        return self._intervals[number].rate_of_share(share) if number in self._intervals else None


def decodable(log: Packets) -> list[tuple[int, type[Field]]]:
    """Returns the sets and types of all fields that can be decoded, in the same order."""
    return [(n, kind) for n, _, kind, *_ in _types(log) if kind is not None]


def _types(log: Packets, numbers: Array | None = None) -> list[tuple[int, int, type[Field] | None, str, _Span]]:
    """`numbers`: the number of the instant of each packet, if the rates matter."""
    rows: list[tuple[int, int, type[Field] | None, str, _Span]] = []
    for (number, descriptor), (every, lengths) in sorted(_lengths(log, numbers).items()):
        left = every.rows
        for kind in registry.types(number, descriptor):
            span = _decodable(log, number, kind, every, lengths, numbers)
            if span is not None:
                rows.append((number, descriptor, kind, kind.name_in(number), span))
                left -= span.rows
        if left:
            name = f"0x{number:02X},0x{descriptor:02X}"
            rows.append((number, descriptor, None, name, every._replace(rows=left)))
    return rows


def _decodable(
    log: Packets, number: int, kind: type[Field], every: _Span, lengths: set[int], numbers: Array | None
) -> _Span | None:
    """Counts the decodable fields of a type; None if there are none."""
    shape = layout.layout(kind)
    if shape is not None and shape.plain and len(registry.types(number, kind.DESCRIPTOR)) == 1:
        long_enough = [length >= shape.dtype.itemsize for length in lengths]
        if all(long_enough) or not any(long_enough):
            return every if any(long_enough) else None
    packet = log.column(kind, number).packet
    return _span(packet, numbers) if len(packet) else None


def _span(packet: Array, numbers: Array | None) -> _Span:
    """Returns that of the fields in these packets, in their order."""
    return _Span(len(packet), Share() if numbers is None else Share.of(numbers[packet]))


def _lengths(log: Packets, numbers: Array | None) -> dict[tuple[int, int], tuple[_Span, set[int]]]:
    """(set, descriptor) -> the fields, and the lengths of their data."""
    by_key: dict[tuple[int, int], tuple[_Span, set[int]]] = {}
    for piece in log.pieces():
        packets: dict[tuple[int, int], list[Array]] = {}
        lengths: dict[tuple[int, int], set[int]] = {}
        for run in piece.runs or ():
            packets.setdefault((run.set, run.descriptor), []).append(run.packet + piece.number)
            lengths.setdefault((run.set, run.descriptor), set()).add(run.length)
        for key, several in packets.items():
            span = _span(several[0] if len(several) == 1 else np.sort(np.concatenate(several)), numbers)
            old, known = by_key.get(key, (_Span(0, Share()), set()))
            by_key[key] = old.and_(span), known | lengths[key]
    return by_key
