"""Reads values of fields with a fixed layout directly from their bytes."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..binding import SCALARS, Field, Parameter, Structure, info
from .scan import Array


class Layout(NamedTuple):
    """The layout of a field as a big-endian NumPy type."""

    dtype: np.dtype[Any]
    base: np.dtype[Any] | None  # if all values are of one type: that one
    plain: bool  # without constants: any bytes are valid


_KNOWN: dict[type[Field], Layout | None] = {}


def layout(kind: type[Field]) -> Layout | None:
    """Returns the layout of a field; None if it varies."""
    if kind not in _KNOWN:
        _KNOWN[kind] = _layout(kind)
    return _KNOWN[kind]


def _layout(kind: type[Field]) -> Layout | None:
    parameters = info(kind).parameters
    dtype = None if any(p.required or p.optional for p in parameters) else _record(parameters)
    if dtype is None:
        return None
    bases = {d.base for d in _scalars(dtype)}
    base = bases.pop() if len(bases) == 1 else None
    return Layout(dtype, base, not _constant(parameters))


def _constant(parameters: Sequence[Parameter]) -> bool:
    """Does one of them contain a constant?"""
    return any(p.constant is not None or _constant(_inside(p)) for p in parameters)


def _inside(p: Parameter) -> Sequence[Parameter]:
    """Returns the members of a structure, which may be an element of an array."""
    return info(p.type).parameters if p.type is not None and issubclass(p.type, Structure) else ()


def _record(parameters: Sequence[Parameter]) -> np.dtype[Any] | None:
    parts: list[tuple[str, Any, tuple[int, ...]]] = []
    for p in parameters:
        if p.kind in ("switch", "counter") or isinstance(p.length, str):
            return None
        inner = _inside(p)
        element: Any = _record(inner) if inner else f">{SCALARS[p.scalar].letter}" if p.kind != "bits" else ">B"
        if element is None:
            return None
        sizes = p.size if p.kind == "bits" else p.length, len(p.elements)
        parts.append((p.attribute, element, tuple(size for size in sizes if size)))
    return np.dtype(parts)


def _scalars(dtype: np.dtype[Any]) -> Iterator[np.dtype[Any]]:
    for name in dtype.names or ():
        inner = dtype[name].base
        if inner.names is None:
            yield inner
        else:
            yield from _scalars(inner)


def row_values(kind: type[Field], rows: Array, shape: Layout, turned: bool) -> tuple[dict[str, Array], Array | None]:
    """Makes columns from rows of bytes. Also returns which rows have the right constants; None if all do.

    `turned`: items of one size already have the byte order of this machine.
    """
    if not shape.dtype.itemsize:
        return {}, None
    record = rows.reshape(-1).view(shape.dtype)
    if shape.base is not None:  # swaps the bytes of all items at once, in place
        if not turned and sys.byteorder == "little":
            rows.reshape(-1).view(shape.base.newbyteorder("=")).byteswap(inplace=True)
        record = rows.reshape(-1).view(shape.dtype.newbyteorder("="))
    valid: Array | None = None
    columns: dict[str, Array] = {}
    for name, p, column in _leaves(info(kind).parameters, record, ""):
        if p.constant is not None:
            same = column == p.constant
            while same.ndim > 1:
                same = same.all(axis=-1)
            valid = same if valid is None else valid & same
        else:
            columns[name] = column
    if valid is not None and not valid.all():
        columns = {name: column[valid] for name, column in columns.items()}
        return columns, valid
    return columns, None


def _leaves(parameters: Sequence[Parameter], record: Array, prefix: str) -> Iterator[tuple[str, Parameter, Array]]:
    for p in parameters:
        name, column = prefix + p.attribute, record[p.attribute]
        if column.dtype.names is not None:
            yield from _leaves(_inside(p), column, name + ".")
        elif p.kind == "text":
            yield name, p, texts(column)
        elif column.dtype.isnative:
            yield name, p, column
        else:
            yield name, p, column.astype(column.dtype.newbyteorder("="))


def texts(column: Array) -> Array:
    """Converts texts with one byte per character to str; zeros are kept."""
    flat = np.ascontiguousarray(column).reshape(-1, column.shape[-1])
    strings = np.empty(len(flat), object)
    strings[:] = [row.tobytes().decode("latin-1") for row in flat]
    return strings.reshape(column.shape[:-1])
