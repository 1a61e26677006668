"""Reads the fields of one type, piece by piece."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import registry
from ..errors import DecodeError
from ..field import Field, chosen
from ..packet import RawField
from ..reflection import PARAMETERS
from . import general, layout, walk
from .column import Column
from .piece import Piece, Where
from .rows import Rows
from .scan import HEADER, Array

if TYPE_CHECKING:
    from .log import Log


class Reader:
    """Collects the rows of a column."""

    def __init__(self, log: Log, kind: type[Field] | str, set: int | None) -> None:
        """Raises LookupError if the specification has no such type in that set."""
        if isinstance(kind, str):
            kind = registry.by_name(kind)
        elif not (isinstance(kind, type) and issubclass(kind, Field) and hasattr(kind, "SET")):
            raise LookupError(
                f"{kind!r} is not a field: a column needs a class such as sensor.ScaledAccel, or its name"
            )
        self._log, self._kind = log, kind
        self._set = set
        own = self._kind.SET if self._kind.SET not in (0, registry.SHARED_SET) else set
        if not self._in(own if own is not None else 0x80 if self._kind.SET else 1):
            where = "the specification" if set is None else f"set 0x{set:02X}"
            raise KeyError(f"{where} has no field {self._kind.NAME}")
        several = own is not None and len(registry.types(own, self._kind.DESCRIPTOR)) > 1
        self._layout = None if several else layout.layout(self._kind)
        self._rows = None if self._layout is None else Rows(self._layout, log.end)
        self._objects: list[Any] = []
        self._where = Where(own or 0)

    def _in(self, number: int) -> bool:
        """Have packets of a set this field?"""
        if self._set is not None and number != self._set:
            return False
        return self._kind in registry.types(number, self._kind.DESCRIPTOR)

    def _fields(self, piece: Piece) -> tuple[Array, Array] | None:
        """Packet, and offset in its payload, of the fields in a piece that have the right descriptor and are long enough."""
        width = 0 if self._layout is None else self._layout.dtype.itemsize
        descriptor = self._kind.DESCRIPTOR
        runs = [
            run
            for run in piece.runs or ()
            if run.descriptor == descriptor and run.length >= width and self._in(run.set)
        ]
        if not runs:
            return None
        return walk.places(runs, len(piece.at))

    def add(self, piece: Piece) -> None:
        """Adds what is in a piece."""
        found = self._fields(piece)
        if found is None:
            return
        packet, offset = found
        if self._rows is not None:
            self._rows.add(piece, packet, offset)
        else:
            values = list(self._decoded(piece, packet, offset))
            packet = packet[np.array([v is not None for v in values], bool)]
            self._objects += [v for v in values if v is not None]
        self._where.add(piece, packet)

    def _decoded(self, piece: Piece, packet: Array, offset: Array) -> Iterator[Field | None]:
        """The objects; None where they cannot be decoded, or have another type."""
        place = piece.at[packet] + HEADER + offset
        sets, sizes = piece.data[piece.at[packet] + 2], piece.data[place - 2]
        for number, begin, size in zip(sets.tolist(), place.tolist(), sizes.tolist()):
            data = piece.data[begin : begin + size - 2].tobytes()
            raw = RawField(number, self._kind.DESCRIPTOR, data)
            kind = chosen(registry.types(number, self._kind.DESCRIPTOR), raw)
            try:
                yield kind._read(data, 0)[0] if kind is self._kind else None
            except DecodeError:
                yield None

    def column(self) -> Column[Any]:
        """What was added."""
        values: dict[str, Any]
        right = None
        if self._rows is None or self._layout is None:
            values = general.columns(PARAMETERS[self._kind], self._objects)
        else:
            rows = self._rows.whole()
            fixed, right = layout.values(self._kind, rows, self._layout, self._rows.turned)
            values = dict(fixed)
        self._where.keep(right)
        return Column(self._log, self._kind, values, self._where, self._set)

    def objects(self) -> Iterator[Any]:
        """The rows as objects."""
        for piece in self._log.pieces():
            found = self._fields(piece)
            if found is not None:
                yield from (v for v in self._decoded(piece, *found) if v is not None)
