"""Makes messages of the fields of a log from columns: the same messages as packet by packet, but faster."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Collection, Iterator, Sequence
from typing import Any, Protocol

import numpy as np

from ..binding import Field, Structure, info, registry
from ..columns import Log, contents, layout, timeline, times, walk
from ..columns.column import Column
from ..columns.piece import Piece
from ..columns.reader import Reader
from ..columns.scan import Array
from ..columns.stamps import NONE
from ..logs import inputs
from ..logs.assumed import print_assumptions
from ..logs.recognize import need_packets
from ..names.occurrence import Occurrence, occurrence_in
from ..names.selection import Selection
from ..text import row_texts
from ..text.decoding import decoded_field
from ..text.show import Reads
from .json_messages import SEPARATORS, Batch, Topic, clock_of, encoded

#: Bytes of a log whose messages are in memory at the same time.
PART = 1 << 20

#: Rows of fields: their packets, the offsets of their data in the payloads, their kinds, or the one of all, and the
#: values made from them.
_Rows = tuple[Array, Array, list[Occurrence], list[Any]]
_NOTHING: _Rows = (np.zeros(0, np.int64), np.zeros(0, np.int64), [], [])


def survey_messages(log: Log, selection: Selection) -> tuple[list[Occurrence], timeline.Clocks]:
    """Finds the types of the selected fields in a log, in the order of their numbers, and the clocks of their sets."""
    found = {
        (number, kind)
        for part in log.parts(PART)
        for number, kind in contents.decodable(part)
        if selection.has(number, kind.DESCRIPTOR)
    }
    kinds = {occurrence_in(*pair) for pair in found}
    ordered = sorted(kinds, key=lambda occurrence: (occurrence.set, occurrence.kind.DESCRIPTOR, occurrence.kind.NAME))
    return ordered, timeline.of_log(log).clocks({number for number, _ in found if number >= 0x80})


class MessageExport:
    """The output for a log."""

    def __init__(self, name: str, options: argparse.Namespace, selection: Selection) -> None:
        self._name, self._options, self._selection = name, options, selection
        with inputs.open_columns(name, options.device, empty=True) as log:
            need_packets(options.file, log)
            self.types, clocks = survey_messages(log, selection)
            self._clock = clock_of(clocks, options) if self.types else ""
            print_assumptions("export", log, names=options.named)


#: Some rows of a column as objects.
Objects = Callable[[Array], Iterator[Field]]


class Form(Protocol):
    """Makes messages in one form."""

    reads: Reads  # as which device a field is read

    def rows(self, column: Column[Any], kind: Occurrence, objects: Objects) -> Sequence[Any] | None:
        """Makes the messages of all rows of a column; None if they depend on more than its values."""

    def field(self, field: Field, kind: Occurrence) -> Any:
        """Makes the message of a field."""


class Json:
    """Fields as JSON, with numbers or with names; `masked`: without the values that flags mark as invalid."""

    def __init__(self, named: bool, masked: bool = False) -> None:
        self._named, self._masked = named, masked
        self.reads: Reads = lambda kind: None

    def topic(self, kind: Occurrence | None) -> Topic:
        """Makes the topic of a field, or of gaps."""
        if kind is None:
            return Topic.of_gaps()
        return Topic.of_field(kind, self._named, self.reads(kind.kind))

    def rows(self, column: Column[Any], kind: Occurrence, objects: Objects) -> Sequence[bytes] | None:
        texts = row_texts.json_object(column, kind.kind, self.reads(kind.kind), self._named, SEPARATORS)
        if texts is None:
            return None
        messages = row_texts.formatted_rows(*texts, len(column))
        odd = np.zeros(len(column), bool)
        for name in column:
            if column[name].dtype.kind == "f":  # NaN and infinity, which JSON does not have, are left out
                odd |= ~np.isfinite(column[name]).reshape(len(column), -1).all(axis=1)
            if self._masked and column.parameters[name].flags:
                odd |= ~column.valid(name).reshape(len(column), -1).all(axis=1)
        rows = np.flatnonzero(odd)
        for row, field in zip(rows.tolist(), objects(rows)):
            messages[row] = self.field(field, kind)
        return messages

    def field(self, field: Field, kind: Occurrence) -> bytes:
        return encoded(field, self._named, self.reads(kind.kind), self._masked)


class Messages:
    """Makes the messages of some types of fields."""

    def __init__(
        self, kinds: Collection[Occurrence] | None, selection: Selection, clock: str | None, invalid: str, form: Form
    ) -> None:
        """`kinds`: the types; by default all that are selected."""
        self._kinds, self._selection, self._clock = None if kinds is None else set(kinds), selection, clock
        self._drops, self._form = invalid == "drop", form

    def of_log(self, log: Log, first: int = 0) -> Iterator[Batch]:
        """Yields the messages of a log, in the order of the fields. Its first packet has the number `first`."""
        for part, number in self.parts(log, first):
            yield from self.of_part(part, number)

    @staticmethod
    def parts(log: Log, number: int = 0) -> Iterator[tuple[Log, int]]:
        """Yields the parts of a log, each with the number of its first packet."""
        progress = inputs.Progress(log.size)
        for part in log.parts(PART):
            yield part, number
            number += part.packets
            progress.at(part.end)
        progress.clear()

    def of_part(self, part: Log, first: int) -> Iterator[Batch]:
        """Yields the messages of a part of a log, whose first packet has this number."""
        self._form.reads = part.reads
        for piece in part.pieces():
            yield self._of_piece(part, piece, first + piece.number)

    def kept(self, column: Column[Any]) -> Array:
        """Returns which rows of a column are kept: all, or those whose values are valid."""
        there = np.ones(len(column), bool)
        for name in column if self._drops else ():
            if column.parameters[name].flags:
                there &= column.valid(name).reshape(len(column), -1).all(axis=1)
        return there

    def _of_piece(self, part: Log, piece: Piece, first: int) -> Batch:
        """Makes the messages of a piece whose first packet has the number `first`."""
        kinds: dict[Occurrence, int] = {}
        columns: list[tuple[Array, Array, Array]] = [(np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0, bool))]

        def made(number: int, descriptor: int, runs: list[walk.Run]) -> tuple[Array, Array, list[Any]]:
            packet, offset, own, data = self._rows(part, piece, number, descriptor, runs)
            which = np.array([kinds.setdefault(kind, len(kinds)) for kind in own], np.int64)
            columns.append((np.broadcast_to(which, len(data)), *self._times(part, piece, number, packet)))
            return packet, offset, data

        wanted = [run for run in piece.runs or () if self._selection.has(run.set, run.descriptor)]
        packet, data, order = walk.in_order(wanted, made)
        kind, time, own = (np.concatenate(each)[order] for each in zip(*columns))
        return Batch(list(kinds), kind, time, own, packet + first, data)

    def _times(self, part: Log, piece: Piece, number: int, packet: Array) -> tuple[Array, Array]:
        """Returns the times of packets of a set, and whether each is in the packet itself."""
        if self._clock is None or number < 0x80:
            return np.full(len(packet), NONE, np.int64), np.zeros(len(packet), bool)
        places = piece.begin + piece.at[packet]
        return times.at(part, number, self._clock, packet + piece.number, lambda: places)

    def _rows(self, part: Log, piece: Piece, number: int, descriptor: int, runs: list[walk.Run]) -> _Rows:
        """Makes the messages of the fields with this set and descriptor."""
        every = registry.types(number, descriptor)
        if not any(self._has(occurrence_in(number, kind)) for kind in every):
            return _NOTHING
        shape = layout.layout(every[0]) if len(every) == 1 else None
        if shape is not None and shape.plain:
            runs = [run for run in runs if run.length >= shape.dtype.itemsize]
            if not runs:
                return _NOTHING
            rows = self._by_column(part, piece, occurrence_in(number, every[0]), number, runs)
            if rows is not None:
                return rows
        packet, offset = walk.packets_and_offsets(runs, len(piece.at))
        fields = list(_decoded(piece, descriptor, packet, offset))
        kept = [
            (row, *pair)
            for row, pair in enumerate(fields)
            if pair and self._has(pair[0]) and self._keeps(part, pair[1])
        ]
        left = [row for row, *_ in kept]
        data = [self._form.field(field, kind) for _, kind, field in kept]
        return packet[left], offset[left], [kind for _, kind, _ in kept], data

    def _has(self, kind: Occurrence) -> bool:
        return self._kinds is None or kind in self._kinds

    def _keeps(self, part: Log, field: Field) -> bool:
        return not self._drops or all_valid(field, part.reads(type(field)))

    def _by_column(self, part: Log, piece: Piece, kind: Occurrence, number: int, runs: list[walk.Run]) -> _Rows | None:
        """Makes the messages of fields of one type and one size from a column; None if the form cannot do so."""
        reader = Reader(part, (number, kind.kind), None)
        reader.add(piece)
        column = reader.column()
        packet, offset = walk.packets_and_offsets(runs, len(piece.at))

        def objects(rows: Array) -> Iterator[Field]:
            for raw in piece.fields(kind.kind.DESCRIPTOR, packet[rows], offset[rows]):
                value = decoded_field(raw).value
                assert value is not None  # any bytes of this size can be decoded
                yield value

        messages = self._form.rows(column, kind, objects)
        if messages is None:
            return None
        kept = self.kept(column)
        if kept.all():
            return packet, offset, [kind], list(messages)
        return packet[kept], offset[kept], [kind], [messages[row] for row in np.flatnonzero(kept).tolist()]


def _decoded(piece: Piece, descriptor: int, packet: Array, offset: Array) -> Iterator[tuple[Occurrence, Field] | None]:
    """Decodes fields to objects; None for a field that cannot be decoded."""
    for item in map(decoded_field, piece.fields(descriptor, packet, offset)):
        yield None if item.kind is None or item.value is None else (occurrence_in(item.raw.set, item.kind), item.value)


def all_valid(record: Structure, device: str | None) -> bool:
    """Are all values of a record valid according to its flags?"""
    for p in info(type(record)).parameters:
        for flag in p.flags_of(record, device):
            bits = getattr(record, flag.attribute)
            if bits is None or not flag.holds(bits):
                return False
        if p.kind == "struct" and not all_valid(getattr(record, p.attribute), device):
            return False
    return True
