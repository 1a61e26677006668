"""Reads values of fields with a fixed layout directly from their bytes."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ..binding import Field, Structure, wire
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
    dtype = None if kind._ALWAYS is not None else _record(kind)
    if dtype is None:
        return None
    bases = {d.base for d in _scalars(dtype)}
    base = bases.pop() if len(bases) == 1 else None
    return Layout(dtype, base, not _constant(kind))


def _constant(kind: type[Structure]) -> bool:
    """Does the structure contain a constant?"""
    return any(isinstance(what, int) or (_inner(what) and _constant(_inner(what))) for _, _, what in kind._LAYOUT)


def _inner(what: Any) -> Any:
    """Returns the structure of a member, which may be an array of structures."""
    what = what.kind if isinstance(what, wire.Items) else what
    return what if wire.is_structure(what) else None


def _record(kind: type[Structure]) -> np.dtype[Any] | None:
    parts: list[tuple[str, Any, tuple[int, ...]]] = []
    for name, letters, what in kind._LAYOUT:
        inner, shape = _inner(what), tuple[int, ...]()
        element: Any = _record(inner) if inner else f">{letters[:1] or 'B'}"
        if isinstance(what, (wire.Text, wire.Items)):
            if not isinstance(what.length, int):
                return None
            shape = (what.length, *([len(letters)] if len(letters) > 1 else []))
        elif what is tuple or isinstance(what, (wire.Each, wire.Bits)) or wire.is_vector(what):
            shape = (len(letters),)
        if element is None or isinstance(what, (wire.Union, wire.Counts)):
            return None
        parts.append((name, element, shape))
    return np.dtype(parts)


def _scalars(dtype: np.dtype[Any]) -> Iterator[np.dtype[Any]]:
    for name in dtype.names or ():
        inner = dtype[name].base
        if inner.names is None:
            yield inner
        else:
            yield from _scalars(inner)


def values(kind: type[Field], rows: Array, shape: Layout, turned: bool) -> tuple[dict[str, Array], Array | None]:
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
    right: Array | None = None
    columns: dict[str, Array] = {}
    for name, what, column in _leaves(kind, record, ""):
        if isinstance(what, int):
            same = column == what
            while same.ndim > 1:
                same = same.all(axis=-1)
            right = same if right is None else right & same
        else:
            columns[name] = column
    if right is not None and not right.all():
        columns = {name: column[right] for name, column in columns.items()}
        return columns, right
    return columns, None


def _leaves(kind: type[Structure], record: Array, prefix: str) -> Iterator[tuple[str, Any, Array]]:
    for own, _, what in kind._LAYOUT:
        name, column = prefix + own, record[own]
        if column.dtype.names is not None:
            yield from _leaves(_inner(what), column, name + ".")
        elif isinstance(what, wire.Text):
            yield name, what, texts(column)
        elif column.dtype.isnative:
            yield name, what, column
        else:
            yield name, what, column.astype(column.dtype.newbyteorder("="))


def texts(column: Array) -> Array:
    """Converts texts with one byte per character to str; zeros are kept."""
    flat = np.ascontiguousarray(column).reshape(-1, column.shape[-1])
    strings = np.empty(len(flat), object)
    strings[:] = [row.tobytes().decode("latin-1") for row in flat]
    return strings.reshape(column.shape[:-1])
