"""Makes columns from objects, for fields whose layout varies: counted arrays, unions, absent values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ..binding import SCALARS, Parameter, info, single_to_bits
from .scan import Array

#: Kind of scalar -> that of its NumPy type. A bool is a byte, which need not be 0 or 1.
_KINDS = {"unsigned": "u", "signed": "i", "float": "f", "bool": "u", "char": "u"}


class Ragged(NamedTuple):
    """An array for each row: row `i` has `values[offsets[i] : offsets[i + 1]]`."""

    values: Any  # an array, or again Ragged
    offsets: Array
    mask: Array | None = None  # True for rows without an array

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def row(self, number: int) -> Any:
        """Returns the array of one row."""
        begin, end = int(self.offsets[number]), int(self.offsets[number + 1])
        if isinstance(self.values, Ragged):
            return [self.values.row(i) for i in range(begin, end)]
        return self.values[begin:end]

    def rows(self) -> list[Any]:
        """Returns the arrays of all rows; None for a row without one."""
        absent = np.zeros(len(self), bool) if self.mask is None else self.mask
        return [None if gone else self.row(i) for i, gone in enumerate(absent.tolist())]


Values: TypeAlias = "Array | Ragged"


def general_columns(parameters: tuple[Parameter, ...], records: Sequence[Any], prefix: str = "") -> dict[str, Values]:
    """Makes a column for each parameter from a list of records, of which some may be None."""
    all_columns: dict[str, Values] = {}
    for p in parameters:
        if p.kind == "counter" or p.constant is not None:
            continue
        values = [None if r is None else getattr(r, p.attribute) for r in records]
        name = prefix + p.attribute
        if p.kind == "switch":
            all_columns |= _union(p, [None if r is None else getattr(r, p.tag) for r in records], values, name)
        else:
            all_columns |= _columns_of(p, values, name)
    return all_columns


def _union(p: Parameter, tags: list[Any], values: list[Any], name: str) -> dict[str, Values]:
    all_columns: dict[str, Values] = {}
    for tag, case in p.cases.items():
        if case is not None:
            chosen = [value if own == tag else None for own, value in zip(tags, values)]
            all_columns |= _columns_of(case, chosen, f"{name}.{case.attribute}")
    return all_columns


def _columns_of(p: Parameter, values: list[Any], name: str) -> dict[str, Values]:
    if p.kind == "struct":
        return general_columns(info(p.type).parameters, values, name + ".")
    if p.kind == "text":
        text = np.empty(len(values), object)
        text[:] = values
        return {name: _masked(text, values)}
    if p.length is None or p.scalar == "bits":
        return {name: _masked(_numbers(p, values), values)}
    counts = [0 if v is None else len(v) for v in values]
    flat = [item for v in values if v is not None for item in v]
    items: dict[str, Values]
    if p.scalar:
        items = {name: _numbers(p, flat)}
    else:
        items = general_columns(info(p.type).parameters, flat, name + ".")
    return {key: _arrays(p, counts, values, column) for key, column in items.items()}


def _arrays(p: Parameter, counts: list[int], values: list[Any], items: Values) -> Values:
    """Divides the items of all rows into an array for each row."""
    if isinstance(p.length, int) and isinstance(items, np.ndarray):
        if None not in values:
            return items.reshape(len(values), p.length, *items.shape[1:])
        there = np.array([v is not None for v in values], bool)
        full = np.zeros((len(values), p.length, *items.shape[1:]), items.dtype)
        full[there] = items.reshape(-1, p.length, *items.shape[1:])
        return _masked(full, values)
    offsets = np.zeros(len(counts) + 1, np.int64)
    np.cumsum(counts, out=offsets[1:])
    mask = np.array([v is None for v in values], bool) if None in values else None
    return Ragged(items, offsets, mask)


def _masked(column: Array, values: Sequence[Any]) -> Array:
    if not any(v is None for v in values):
        return column
    mask = np.array([v is None for v in values], bool).reshape(-1, *[1] * (column.ndim - 1))
    whole = np.broadcast_to(mask, column.shape)
    make: Any = np.ma.MaskedArray  # not typed in all versions
    masked: Array = make(column, whole)
    return masked


def _numbers(p: Parameter, values: Sequence[Any]) -> Array:
    """Makes an array of numbers, vectors or wide bitfields; missing ones are zero."""
    if p.scalar == "bits":
        octets = b"".join(int(v or 0).to_bytes(p.size, "little") for v in values)
        return np.frombuffer(octets, np.uint8).reshape(len(values), p.size).copy()
    width, scalar = len(p.elements), SCALARS[p.scalar]
    dtype = np.dtype(f"{_KINDS[scalar.kind]}{scalar.size}")
    if width:
        items = [x for v in values for x in ([0] * width if v is None else v)]
    else:
        items = [0 if v is None else v for v in values]
    if p.scalar == "float":  # copies the bits, because a conversion from eight bytes to four changes some NaNs
        column = np.array([single_to_bits(x) for x in items], np.uint32).view(dtype)
    else:
        column = np.array([x if dtype.kind == "f" else int(x) for x in items], dtype)
    return column.reshape(len(values), width) if width else column
