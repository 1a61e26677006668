"""Formats tables as text: lines of CSV, JSON lines."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from ..binding import shortest as shortest_text
from .frames import titled
from .scan import Array
from .tables import Series

#: The number of rows that are in memory as text at the same time.
ROWS = 1 << 13


def csv_head(columns: Sequence[Series]) -> str:
    """Formats the first line: names with units; durations are in seconds."""
    return ",".join(quoted(titled(one) + " [s]" * (one.values.dtype.kind == "m")) for one in columns) + "\n"


def csv_lines(columns: Sequence[Series]) -> Iterator[str]:
    """Yields the lines of a table, many at once; missing values are empty."""

    def template(there: list[bool], formats: list[str]) -> str:
        given = iter(formats)
        return ",".join([next(given) if t else "" for t in there])

    return _lines(columns, csv_values, template)


def json_lines(columns: Sequence[Series]) -> Iterator[str]:
    """Yields an object for each row, many at once; missing values are left out."""
    names = [json.dumps(one.name).replace("%", "%%") for one in columns]

    def template(there: list[bool], formats: list[str]) -> str:
        named = zip([name for name, t in zip(names, there) if t], formats)
        return "{" + ",".join([f"{name}:{form}" for name, form in named]) + "}"

    return _lines(columns, json_values, template)


def _lines(
    columns: Sequence[Series],
    values: Callable[[Series], tuple[str, list[Any]]],
    template: Callable[[list[bool], list[str]], str],
) -> Iterator[str]:
    """Yields the lines. Consecutive rows that have values in the same columns are formatted together."""
    count = len(columns[0].values) if columns else 0
    for at in range(0, count, ROWS):
        part = [one.rows(slice(at, at + ROWS)) for one in columns]
        size = len(part[0].values)
        there = np.array([np.ones(size, bool) if one.mask is None else ~one.mask for one in part])
        packed = np.ascontiguousarray(np.packbits(there, axis=0).T)
        _, first, pattern = np.unique(packed.view(f"V{packed.shape[1]}"), return_index=True, return_inverse=True)
        lines = np.empty(size, object)
        for number, example in enumerate(first.tolist()):
            rows = np.flatnonzero(pattern.reshape(-1) == number)
            has = there[:, example].tolist()
            cells = [values(one.rows(rows)._replace(mask=None)) for one, t in zip(part, has) if t]
            line = template(has, [form for form, _ in cells]) + "\n"
            lines[rows] = list(map(line.__mod__, zip(*[items for _, items in cells]))) if cells else line
        yield "".join(lines.tolist())


def csv_values(one: Series) -> tuple[str, list[Any]]:
    """Returns the format of a column in CSV, and its values; missing ones have any value."""
    values = one.values
    if values.dtype.kind == "f" and values.ndim == 1:
        return "%r", _doubles(values)
    if values.dtype.kind == "M":
        return "%sZ", np.datetime_as_string(values, unit="ns").tolist()
    if values.dtype == object and not one.lists[0]:
        return "%s", [quoted(text or "") for text in values.tolist()]
    form, found = json_values(one)
    return (form, [quoted(text) for text in found]) if values.ndim > 1 or values.dtype == object else (form, found)


def json_values(one: Series) -> tuple[str, list[Any]]:
    """Returns the same for JSON. Numbers have the precision of the wire; NaN and infinity are null."""
    values = one.values
    if values.ndim > 1:
        form, flat = json_values(Series("", values.reshape(-1), None, {}))
        found = [form % (item,) for item in flat]
        for width in reversed(values.shape[1:]):
            found = ["[" + ",".join(found[at : at + width]) + "]" for at in range(0, len(found), width)]
        return "%s", found
    match values.dtype.kind:
        case "f":
            if np.isfinite(values).all():
                return "%r", _doubles(values)
            return "%s", [repr(v) if math.isfinite(v) else "null" for v in _doubles(values)]
        case "b":
            return "%s", ["true" if value else "false" for value in values.tolist()]
        case "M":
            return '"%sZ"', np.datetime_as_string(values, unit="ns").tolist()
        case "m":
            return "%s", [_seconds(time) for time in values.view(np.int64).tolist()]
        case "O":
            return "%s", [_json(value, one.lists[1]) for value in values.tolist()]
    return "%d", values.tolist()


def _doubles(values: Array) -> list[float]:
    """Converts numbers so that their `repr` has as many digits as their size on the wire needs."""
    return list((shortest(values) if values.dtype == np.float32 else values).tolist())


def _seconds(time: int) -> str:
    """Formats nanoseconds as a decimal number of seconds."""
    whole, rest = divmod(abs(time), 1_000_000_000)
    return f"{'-' if time < 0 else ''}{whole}.{rest:09d}"


def _json(value: Any, item: str) -> str:
    if isinstance(value, list):
        return "[" + ",".join(_json(inner, item) for inner in value) + "]"
    if isinstance(value, float):
        if not math.isfinite(value):
            return "null"
        return str(shortest_text(value)) if item[1:] == "f4" else repr(value)
    return json.dumps(value)


def quoted(text: str) -> str:
    """Formats a CSV cell, in quotes if necessary (RFC 4180)."""
    if text.isalnum() or not any(c in text for c in ',"\r\n'):
        return text
    return '"' + text.replace('"', '""') + '"'


def shortest(numbers: Array) -> Array:
    """Returns the shortest decimal numbers that equal these four-byte floats, as doubles.

    The result equals that of `text.shortest` of the package. With 6 to 9 digits, they are whole numbers
    below 2**53, multiplied or divided by an exact power of ten, at most 10**22: so they are the nearest
    double. To find these digits, a number is scaled by a power of ten and rounded. A float has 24 bits, so
    its product with at most 10**12 is exact, and its quotient by at most 10**3 is either exactly between two
    whole numbers or far from it. With a larger power, numbers that are almost between are formatted alone.
    """
    with np.errstate(invalid="ignore"):  # signalling NaNs are invalid operands
        doubles = numbers.astype(np.float64)
    size = np.abs(doubles)
    left = np.flatnonzero((size >= 1e-13) & (size < 1e21))
    hard = np.isfinite(doubles) & (size > 0)
    hard[left] = False
    exponent = np.floor(np.log10(size[left])).astype(np.intp)
    exponent -= size[left] < _power(exponent)  # the logarithm is rounded
    exponent += size[left] >= _power(exponent + 1)
    for digits in (6, 7, 8, 9):
        if not len(left):
            break
        power = _power(np.abs(digits - 1 - exponent))
        small = exponent > digits - 1
        exact = doubles[left]
        moved = np.where(small, exact / power, exact * power)
        whole = np.rint(moved)
        close = np.abs(np.abs(moved - whole) - 0.5) < 1e-3  # to the middle: either could be nearer
        hard[left[close & (power > np.where(small, 1e3, 1e12))]] = True
        near = np.where(small, whole * power, whole / power)
        same = near.astype(np.float32) == numbers[left]
        if digits == 9:
            same[:] = True
        same &= ~hard[left]
        doubles[left[same]] = near[same]
        same |= hard[left]
        left, exponent = left[~same], exponent[~same]
    for i in np.flatnonzero(hard).tolist():
        doubles[i] = float(shortest_text(float(numbers[i])))
    return doubles


_LEAST = 15
_POWERS: Array = np.array([float(f"1e{n}") for n in range(-_LEAST, 23)])


def _power(exponent: Array) -> Array:
    """Returns powers of ten; those from 1 to 10**22 are exact."""
    return np.take(_POWERS, exponent + _LEAST)
