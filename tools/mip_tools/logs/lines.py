"""Makes the lines of `mip dump` for whole files from columns: the same lines as packet by packet, but faster."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import OVERHEAD, Field, Packet, Parameter, info, registry, to_text
from ..columns import layout, walk
from ..columns.reader import Reader
from ..columns.scan import Array
from ..names.selection import Selection
from ..text import objects, row_texts, show
from ..text.decoding import DecodedField, decoded_field

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.column import Column
    from ..columns.piece import Piece

#: Bytes of the log whose lines are in memory at the same time.
PART = 1 << 20


class Lines:
    """Formats packets as `show.line` does."""

    def __init__(self, device: str | None) -> None:
        self.device = device

    def packet(self, at: int, packet: Packet, selection: Selection) -> str:
        return f"{at:08x} {show.line(packet, show.selected(packet, selection), self.device)}"

    def joined(self, at: int, number: int, fields: list[str]) -> str:
        return " ".join([f"{at:08x} {show.set_name(number)}:", *fields])

    def field(self, field: DecodedField) -> str:
        return show.short(field, show.set_name(field.raw.set)) + show.inside(field, self.device)

    def fields(self, column: Column[Any], kind: type[Field], number: int) -> list[str] | None:
        """Formats all rows; None if a text depends on more than one value."""
        name = kind.name_in(number).removeprefix(f"{show.set_name(number)}.")
        own = kind.NAME.partition(".")[2]
        parts: list[str] = []
        values: list[Array] = []
        for p in info(kind).members:
            made = self.texts(p, column)
            if made is None:
                return None
            form, arguments = made
            parts.append(("" if p.name == own else f"{p.name}=") + form)
            values += arguments
        is_vector = len(parts) == 1 and parts[0].startswith("(")
        template = name + (parts[0] if is_vector else f"({', '.join(parts)})")
        return [text.decode() for text in row_texts.formatted_rows(template, values, len(column))]

    def texts(self, p: Parameter, column: Column[Any]) -> row_texts.Texts | None:
        """Returns the format of a parameter and its values; filled in, they are what `Parameter.format` returns."""
        p = p if self.device is None else p.on(self.device)
        values = row_texts.plain_texts(p, column)
        if values is None:
            return None
        if row_texts.is_named(p):
            form, arguments = row_texts.name_texts(p, column, lambda value, holder: to_text(p, value, holder, None))
        else:
            form, arguments = _numbers(p, values)
        if p.flags:
            good = column.valid(p.attribute)
            good = good if good.ndim == 1 else np.asarray(good.all(axis=1))
            if not good.all():
                return form + "%s", [*arguments, np.where(good, "", " (invalid)")]
        return form, arguments


class Objects:
    """Packets as JSON objects."""

    def __init__(self, device: str | None) -> None:
        self.device = device

    def packet(self, at: int, packet: Packet, selection: Selection) -> str:
        return objects.packet(at, packet, show.selected(packet, selection), self.device)

    def joined(self, at: int, number: int, fields: list[str]) -> str:
        return objects.packet_object(at, number, fields)

    def field(self, field: DecodedField) -> str:
        return objects.field_object(field, self.device)

    def fields(self, column: Column[Any], kind: type[Field], number: int) -> list[str] | None:
        """Formats all rows; None if a text depends on more than one value."""
        made = row_texts.json_object(column, kind, self.device)
        if made is None:
            return None
        head = f'{{"field": {json.dumps(kind.name_in(number))}, "values": '
        return [text.decode() for text in row_texts.formatted_rows(f"{head}{made[0]}}}", made[1], len(column))]


def object_lines(log: Log, selection: Selection, form: Lines | Objects) -> Iterator[tuple[int, list[str]]]:
    """Yields the lines of the packets that have a selected field, many at once, each time with the number of packets
    that were searched."""
    for part in log.parts(PART):
        for piece in part.pieces():
            yield len(piece.at), _lines(part, piece, selection, form)


def _lines(log: Log, piece: Piece, selection: Selection, form: Lines | Objects) -> list[str]:
    runs = []
    covered = np.zeros(len(piece.at), np.int64)
    for run in piece.runs or ():
        covered += np.bincount(run.packet, minlength=len(covered)) * (run.length + 2)
        if selection.has(run.set, run.descriptor):
            runs.append(run)
    where, texts, _ = walk.in_order(runs, lambda *alike: _fields(log, piece, form, *alike))
    counts = np.bincount(where, minlength=len(piece.at))
    ends = np.cumsum(counts)
    shown = counts > 0 if not selection.everything else np.ones(len(piece.at), bool)
    numbers = np.flatnonzero(shown)
    malformed = set(np.flatnonzero(covered != piece.end - piece.at - OVERHEAD).tolist())
    lines_found = []
    for i, at, number, end, count in zip(
        numbers.tolist(),
        (piece.at[numbers] + piece.begin).tolist(),
        piece.sets[numbers].tolist(),
        ends[numbers].tolist(),
        counts[numbers].tolist(),
    ):
        if i in malformed:
            packet = Packet(piece.data[piece.at[i] : piece.end[i]].tobytes())
            lines_found.append(form.packet(at, packet, selection))
        else:
            lines_found.append(form.joined(at, number, texts[end - count : end]))
    return lines_found


def _fields(
    log: Log, piece: Piece, form: Lines | Objects, number: int, descriptor: int, runs: list[walk.Run]
) -> tuple[Array, Array, list[str]]:
    """Formats the fields of one set and descriptor. Returns their packets, their offsets in the payloads, the texts."""
    packet, offset = walk.packets_and_offsets(runs, len(piece.at))
    types = registry.types(number, descriptor)
    shape = layout.layout(types[0]) if len(types) == 1 else None
    if shape is not None and shape.plain and all(run.length == shape.dtype.itemsize for run in runs):
        reader = Reader(log, (number, types[0]), None)
        reader.add(piece)
        made = form.fields(reader.column(), types[0], number)
        if made is not None:
            return packet, offset, made
    return packet, offset, [form.field(decoded_field(raw)) for raw in piece.fields(descriptor, packet, offset)]


def _numbers(p: Parameter, values: Array) -> row_texts.Texts:
    single, arguments = row_texts.singles(values)
    if not p.elements:
        return single + _unit(p.units[:1]), arguments
    many = len(set(p.units)) > 1
    units = [_unit((unit,)) for unit in p.units] if many else [""] * len(p.elements)
    if len(p.elements) > 4:
        inner = ", ".join([single] * len(p.elements))
    else:
        inner = ", ".join(f"{name}={single}{unit}" for name, unit in zip(p.elements, units))
    return f"({inner})" + ("" if many else _unit(p.units[:1])), arguments


def _unit(units: tuple[str, ...]) -> str:
    return f" {units[0]}".replace("%", "%%") if units and units[0] not in ("", "1") else ""
