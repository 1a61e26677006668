"""The columns of fields, and the rows of a log."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from ..binding import Field, Flag, Parameter, Structure, chosen, info, registry
from ..occurrence import Occurrence, of
from . import inputs, values
from .clocks import CLOCKS, Timeline, moments
from .decoding import decoded, raw_fields
from .selection import Selection


class Column(NamedTuple):
    """One value in each row. `get` finds it in a field; `valid` is its valid flag."""

    name: str
    unit: str
    parameter: Parameter
    get: Callable[[Any], Any]
    valid: Callable[[Any], bool] | None
    #: In `columns.Column`: the name, the element if it is one of several, and the flag with its name.
    path: str
    element: int | None
    flag: tuple[str, Flag] | None


class Sample(NamedTuple):
    """A field of a log, and when it was."""

    packet: int
    offset: int
    time: int | None
    own: bool
    kind: Occurrence
    value: Field


def columns(kind: type[Field]) -> list[Column]:
    """The columns of a field: vectors and structures are divided, lists of any length are not."""
    return list(_columns(kind, "", "", lambda field: field))


def _columns(kind: type[Structure], before: str, record: str, owner: Callable[[Any], Any]) -> Iterator[Column]:
    for p in info(kind).parameters:
        if p.derived:
            continue
        get = _member(owner, p.attribute)
        name, path = f"{before}{p.name}", f"{record}{p.attribute}"
        if p.kind == "struct":
            yield from _columns(p.type, f"{name}.", f"{path}.", get)
        elif p.kind == "array" and (labels := _labels(p)):
            for i, label in enumerate(labels):
                unit = p.units[i] if len(p.units) == len(labels) else "".join(p.units[:1])
                flag = _flag(p, i)
                valid, where = _valid(owner, flag), _flag_at(record, flag)
                element = _element(get, i)
                yield Column(f"{name}.{label}", _unit(unit), p, element, valid, path, i, where)
        else:
            flag = _flag(p, 0)
            valid, where = _valid(owner, flag), _flag_at(record, flag)
            yield Column(name, _unit(p.unit), p, get, valid, path, None, where)


def _labels(p: Parameter) -> tuple[Any, ...]:
    """What distinguishes the elements of a vector or of an array of fixed length."""
    if isinstance(p.type, type) and issubclass(p.type, Structure):
        return ()
    if p.elements:
        return p.elements if p.length is None else ()
    return tuple(range(p.length)) if isinstance(p.length, int) else ()


def _unit(unit: str) -> str:
    return "" if unit == "1" else unit


def _member(owner: Callable[[Any], Any], attribute: str) -> Callable[[Any], Any]:
    def get(field: Any) -> Any:
        held = owner(field)
        return None if held is None else getattr(held, attribute)

    return get


def _element(get: Callable[[Any], Any], i: int) -> Callable[[Any], Any]:
    def element(field: Any) -> Any:
        held = get(field)
        return None if held is None else held[i]

    return element


def _flag(p: Parameter, i: int) -> Flag | None:
    """What vouches for an element."""
    return p.flags[i if len(p.flags) > 1 else 0] if p.flags else None


def _flag_at(record: str, flag: Flag | None) -> tuple[str, Flag] | None:
    return None if flag is None else (f"{record}{flag.attribute}", flag)


def _valid(owner: Callable[[Any], Any], flag: Flag | None) -> Callable[[Any], bool] | None:
    if flag is None:
        return None

    def valid(field: Any) -> bool:
        held = getattr(owner(field), flag.attribute)
        return held is not None and flag.holds(held)

    return valid


def cell(column: Column, field: Any, named: bool) -> Any:
    """The value of a column in a field: a number, a text, None, or a list for JSON."""
    held = column.get(field)
    if held is None or isinstance(held, (float, bool)):
        return held
    if isinstance(held, str):
        return held.strip("\0 ")
    if isinstance(held, int):
        return values.words(column.parameter, held) if named else int(held)
    if isinstance(held, Structure):
        return values.plain(held, named)
    return [values.plain(v, named) if isinstance(v, Structure) else v for v in held]


# --------------------------------------------------------------------------- what is in a log


def survey(name: str, selection: Selection) -> tuple[list[Occurrence], str | None]:
    """The types of the fields that a log has and a selection wants, by number; and its best clock."""
    first: dict[Occurrence, tuple[int, int]] = {}
    single: set[tuple[int, int]] = set()  # has one layout, and is known
    clocks: set[str] = set()
    for piece in inputs.pieces(name):
        if piece.packet is None:
            continue
        if next(iter(CLOCKS), None) not in clocks:
            said = moments(piece.packet)
            clocks.update(clock for clock, time in said.items() if time is not None)
        for raw in raw_fields(piece.packet):
            key = (raw.set, raw.descriptor)
            if key in single or not selection.has(*key):
                continue
            types = registry.types(*key)
            kind = chosen(types, raw)
            if kind is not None and decoded(raw).value is not None:
                first.setdefault(of(raw.set, kind), key)
                if len(types) == 1:
                    single.add(key)
    best = next((clock for clock in CLOCKS if clock in clocks), None)
    return sorted(first, key=lambda kind: first[kind]), best


def samples(name: str, wanted: Sequence[Occurrence], selection: Selection, clock: str | None) -> Iterator[list[Sample]]:
    """The fields of these types that a selection has, those of one packet together."""
    line = Timeline(clock)
    number = -1
    selected = set(wanted)
    keys: dict[tuple[int, int], bool] = {}
    for piece in inputs.pieces(name):
        if piece.packet is None:
            continue
        number += 1
        time, own = line.at(piece.packet, piece.offset)
        row = []
        for raw in raw_fields(piece.packet):
            key = (raw.set, raw.descriptor)
            asked = keys.get(key)
            if asked is None:
                asked = any(of(raw.set, t) in selected for t in registry.types(*key))
                asked = keys[key] = asked and selection.has(*key)
            if asked:
                field = decoded(raw)
                if field.value is None or field.kind is None:
                    continue
                one = of(raw.set, field.kind)
                if one in selected:
                    row.append(Sample(number, piece.offset, time, own, one, field.value))
        if row:
            yield row


def heading(kind: Occurrence, name: str, single: bool) -> str:
    """The name of a column in a table of one type or of several."""
    if single:
        return name
    set, _, short = kind.name.partition(".")
    one = name == short or name.startswith(f"{short}.")
    return f"{set}.{name}" if one else f"{kind.name}.{name}"


__all__ = ["Column", "Sample", "cell", "columns", "heading", "samples", "survey"]
