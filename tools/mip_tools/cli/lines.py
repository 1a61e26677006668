"""The lines of `mip dump` for whole files, by columns: the same as `show.line` makes of each packet, but faster."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import OVERHEAD, Field, Packet, Parameter, RawField, info, registry
from ..columns import layout, walk
from ..columns.reader import Reader
from ..columns.scan import HEADER, Array
from ..columns.text import shortest
from . import show
from .decoding import decoded
from .selection import Selection

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.column import Column
    from ..columns.piece import Piece

#: Bytes of the log whose lines are in memory together.
PART = 1 << 20


def lines(log: Log, selection: Selection, device: str | None) -> Iterator[tuple[int, list[str]]]:
    """The lines of the packets that have a selected field, many at once, and how many packets they were found in."""
    for part in log.parts(PART):
        for piece in part.pieces():
            yield len(piece.at), _lines(part, piece, selection, device)


def _lines(log: Log, piece: Piece, selection: Selection, device: str | None) -> list[str]:
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
        texts += _fields(log, piece, number, descriptor, runs, packet, offset, device)
    where = np.concatenate(packets)
    order = np.lexsort((np.concatenate(offsets), where))
    ordered = np.array([*texts, ""], object)[order].tolist()  # one more, so that all texts are one dimension
    counts = np.bincount(where, minlength=len(piece.at))
    ends = np.cumsum(counts)
    shown = counts > 0 if not selection.everything else np.ones(len(piece.at), bool)
    numbers = np.flatnonzero(shown)
    malformed = set(np.flatnonzero(covered != piece.end - piece.at - OVERHEAD).tolist())
    names = [f"{show.set_name(number)}:" for number in range(256)]
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
            found.append(f"{at:08x} {show.line(one, show.selected(one, selection), device)}")
        else:
            found.append(" ".join([f"{at:08x} {names[number]}", *ordered[end - count : end]]))
    return found


def _fields(
    log: Log,
    piece: Piece,
    number: int,
    descriptor: int,
    runs: list[walk.Run],
    packet: Array,
    offset: Array,
    device: str | None,
) -> list[str]:
    """The texts of fields of one set and descriptor."""
    types = registry.types(number, descriptor)
    shape = layout.layout(types[0]) if len(types) == 1 else None
    if shape is not None and shape.plain and all(run.length == shape.dtype.itemsize for run in runs):
        reader = Reader(log, (number, types[0]), None)
        reader.add(piece)
        made = _by_columns(reader.column(), types[0], number, device)
        if made is not None:
            return made
    begin = piece.at[packet] + HEADER + offset
    size = piece.data[begin - 2].astype(np.int64) - 2
    set_name = show.set_name(number)
    texts = []
    for at, length in zip(begin.tolist(), size.tolist()):
        field = decoded(RawField(number, descriptor, piece.data[at : at + length].tobytes()))
        texts.append(show.short(field, set_name) + show.inside(field, device))
    return texts


def _by_columns(column: Column[Any], kind: type[Field], number: int, device: str | None) -> list[str] | None:
    """The same of all rows at once; None if the texts depend on more than a value."""
    name, set_name = kind.name_in(number), show.set_name(number)
    name = name.removeprefix(f"{set_name}.")
    own = kind.NAME.partition(".")[2]
    parts: list[str] = []
    values: list[list[Any]] = []
    for p in info(kind).members:
        here = p if device is None else p.on(device)
        made = _texts(here, column[p.attribute]) if p.attribute in column.names else None
        if made is None or any(v.by != "device" for v in p.variants):
            return None
        form, given = made
        if here.flags:
            good = column.valid(p.attribute)
            good = good if good.ndim == 1 else np.asarray(good.all(axis=1))
            if not good.all():
                form += "%s"
                given = [*given, np.where(good, "", " (invalid)").tolist()]
        parts.append(("" if p.name == own else f"{p.name}=") + form)
        values += given
    if not values:
        return [f"{name}()"] * len(column)
    one = len(parts) == 1 and parts[0].startswith("(")
    template = name + (parts[0] if one else f"({', '.join(parts)})")
    return list(map(template.__mod__, zip(*values)))


def _texts(p: Parameter, values: Any) -> tuple[str, list[list[Any]]] | None:
    """How a parameter is formatted, and what with, as `Parameter.format` does."""
    if p.length is not None or p.scalar in ("char", "bits") or p.kind not in ("scalar", "array"):
        return None
    if p.type is not None or p.scalar == "bool":
        if values.ndim > 1:
            return None
        known, place = np.unique(values, return_inverse=True)
        as_bool = p.scalar == "bool" and p.type is None
        words = [p.format(bool(v) if as_bool and v in (0, 1) else v) for v in known.tolist()]
        return "%s", [np.array([*words, ""], object)[place.reshape(-1)].tolist()]
    single = "%r" if values.dtype.kind == "f" else "%d"
    numbers = shortest(values.reshape(-1)).reshape(values.shape) if values.dtype == np.float32 else values
    if not p.elements:
        return single + _unit(p.units[:1]), [numbers.tolist()]
    many = len(set(p.units)) > 1
    units = [_unit((unit,)) for unit in p.units] if many else [""] * len(p.elements)
    if len(p.elements) > 4:
        inner = ", ".join([single] * len(p.elements))
    else:
        inner = ", ".join(f"{name}={single}{unit}" for name, unit in zip(p.elements, units))
    return f"({inner})" + ("" if many else _unit(p.units[:1])), numbers.T.tolist()


def _unit(units: tuple[str, ...]) -> str:
    return f" {units[0]}".replace("%", "%%") if units and units[0] not in ("", "1") else ""
