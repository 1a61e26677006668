"""Formats tables as text: lines of CSV, JSON lines. With pyarrow, the same lines are made ten times faster."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from typing import Any

import numpy as np

from ..binding import shortest as shortest_text
from . import buffers
from .frames import titled
from .scan import Array
from .tables import Series

#: The number of rows that are in memory as text at the same time, without and with pyarrow.
ROWS, _ARROW_ROWS = 1 << 13, 1 << 16
#: Arrow formats numbers of these sizes as Python does, except that it leaves out ".0".
_LEAST_ALIKE, _MOST_ALIKE = 1e-4, 1e10


def csv_head(columns: Sequence[Series]) -> str:
    """Formats the first line: names with units."""
    return ",".join(csv_cell(titled(series)) for series in columns) + "\n"


def csv_lines(columns: Sequence[Series]) -> Iterator[bytes]:
    """Yields the lines of a table, many at once; missing values are empty."""
    if (arrow := pyarrow()) is not None:
        for part in _parts(columns, _ARROW_ROWS):
            cells = [_cells(arrow, series, False) for series in part]
            separated = [each for cell in cells for each in (",", cell)]
            yield _text(buffers.joined(arrow, *separated[1:], "\n"))
        return

    def template(there: list[bool], formats: list[str]) -> str:
        texts = iter(formats)
        return ",".join([next(texts) if t else "" for t in there])

    yield from _lines(columns, csv_values, template)


def json_lines(columns: Sequence[Series]) -> Iterator[bytes]:
    """Yields an object for each row, many at once; missing values are left out."""
    names = [json.dumps(series.name).replace("%", "%%") for series in columns]
    if (arrow := pyarrow()) is not None:
        for part in _parts(columns, _ARROW_ROWS):
            cells = [_labelled(arrow, series) for series in part]
            lines = arrow.compute.ascii_ltrim(buffers.joined(arrow, *cells), ",")
            yield _text(buffers.joined(arrow, "{", lines, "}\n"))
        return

    def template(there: list[bool], formats: list[str]) -> str:
        named = zip([name for name, t in zip(names, there) if t], formats)
        return "{" + ",".join([f"{name}:{form}" for name, form in named]) + "}"

    yield from _lines(columns, json_values, template)


def pyarrow() -> Any:
    """Imports pyarrow; None if it is not installed."""
    try:
        return import_module("pyarrow.compute") and import_module("pyarrow")
    except ImportError:
        return None


def _parts(columns: Sequence[Series], rows: int) -> Iterator[list[Series]]:
    """Yields a table in parts of so many rows."""
    for at in range(0, len(columns[0].values) if columns else 0, rows):
        yield [series.rows(slice(at, at + rows)) for series in columns]


def _labelled(arrow: Any, series: Series) -> Any:
    """Formats a column for JSON, each value after a comma and its name; missing values are null."""
    cells = _cells(arrow, series, True)
    label = buffers.texts(arrow, [f",{json.dumps(series.name)}:"])[0]
    return arrow.compute.binary_join_element_wise(label, cells, buffers.texts(arrow, [""])[0])


def _text(lines: Any) -> bytes:
    """Returns the bytes of all lines."""
    _, ends, data = lines.buffers()
    return bytes(memoryview(data)[: int(np.frombuffer(ends, np.int32)[len(lines)])])


def _cells(arrow: Any, series: Series, as_json: bool) -> Any:
    """Formats a column as `csv_values` or `json_values` do; missing values are null."""
    values, mask, compute = series.values, series.mask, arrow.compute
    match values.dtype.kind if values.ndim == 1 else "":
        case "f":
            texts = numbers(arrow, values, mask)
            finite = np.isfinite(values) if mask is None else np.isfinite(values) | mask
            if as_json and not finite.all():
                texts = compute.if_else(buffers.array(arrow, finite), texts, buffers.texts(arrow, ["null"])[0])
        case "M":
            dates = buffers.array(arrow, values.astype("M8[ns]"), mask).cast(arrow.string())
            quote = '"' if as_json else ""
            texts = compute.replace_substring(dates, " ", "T", max_replacements=1)
            around = [buffers.texts(arrow, [text])[0] for text in (quote, f"Z{quote}", "")]
            texts = compute.binary_join_element_wise(around[0], texts, *around[1:])
        case "b" | "i" | "u":
            return buffers.array(arrow, values, mask).cast(arrow.string())
        case _:
            form, items = (json_values if as_json else csv_values)(series._replace(mask=None))
            texts = buffers.texts(arrow, [form % (item,) for item in items], mask)
    return texts


def numbers(arrow: Any, values: Array, mask: Array | None) -> Any:
    """Formats floats as `repr` does, with as many digits as their size on the wire needs."""
    values = np.ascontiguousarray(values)
    with np.errstate(invalid="ignore"):  # signalling NaNs
        size = np.abs(values)
        alike = ((size >= _LEAST_ALIKE) & (size < _MOST_ALIKE)) | (size == 0)
        whole = alike & (np.floor(values) == values)
    if mask is not None:
        alike, whole = alike | mask, whole & ~mask
    compute = arrow.compute
    texts = buffers.array(arrow, values, mask).cast(arrow.string())
    if whole.any():
        texts = compute.if_else(buffers.array(arrow, whole), buffers.joined(arrow, texts, ".0"), texts)
    if alike.all():
        return texts
    others = buffers.texts(arrow, [repr(value) for value in _doubles(values[~alike])])
    return compute.replace_with_mask(texts, buffers.array(arrow, ~alike), others)


def _lines(
    columns: Sequence[Series],
    values: Callable[[Series], tuple[str, list[Any]]],
    template: Callable[[list[bool], list[str]], str],
) -> Iterator[bytes]:
    """Yields the lines. Consecutive rows that have values in the same columns are formatted together."""
    for part in _parts(columns, ROWS):
        size = len(part[0].values)
        there = np.array([np.ones(size, bool) if series.mask is None else ~series.mask for series in part])
        packed = np.ascontiguousarray(np.packbits(there, axis=0).T)
        _, first, pattern = np.unique(packed.view(f"V{packed.shape[1]}"), return_index=True, return_inverse=True)
        lines = np.empty(size, object)
        for number, example in enumerate(first.tolist()):
            rows = np.flatnonzero(pattern.reshape(-1) == number)
            has = there[:, example].tolist()
            cells = [values(series.rows(rows)._replace(mask=None)) for series, t in zip(part, has) if t]
            line = template(has, [form for form, _ in cells]) + "\n"
            lines[rows] = list(map(line.__mod__, zip(*[items for _, items in cells]))) if cells else line
        yield "".join(lines.tolist()).encode()


def csv_values(series: Series) -> tuple[str, list[Any]]:
    """Returns the format of a column in CSV, and its values; missing ones have any value."""
    values = series.values
    if values.dtype.kind == "f" and values.ndim == 1:
        return "%r", _doubles(values)
    if values.dtype.kind == "M":
        return "%sZ", np.datetime_as_string(values, unit="ns").tolist()
    if values.dtype == object and not series.lists[0]:
        return "%s", [csv_cell(text or "") for text in values.tolist()]
    form, texts = json_values(series)
    return (form, [csv_cell(text) for text in texts]) if values.ndim > 1 or values.dtype == object else (form, texts)


def json_values(series: Series) -> tuple[str, list[Any]]:
    """Returns the same for JSON. Numbers have the precision of the wire; NaN and infinity are null."""
    values = series.values
    if values.ndim > 1:
        form, flat = json_values(Series("", values.reshape(-1), None, {}))
        texts = [form % (item,) for item in flat]
        for width in reversed(values.shape[1:]):
            texts = ["[" + ",".join(texts[at : at + width]) + "]" for at in range(0, len(texts), width)]
        return "%s", texts
    match values.dtype.kind:
        case "f":
            if np.isfinite(values).all():
                return "%r", _doubles(values)
            return "%s", [repr(v) if math.isfinite(v) else "null" for v in _doubles(values)]
        case "b":
            return "%s", ["true" if value else "false" for value in values.tolist()]
        case "M":
            return '"%sZ"', np.datetime_as_string(values, unit="ns").tolist()
        case "O":
            return "%s", [_json(value, series.lists[1]) for value in values.tolist()]
    return "%d", values.tolist()


def _doubles(values: Array) -> list[float]:
    """Converts numbers so that their `repr` has as many digits as their size on the wire needs."""
    return list((shortest_decimals(values) if values.dtype == np.float32 else values).tolist())


def _json(value: Any, item: str) -> str:
    if isinstance(value, list):
        return "[" + ",".join(_json(inner, item) for inner in value) + "]"
    if isinstance(value, float):
        if not math.isfinite(value):
            return "null"
        return str(shortest_text(value)) if item[1:] == "f4" else repr(value)
    return json.dumps(value)


def csv_cell(text: str) -> str:
    """Formats a CSV cell, in quotes if necessary (RFC 4180)."""
    if text.isalnum() or not any(c in text for c in ',"\r\n'):
        return text
    return '"' + text.replace('"', '""') + '"'


def shortest_decimals(numbers: Array) -> Array:
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
