"""Values of fields with a fixed layout, straight from their bytes."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ..binding import Field, Parameter, Structure, info
from .scan import Array

#: The scalars of the specification as NumPy calls them. A bool is a byte: it need not be 0 or 1.
SCALARS = {
    "u8": "u1", "u16": "u2", "u32": "u4", "u64": "u8", "s8": "i1", "s16": "i2", "s32": "i4", "s64": "i8",
    "float": "f4", "double": "f8", "bool": "u1", "char": "u1",
}  # fmt: skip


class Layout(NamedTuple):
    """The bytes of a field: its type in NumPy, big-endian."""

    dtype: np.dtype[Any]
    base: np.dtype[Any] | None  # if all values are of one type: that one
    plain: bool  # no constants in it: any bytes will do


_KNOWN: dict[type[Field], Layout | None] = {}


def layout(kind: type[Field]) -> Layout | None:
    """The layout of a field, if it always has the same."""
    if kind not in _KNOWN:
        _KNOWN[kind] = _layout(kind)
    return _KNOWN[kind]


def _layout(kind: type[Field]) -> Layout | None:
    signature = inspect.signature(kind).parameters.values()
    if any(p.default is None for p in signature):  # parameters that may be absent
        return None
    dtype = _record(info(kind).parameters)
    if dtype is None:
        return None
    bases = {d.base for d in _scalars(dtype)}
    base = bases.pop() if len(bases) == 1 else None
    return Layout(dtype, base, not _constant(info(kind).parameters))


def _constant(parameters: tuple[Parameter, ...]) -> bool:
    """Has any of them one value only?"""
    inner = [p.type for p in parameters if p.type is not None and issubclass(p.type, Structure)]
    return any(p.constant is not None for p in parameters) or any(_constant(info(t).parameters) for t in inner)


def _record(parameters: tuple[Parameter, ...]) -> np.dtype[Any] | None:
    parts: list[tuple[str, Any, tuple[int, ...]]] = []
    for p in parameters:
        element: Any = _record(info(p.type).parameters) if p.kind == "struct" else _element(p)
        if p.kind == "array" and not p.scalar:
            element = _record(info(p.type).parameters)
        if element is None or p.kind in ("switch", "counter") or isinstance(p.length, str):
            return None
        parts.append((p.attribute, element, _shape(p)))
    return np.dtype(parts)


def _element(p: Parameter) -> str | None:
    if p.kind == "text":
        return "u1"
    return "u1" if p.scalar == "bits" else ">" + SCALARS[p.scalar] if p.scalar else None


def _shape(p: Parameter) -> tuple[int, ...]:
    length = (p.length,) if isinstance(p.length, int) else ()
    elements = (len(p.elements),) if p.elements else ()
    return (p.size,) if p.scalar == "bits" else length + elements


def _scalars(dtype: np.dtype[Any]) -> Iterator[np.dtype[Any]]:
    for name in dtype.names or ():
        inner = dtype[name].base
        if inner.names is None:
            yield inner
        else:
            yield from _scalars(inner)


def values(kind: type[Field], rows: Array, shape: Layout, turned: bool) -> tuple[dict[str, Array], Array | None]:
    """The columns of some rows of bytes, and which rows are right, if not all are: constants differ.

    `turned` says that items of one size have the order of this machine already.
    """
    if not shape.dtype.itemsize:
        return {}, None
    record = rows.reshape(-1).view(shape.dtype)
    if shape.base is not None:  # turned in one go, in place
        if not turned and sys.byteorder == "little":
            rows.reshape(-1).view(shape.base.newbyteorder("=")).byteswap(inplace=True)
        record = rows.reshape(-1).view(shape.dtype.newbyteorder("="))
    right: Array | None = None
    columns: dict[str, Array] = {}
    for name, p, column in _leaves(info(kind).parameters, record, ""):
        if p.constant is not None:
            same = column == p.constant
            while same.ndim > 1:
                same = same.all(axis=-1)
            right = same if right is None else right & same
        else:
            columns[name] = column
    if right is not None and not right.all():
        columns = {name: column[right] for name, column in columns.items()}
        return columns, right
    return columns, None


def _leaves(parameters: tuple[Parameter, ...], record: Array, prefix: str) -> Iterator[tuple[str, Parameter, Array]]:
    for p in parameters:
        name, column = prefix + p.attribute, record[p.attribute]
        if column.dtype.names is not None:
            yield from _leaves(info(p.type).parameters, column, name + ".")
        elif p.kind == "text":
            yield name, p, texts(column)
        elif column.dtype.isnative:
            yield name, p, column
        else:
            yield name, p, column.astype(column.dtype.newbyteorder("="))


def texts(column: Array) -> Array:
    """Characters, one byte each, as str: all of them, zeros too."""
    flat = np.ascontiguousarray(column).reshape(-1, column.shape[-1])
    strings = np.empty(len(flat), object)
    strings[:] = [row.tobytes().decode("latin-1") for row in flat]
    return strings.reshape(column.shape[:-1])
