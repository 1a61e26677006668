"""Straight-line code for fixed layouts: the bytes of each member."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count

from mipgen import model as m
from mipgen.lower import runs
from mipgen.lower.runs import Path, Run

from .literals import hexadecimal
from .names import c_type, field_name, member


@dataclass(frozen=True, slots=True)
class Inline:
    """The functions of a field that need no tables."""

    of: m.Field
    name: str
    several: bool  # does it occur in several sets?
    layouts: bool  # do other layouts share its descriptor?
    check: str  # a call that rejects other fields
    reserve: str  # a call that makes room in a packet
    statements: list[tuple[str, str]]  # read and write each member


def is_direct(f: m.Field) -> bool:
    """False if the layout varies or has constants, which need checks."""
    return bool(runs.runs(f))


def inline_view(f: m.Field, model: m.Model) -> Inline:
    return Inline(
        of=f,
        name=field_name(f),
        several=len(f.occurrences) > 1,
        layouts=len(model.layouts(f)) > 1,
        check=_in_its_sets(f, "mip_field_check(field, {set}, {descriptor}, {size})"),
        reserve=_in_its_sets(f, "mip_builder_reserve(builder, {set}, {descriptor}, {size}, &data)"),
        statements=[*map(_statements, runs.runs(f))],
    )


def _in_its_sets(f: m.Field, call: str) -> str:
    """Writes a call; for a field of several sets, it checks the set first."""
    several = len(f.occurrences) > 1
    number = "set" if several else hexadecimal(f.set)
    made = call.format(set=number, descriptor=hexadecimal(f.descriptor), size=f.min_size)
    return f"{_belongs(f.sets, 'set')} ? {made} : MIP_ERROR_SET" if several else made


def _belongs(numbers: Sequence[int], name: str) -> str:
    """Writes the condition that the variable `name` is one of these ascending numbers.

    >>> _belongs((0x81, 0x91, 0x92, 0x93), "set")
    'set == 0x81 || (set >= 0x91 && set <= 0x93)'
    """
    tests = []
    for first in (n for n in numbers if n - 1 not in numbers):
        last = next(n for n in count(first) if n + 1 not in numbers)
        inside = f"({name} >= {hexadecimal(first)} && {name} <= {hexadecimal(last)})"
        tests.append(inside if first < last else f"{name} == {hexadecimal(first)}")
    return " || ".join(tests)


# --------------------------------------------------------------------------- statements


def _statements(r: Run) -> tuple[str, str]:
    """Reads and writes a member, or one of the numbers or texts inside it."""
    scalar, member, source, target = (
        r.scalar,
        _member(r),
        at_offset("field->data", r.offset),
        at_offset("data", r.offset),
    )
    if r.count is None:
        return _get(scalar, source, member), put_number(scalar, target, member, cast=_cast(scalar) != "")
    if scalar.size == 1:
        end = f"\n{member}[{r.count}] = '\\0';" if r.parameter.kind == "text" else ""
        return f"memcpy({member}, {source}, {r.count});{end}", f"memcpy({target}, {member}, {r.count});"
    loop, step = f"for (size_t i = 0; i < {r.count}; i++) {{\n%s\n}}", f" + {scalar.size} * i"
    get = _get(scalar, source + step, f"{member}[i]")
    return loop % get, loop % put_number(scalar, target + step, f"{member}[i]", cast=_cast(scalar) != "")


def _get(scalar: m.Scalar, at: str, value: str) -> str:
    if scalar.kind == "float":
        return f"mip_get_{scalar.name}(&{value}, {at});"
    return f"{value} = {_cast(scalar)}mip_get_{scalar.width}({at});"


def put_number(scalar: m.Scalar, at: str, value: str, cast: bool = True) -> str:
    """Writes a number to a place in the data."""
    if scalar.kind == "float":
        return f"mip_put_{scalar.name}({at}, &{value});"
    return f"mip_put_{scalar.width}({at}, {unsigned(scalar, value) if cast else value});"


def unsigned(scalar: m.Scalar, value: str) -> str:
    """Converts a number to the unsigned one with the same bytes."""
    return f"(uint{8 * scalar.memory}_t){value}"


def _cast(scalar: m.Scalar) -> str:
    """Writes the cast of an unsigned number to a signed one or a character; empty for others."""
    return f"({c_type(scalar)})" if scalar.kind in ("signed", "char") else ""


def at_offset(data: str, offset: int) -> str:
    return f"{data} + {offset}" if offset else data


def _member(r: Run) -> str:
    return f"value->{_path(r.path)}{'.bytes' if r.parameter.kind == 'bits' else ''}"


def _path(parts: Path) -> str:
    """
    >>> _path(("points", 1, "x"))
    'points[1].x'
    """
    return "".join(f"[{x}]" if isinstance(x, int) else f".{member(x)}" for x in parts).removeprefix(".")
