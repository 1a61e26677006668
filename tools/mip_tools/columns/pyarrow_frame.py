"""Makes Arrow tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .frames import library, objects
from .tables import Series


def made(series: Sequence[Series], units: bool) -> Any:
    """Makes a table; units, frames, clocks and types are in the metadata of its fields."""
    arrow = library("pyarrow")
    fields, arrays = [], []
    for one in series:
        array = _column(arrow, one)
        facts = one.facts if units else {k: v for k, v in one.facts.items() if k != "unit"}
        fields.append(arrow.field(one.name, array.type, metadata=facts or None))
        arrays.append(array)
    return arrow.Table.from_arrays(arrays, schema=arrow.schema(fields))


def _column(arrow: Any, one: Series) -> Any:
    values, mask = one.values, one.mask
    if values.dtype == object:
        return arrow.array(objects(one), _type(arrow, *one.lists))
    if values.ndim > 1:
        return _lists(arrow, values, mask)
    if values.dtype.kind == "M":
        return arrow.array(values).cast(arrow.timestamp("ns", "UTC"))
    return arrow.array(np.ascontiguousarray(values), mask=mask)


def _type(arrow: Any, depth: int, item: str) -> Any:
    kind = arrow.string() if item in ("", "|O") else arrow.from_numpy_dtype(np.dtype(item))
    for _ in range(depth):
        kind = arrow.list_(kind)
    return kind


def _lists(arrow: Any, values: Any, mask: Any) -> Any:
    """Makes variable-size lists, although all have one size: Parquet loses missing lists of a fixed size."""
    offsets = arrow.array(np.arange(len(values) + 1, dtype=np.int32) * values.shape[1])
    inner = values.reshape(-1, *values.shape[2:])
    items = _lists(arrow, inner, None) if inner.ndim > 1 else arrow.array(np.ascontiguousarray(inner))
    return arrow.ListArray.from_arrays(offsets, items, mask=None if mask is None else arrow.array(mask))
