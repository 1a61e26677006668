"""Tables of Arrow."""

from __future__ import annotations

from typing import Any

import numpy as np

from .frames import Series, library, objects
from .general import Ragged


def made(series: list[Series], units: bool) -> Any:
    """A table; units, frames, clocks and types are in the metadata of its fields."""
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
    if isinstance(values, Ragged):
        return _lists(arrow, values)
    if values.dtype == object:
        return arrow.array(objects(one), None if values.size else arrow.string())
    if values.ndim > 1:
        return _fixed(arrow, values, mask)
    if values.dtype.kind == "M":
        return arrow.array(values).cast(arrow.timestamp("ns", "UTC"))
    return arrow.array(np.ascontiguousarray(values), mask=mask)


def _lists(arrow: Any, ragged: Ragged) -> Any:
    if isinstance(ragged.values, Ragged):
        items = _lists(arrow, ragged.values)
    else:
        items = _column(arrow, Series("", ragged.values, None, {}))
    offsets = arrow.array(ragged.offsets.astype(np.int32))
    mask = None if ragged.mask is None else arrow.array(ragged.mask)
    return arrow.ListArray.from_arrays(offsets, items, mask=mask)


def _fixed(arrow: Any, values: Any, mask: Any) -> Any:
    """Lists of one size. Where there is no value, the elements are null: Parquet has no null lists of one size."""
    if mask is not None:
        mask = np.broadcast_to(mask.reshape(-1, *[1] * (values.ndim - 1)), values.shape).reshape(-1)
    items = arrow.array(np.ascontiguousarray(values).reshape(-1), mask=mask)
    for width in reversed(values.shape[1:]):
        items = arrow.FixedSizeListArray.from_arrays(items, width)
    return items
