"""Makes Arrow arrays from buffers: `pyarrow.array` imports pandas where it is installed, which takes longer than most
exports."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from .scan import Array


def array(arrow: Any, values: Array, mask: Array | None = None) -> Any:
    """Makes an array of numbers, bools or times; null where the mask is True."""
    if values.dtype.kind == "M":
        mask = np.isnat(values) if mask is None else mask | np.isnat(values)
    kind = arrow.from_numpy_dtype(values.dtype)
    plain = values.view(np.int64) if values.dtype.kind == "M" else values
    data = _bits(arrow, values) if values.dtype == bool else arrow.py_buffer(np.ascontiguousarray(plain))
    return arrow.Array.from_buffers(kind, len(values), [_there(arrow, mask), data])


def texts(arrow: Any, items: Sequence[str], mask: Array | None = None) -> Any:
    """Makes an array of texts; null where the mask is True."""
    data = [item.encode() for item in items]
    ends = np.zeros(len(data) + 1, np.int32)
    np.cumsum([len(item) for item in data], out=ends[1:])
    buffers = [_there(arrow, mask), arrow.py_buffer(ends), arrow.py_buffer(b"".join(data))]
    return arrow.Array.from_buffers(arrow.string(), len(data), buffers)


def items(array: Any) -> list[bytes]:
    """Returns the bytes of each text of an array without missing ones: `to_pylist` takes several times as long."""
    _, ends, data = array.buffers()
    places, whole = np.frombuffer(ends, np.int32)[: len(array) + 1].tolist(), bytes(memoryview(data))
    return [whole[begin:end] for begin, end in pairwise(places)]


def joined(arrow: Any, *cells: Any) -> Any:
    """Joins texts, of which some are the same in all rows, row by row; missing ones are empty."""
    columns = [texts(arrow, [cell])[0] if isinstance(cell, str) else cell for cell in cells]
    join = arrow.compute.binary_join_element_wise
    return join(*columns, texts(arrow, [""])[0], null_handling="replace", null_replacement="")


def _there(arrow: Any, mask: Array | None) -> Any:
    return None if mask is None else _bits(arrow, ~mask)


def _bits(arrow: Any, flags: Array) -> Any:
    return arrow.py_buffer(np.packbits(flags, bitorder="little"))
