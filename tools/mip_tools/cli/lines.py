"""The lines of `mip dump` for whole files, by columns: the same as of packet by packet, but faster."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import OVERHEAD, Field, Packet, Parameter, RawField, info, named, registry
from ..columns import layout, walk
from ..columns.reader import Reader
from ..columns.scan import HEADER, Array
from ..columns.text import shortest
from . import objects, show
from .decoding import Found, decoded
from .selection import Selection

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.column import Column
    from ..columns.piece import Piece

#: Bytes of the log whose lines are in memory together.
PART = 1 << 20


#: The format of a value, and its argument.
Texts = tuple[str, list[list[Any]]]


class Lines:
    """Formats packets as `show.line` does."""

    def __init__(self, device: str | None) -> None:
        self.device = device

    def packet(self, at: int, packet: Packet, selection: Selection) -> str:
        return f"{at:08x} {show.line(packet, show.selected(packet, selection), self.device)}"

    def joined(self, at: int, number: int, fields: list[str]) -> str:
        return " ".join([f"{at:08x} {show.set_name(number)}:", *fields])

    def field(self, found: Found) -> str:
        return show.short(found, show.set_name(found.raw.set)) + show.inside(found, self.device)

    def fields(self, column: Column[Any], kind: type[Field], number: int) -> list[str] | None:
        """The texts of all rows; None if they depend on more than a value."""
        name = kind.name_in(number).removeprefix(f"{show.set_name(number)}.")
        own = kind.NAME.partition(".")[2]
        parts: list[str] = []
        values: list[list[Any]] = []
        for p in info(kind).members:
            made = self.texts(p, column)
            if made is None:
                return None
            form, given = made
            parts.append(("" if p.name == own else f"{p.name}=") + form)
            values += given
        if not values:
            return [f"{name}()"] * len(column)
        one = len(parts) == 1 and parts[0].startswith("(")
        template = name + (parts[0] if one else f"({', '.join(parts)})")
        return list(map(template.__mod__, zip(*values)))

    def texts(self, p: Parameter, column: Column[Any]) -> Texts | None:
        """How a parameter is formatted, and what with, as `Parameter.format` does."""
        p = p if self.device is None else p.on(self.device)
        values = _plain(p, column)
        if values is None:
            return None
        form, given = _names(p, values, p.format) if _is_named(p) else _numbers(p, values)
        if p.flags:
            good = column.valid(p.attribute)
            good = good if good.ndim == 1 else np.asarray(good.all(axis=1))
            if not good.all():
                return form + "%s", [*given, np.where(good, "", " (invalid)").tolist()]
        return form, given


class Objects:
    """Packets as JSON objects."""

    def __init__(self, device: str | None) -> None:
        self.device = device

    def packet(self, at: int, packet: Packet, selection: Selection) -> str:
        return objects.packet(at, packet, show.selected(packet, selection), self.device)

    def joined(self, at: int, number: int, fields: list[str]) -> str:
        return objects.joined(at, number, fields)

    def field(self, found: Found) -> str:
        return objects.field(found, self.device)

    def fields(self, column: Column[Any], kind: type[Field], number: int) -> list[str] | None:
        """The texts of all rows; None if they depend on more than a value."""
        parts: list[str] = []
        values: list[list[Any]] = []
        for p in info(kind).members:
            made = self.texts(p, column)
            if made is None:
                return None
            parts.append(f"{json.dumps(p.name)}: {made[0]}")
            values += made[1]
        head = f'{{"field": {json.dumps(kind.name_in(number))}, "values": {{'
        if not values:
            return [head + "}}"] * len(column)
        template = f"{head}{', '.join(parts)}}}}}"
        return list(map(template.__mod__, zip(*values)))

    def texts(self, p: Parameter, column: Column[Any]) -> Texts | None:
        """How a parameter is formatted, and what with, as `to_dict` has it."""
        p = p if self.device is None else p.on(self.device)
        values = _plain(p, column)
        if values is None:
            return None
        if _is_named(p):
            return _names(p, values, lambda value: json.dumps(named(p, value)))
        single, given = _singles(values)
        if single == "%r" and not np.isfinite(values).all():
            single = "%s"
            given = [[repr(x) if math.isfinite(x) else "null" for x in each] for each in given]
        if not p.elements:
            return single, given
        return f"{{{', '.join([f'{json.dumps(e)}: {single}' for e in p.elements])}}}", given


def lines(log: Log, selection: Selection, form: Lines | Objects) -> Iterator[tuple[int, list[str]]]:
    """The lines of the packets that have a selected field, many at once, and how many packets they were found in."""
    for part in log.parts(PART):
        for piece in part.pieces():
            yield len(piece.at), _lines(part, piece, selection, form)


def _lines(log: Log, piece: Piece, selection: Selection, form: Lines | Objects) -> list[str]:
    keys: dict[tuple[int, int], list[walk.Run]] = {}
    covered = np.zeros(len(piece.at), np.int64)
    for run in piece.runs or ():
        covered += np.bincount(run.packet, minlength=len(covered)) * (run.length + 2)
        if selection.has(run.set, run.descriptor):
            keys.setdefault((run.set, run.descriptor), []).append(run)
    packets, offsets, texts = [np.zeros(0, np.int64)], [np.zeros(0, np.uint8)], []
    for (number, descriptor), runs in keys.items():
        packet, offset = walk.places(runs, len(piece.at))
        packets.append(packet)
        offsets.append(offset)
        texts += _fields(log, piece, number, descriptor, runs, packet, offset, form)
    where = np.concatenate(packets)
    order = np.lexsort((np.concatenate(offsets), where))
    ordered = np.array([*texts, ""], object)[order].tolist()  # one more, so that all texts are one dimension
    counts = np.bincount(where, minlength=len(piece.at))
    ends = np.cumsum(counts)
    shown = counts > 0 if not selection.everything else np.ones(len(piece.at), bool)
    numbers = np.flatnonzero(shown)
    malformed = set(np.flatnonzero(covered != piece.end - piece.at - OVERHEAD).tolist())
    found = []
    for i, at, number, end, count in zip(
        numbers.tolist(),
        (piece.at[numbers] + piece.begin).tolist(),
        piece.sets()[numbers].tolist(),
        ends[numbers].tolist(),
        counts[numbers].tolist(),
    ):
        if i in malformed:
            one = Packet(piece.data[piece.at[i] : piece.end[i]].tobytes())
            found.append(form.packet(at, one, selection))
        else:
            found.append(form.joined(at, number, ordered[end - count : end]))
    return found


def _fields(
    log: Log,
    piece: Piece,
    number: int,
    descriptor: int,
    runs: list[walk.Run],
    packet: Array,
    offset: Array,
    form: Lines | Objects,
) -> list[str]:
    """The texts of fields of one set and descriptor."""
    types = registry.types(number, descriptor)
    shape = layout.layout(types[0]) if len(types) == 1 else None
    if shape is not None and shape.plain and all(run.length == shape.dtype.itemsize for run in runs):
        reader = Reader(log, (number, types[0]), None)
        reader.add(piece)
        made = form.fields(reader.column(), types[0], number)
        if made is not None:
            return made
    begin = piece.at[packet] + HEADER + offset
    size = piece.data[begin - 2].astype(np.int64) - 2
    return [
        form.field(decoded(RawField(number, descriptor, piece.data[at : at + length].tobytes())))
        for at, length in zip(begin.tolist(), size.tolist())
    ]


def _plain(p: Parameter, column: Column[Any]) -> Array | None:
    """The values of a parameter, if each is a number, a name or a vector, whatever the other values are."""
    if p.attribute not in column.names or any(v.by != "device" for v in p.variants):
        return None
    if p.length is not None or p.scalar in ("char", "bits") or p.kind not in ("scalar", "array"):
        return None
    values: Array = column[p.attribute]
    return None if values.ndim > 1 and _is_named(p) else values


def _is_named(p: Parameter) -> bool:
    return p.type is not None or p.scalar == "bool"


def _names(p: Parameter, values: Array, word: Callable[[Any], str]) -> Texts:
    """Each value that occurs is formatted once."""
    known, place = np.unique(values, return_inverse=True)
    as_bool = p.scalar == "bool" and p.type is None
    words = [word(bool(v) if as_bool and v in (0, 1) else v) for v in known.tolist()]
    return "%s", [np.array([*words, ""], object)[place.reshape(-1)].tolist()]


def _singles(values: Array) -> Texts:
    """How each number is formatted, and the numbers, by elements of a vector."""
    numbers = shortest(values.reshape(-1)).reshape(values.shape) if values.dtype == np.float32 else values
    return "%r" if values.dtype.kind == "f" else "%d", numbers.T.tolist() if values.ndim > 1 else [numbers.tolist()]


def _numbers(p: Parameter, values: Array) -> Texts:
    single, given = _singles(values)
    if not p.elements:
        return single + _unit(p.units[:1]), given
    many = len(set(p.units)) > 1
    units = [_unit((unit,)) for unit in p.units] if many else [""] * len(p.elements)
    if len(p.elements) > 4:
        inner = ", ".join([single] * len(p.elements))
    else:
        inner = ", ".join(f"{name}={single}{unit}" for name, unit in zip(p.elements, units))
    return f"({inner})" + ("" if many else _unit(p.units[:1])), given


def _unit(units: tuple[str, ...]) -> str:
    return f" {units[0]}".replace("%", "%%") if units and units[0] not in ("", "1") else ""
