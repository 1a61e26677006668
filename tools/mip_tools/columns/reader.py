"""Reads the fields of one type, piece by piece."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..binding import DecodeError, Field, chosen, info, registry
from ..names.occurrence import named_set, sets_of
from . import general, layout, walk
from .column import Column
from .packets import Kind, Packets
from .piece import Piece, Where
from .rows import Rows
from .scan import Array


class Reader:
    """Collects the rows of a column."""

    def __init__(self, log: Packets, kind: Kind, set_number: int | None) -> None:
        """Prepares for fields of this type. Raises LookupError if the specification does not define it in that set."""
        name, named_number = repr(kind), None
        if isinstance(kind, str):
            kind = registry.by_name(name := kind)
            named_number = named_set(name, kind)
        elif isinstance(kind, tuple) and len(kind) == 2:
            named_number, kind = kind
        if not (isinstance(kind, type) and issubclass(kind, Field) and hasattr(kind, "SETS")):
            raise LookupError(f"{name} is not a field: a column needs a class such as sensor.ScaledAccel, or its name")
        if set_number is not None and named_number not in (None, set_number, 0, registry.SHARED_SET):
            raise KeyError(f"set 0x{set_number:02X} has no field {name}")
        sets = sets_of(kind)
        if set_number is None:
            set_number = named_number if sets or named_number not in (0, registry.SHARED_SET) else None
        self._log, self._kind = log, kind
        #: The set of all rows; None if several are possible.
        self.set = sets[0] if set_number is None and len(sets) == 1 else set_number
        self._cache: dict[int, bool] = {}
        #: The sets to search; empty means all.
        self._sets = sets if self.set is None else (self.set,)
        if not all(map(self._in, self._sets or kind.SETS[:1])):
            where = "the specification" if set_number is None else f"set 0x{set_number:02X}"
            raise KeyError(f"{where} has no field {kind.NAME}")
        several = any(len(registry.types(n, kind.DESCRIPTOR)) > 1 for n in self._sets)
        self._layout = None if several else layout.layout(kind)
        self._rows = None if self._layout is None else Rows(self._layout, log.end)
        self._objects: list[Any] = []
        self._where = Where(self.set or 0)

    def _in(self, number: int) -> bool:
        """Can packets of a set have this field?"""
        if number not in self._cache:
            types = registry.types(number, self._kind.DESCRIPTOR)
            self._cache[number] = self.set in (None, number) and self._kind in types
        return self._cache[number]

    def _runs(self, piece: Piece) -> list[walk.Run]:
        """Finds the fields in a piece that have the right descriptor and enough data."""
        width = 0 if self._layout is None else self._layout.dtype.itemsize
        descriptor = self._kind.DESCRIPTOR
        return [
            run
            for run in piece.runs or ()
            if run.descriptor == descriptor and run.length >= width and self._in(run.set)
        ]

    def _fields(self, piece: Piece) -> tuple[Array, Array] | None:
        """Returns the packets of these fields, and their offsets in the payloads; None if there are none."""
        runs = self._runs(piece)
        if not runs:
            return None
        return walk.packets_and_offsets(runs, len(piece.at))

    def add(self, piece: Piece) -> None:
        """Adds the fields in a piece."""
        places = self._fields(piece)
        if places is None:
            return
        packet, offset = places
        if self._rows is not None:
            self._rows.add(piece, packet, offset)
        else:
            values = list(self._decoded(piece, packet, offset))
            packet = packet[np.array([v is not None for v in values], bool)]
            self._objects += [v for v in values if v is not None]
        self._where.add(piece, packet)

    def _decoded(self, piece: Piece, packet: Array, offset: Array) -> Iterator[Field | None]:
        """Decodes fields to objects; None for one that cannot be decoded, or has another type."""
        for raw in piece.fields(self._kind.DESCRIPTOR, packet, offset):
            kind = chosen(registry.types(raw.set, raw.descriptor), raw)
            try:
                yield kind._received(raw) if kind is self._kind else None
            except DecodeError:
                yield None

    def _one_of(self, present: list[int]) -> int | None:
        """Returns the only set in which the log has the field. Raises LookupError if there are several, which are never
        mixed."""
        if len(present) > 1:
            names = [self._kind.name_in(n) for n in present]
            raise LookupError(
                f"the log has {self._kind.NAME} in several sets: {', '.join(names)}; "
                f"select one, for example log[{names[0]!r}] or log.column({self._kind.__name__}, 0x{present[0]:02X})"
            )
        return next(iter(present), None)

    def column(self) -> Column[Any]:
        """Makes the column of all added fields."""
        values: dict[str, Any]
        right = None
        if self._rows is None or self._layout is None:
            values = general.general_columns(info(self._kind).parameters, self._objects)
        else:
            rows = self._rows.whole()
            fixed, right = layout.row_values(self._kind, rows, self._layout, self._rows.turned)
            values = dict(fixed)
        self._where.keep(right)
        only = self.set
        if only is None and self._sets:
            only = self._one_of(self._where.sets())
        return Column(self._log, self._kind, values, self._where, only)

    def objects(self) -> Iterator[Any]:
        """Yields the rows as objects."""
        if self.set is None and self._sets:
            self._one_of(sorted({run.set for piece in self._log.pieces() for run in self._runs(piece)}))
        for piece in self._log.pieces():
            places = self._fields(piece)
            if places is not None:
                yield from (v for v in self._decoded(piece, *places) if v is not None)
