"""Lists the contents of a log: the number of fields of each type, and their rates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from ..binding import Field, registry
from . import layout, times

if TYPE_CHECKING:
    from .log import Log


@dataclass(frozen=True)
class TypeCount:
    """The number of fields of a type in a log."""

    set: int  # the set of their packets
    descriptor: int
    type: type[Field] | None  # None: unknown, or not decodable
    name: str
    count: int
    rate: float | None  # in Hz, if the times of the first and of the last one are known


class _Span(NamedTuple):
    """The number of some fields, and the first and the last packet that has one."""

    rows: int
    first: int
    last: int

    def and_(self, other: _Span) -> _Span:
        return _Span(self.rows + other.rows, min(self.first, other.first), max(self.last, other.last))


def types(log: Log) -> list[TypeCount]:
    """Returns the types in the order of sets and descriptors; fields that cannot be decoded are last in each set."""
    return [
        TypeCount(n, d, kind, name, span.rows, times.rate(log, n, *span) if kind else None)
        for n, d, kind, name, span in _types(log)
    ]


def kinds(log: Log) -> list[tuple[int, type[Field]]]:
    """Returns the sets and types of all fields that can be decoded, in the same order."""
    return [(n, kind) for n, _, kind, *_ in _types(log) if kind is not None]


def _types(log: Log) -> list[tuple[int, int, type[Field] | None, str, _Span]]:
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


def _decodable(log: Log, number: int, kind: type[Field], lengths: dict[int, _Span]) -> _Span | None:
    """Counts the decodable fields of a type; None if there are none."""
    shape = layout.layout(kind)
    if shape is not None and shape.plain and len(registry.types(number, kind.DESCRIPTOR)) == 1:
        spans = [span for length, span in lengths.items() if length >= shape.dtype.itemsize]
        return _together(spans) if spans else None
    packet = log.column(kind, number).packet
    return _Span(len(packet), int(packet[0]), int(packet[-1])) if len(packet) else None


def _lengths(log: Log) -> dict[tuple[int, int], dict[int, _Span]]:
    """(set, descriptor) -> length of the data -> the fields."""
    by_key: dict[tuple[int, int], dict[int, _Span]] = {}
    for piece in log.pieces():
        for run in piece.runs or ():
            first, last = int(run.packet[0]) + piece.number, int(run.packet[-1]) + piece.number
            span = _Span(len(run.packet), first, last)
            lengths = by_key.setdefault((run.set, run.descriptor), {})
            old = lengths.get(run.length)
            lengths[run.length] = span if old is None else old.and_(span)
    return by_key
