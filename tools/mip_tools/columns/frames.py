"""Converts tables to data frames of pandas, Polars or Arrow."""

from __future__ import annotations

import re
from collections.abc import Sequence
from importlib import import_module
from typing import Any

import numpy as np

from ..binding import CLOCKS, MissingExtra
from . import buffers, tables, timeline
from .column import Column
from .packets import Kind, Packets
from .reader import Reader
from .tables import Form, Series

LIBRARIES = ("pandas", "polars", "pyarrow")
#: Bytes of a large log that are read at once.
PART = 1 << 22


def frame(
    log: Packets,
    kinds: Sequence[Kind],
    by: str,
    library: str,
    time: str | None,
    invalid: str,
    units: bool,
    position: bool,
    index: str | None,
    names: str,
) -> Any:
    """See `Log.frame`."""
    if names not in ("full", "plain"):
        raise ValueError(f"names {names!r}: full or plain")
    if index is not None and (index != "time" or library != "pandas" or time is None):
        raise ValueError(f"index {index!r}: None, or time, which needs pandas and a time")
    form = Form(by, shown=() if time is None else None, invalid=invalid, position=position)
    form.check()
    _library(library)
    sets = [Reader(log, kind, None).set for kind in kinds] if log.end - log.begin > timeline.PART else [None]
    if None in sets:
        columns = log.columns(kinds)
        form = form._replace(**_clocks(log, _sets(columns), time or "auto")._asdict())
        series = tables.whole_table(log, columns, form).columns
    else:
        form = form._replace(**_clocks(log, sorted({number for number in sets if number}), time or "auto")._asdict())
        series = tables.joined_parts(log, kinds, form, PART)
    if len({each.name for each in series}) < len(series):
        raise ValueError("a type is named twice, so columns would have the same name; name each type once")
    if names == "plain":
        series = [each._replace(name=re.sub(r"\W", "_", each.name)) for each in series]
        units = units and library == "pyarrow"  # there, they are in the metadata
    made = as_frame(series, library, units)
    first = next((each.name for each in series if each.name in ("time", "time_device")), None)
    return made if index is None or first is None else made.set_index(first)


def _library(name: str) -> str:
    if name not in LIBRARIES:
        raise ValueError(f"library {name!r}: {', '.join(LIBRARIES)}")
    return name


def _sets(columns: Sequence[Column[Any]]) -> list[int]:
    return sorted({number for column in columns for number in column.sets})


def _clocks(log: Packets, sets: Sequence[int], time: str | None) -> timeline.Clocks:
    """Chooses the clocks of a table."""
    if time == "auto":
        return timeline.of_log(log).clocks(sets)
    if time is not None and time not in CLOCKS:
        raise ValueError(f"time {time!r}: auto, None or one of {', '.join(CLOCKS)}")
    return timeline.Clocks(time or "", "") if CLOCKS.get(time or "") else timeline.Clocks("", time or "")


def as_frame(columns: Sequence[Series], library: str, units: bool) -> Any:
    """Makes a frame of this library. Raises MissingExtra."""
    makers = {"pandas": _pandas, "polars": _polars, "pyarrow": _pyarrow}
    return makers[library](columns, units)


def titled(series: Series, units: bool = True) -> str:
    """Returns the name with its unit: "scaled_accel.x [g]"."""
    unit = series.facts.get("unit", "")
    return f"{series.name} [{unit}]" if units and unit else series.name


def library(name: str) -> Any:
    """Imports a library that an extra of the package installs. Raises MissingExtra."""
    try:
        return import_module(name)
    except ImportError as error:
        raise MissingExtra(name, name) from error


def objects(series: Series) -> list[Any]:
    """Converts the values to Python objects; missing ones are None."""
    items = [item.tolist() if isinstance(item, np.ndarray) else item for item in series.values]
    if series.mask is None:
        return items
    return [None if gone else item for item, gone in zip(items, series.mask.tolist())]


def _pandas(series: Sequence[Series], units: bool) -> Any:
    """Makes a frame; missing values are NaN or NaT, and NA in columns of integers."""
    pandas = library("pandas")
    frame = pandas.DataFrame({titled(column, units): _pandas_column(pandas, column) for column in series}, copy=False)
    frame.attrs["units"] = {titled(c, units): c.facts["unit"] for c in series if c.facts.get("unit")}
    if series and series[0].name in ("time", "time_device"):
        frame.attrs.update({name: fact for name, fact in series[0].facts.items() if name != "unit"})
    return frame


def _pandas_column(pandas: Any, series: Series) -> Any:
    values, mask = series.values, series.mask
    if values.ndim > 1 or values.dtype == object:
        return pandas.Series(objects(series), dtype=object)
    if values.dtype.kind == "M":
        return pandas.Series(values).dt.tz_localize("UTC")
    if mask is None:
        return pandas.Series(values)
    if values.dtype.kind == "f":
        return pandas.Series(np.where(mask, np.nan, values).astype(values.dtype))
    return pandas.Series(pandas.arrays.IntegerArray(np.array(values), np.array(mask)))


def _polars(series: Sequence[Series], units: bool) -> Any:
    """Makes a frame; missing values are null."""
    polars = library("polars")
    return polars.DataFrame([_polars_column(polars, column, titled(column, units)) for column in series])


def _polars_column(polars: Any, column: Series, name: str) -> Any:
    values, mask = column.values, column.mask
    if values.ndim > 1 or values.dtype == object:
        return polars.Series(name, objects(column))
    series = polars.Series(name, np.ascontiguousarray(values))
    if values.dtype.kind == "M":
        series = series.dt.replace_time_zone("UTC")
    return series if mask is None else series.scatter(np.flatnonzero(mask), None)


def _pyarrow(series: Sequence[Series], units: bool) -> Any:
    """Makes a table; units, frames, clocks and types are in the metadata of its fields."""
    arrow = library("pyarrow")
    fields, arrays = [], []
    for column in series:
        array = _pyarrow_column(arrow, column)
        facts = column.facts if units else {k: v for k, v in column.facts.items() if k != "unit"}
        fields.append(arrow.field(column.name, array.type, metadata=facts or None))
        arrays.append(array)
    return arrow.Table.from_arrays(arrays, schema=arrow.schema(fields))


def _pyarrow_column(arrow: Any, series: Series) -> Any:
    values, mask = series.values, series.mask
    if values.dtype == object and not series.lists[0]:
        items = objects(series)
        return buffers.texts(arrow, [item or "" for item in items], np.array([item is None for item in items], bool))
    if values.dtype == object:
        return arrow.array(objects(series), _arrow_type(arrow, *series.lists))
    if values.ndim > 1:
        return _arrow_lists(arrow, values, mask)
    if values.dtype.kind == "M":
        return buffers.array(arrow, values).cast(arrow.timestamp("ns", "UTC"))
    return buffers.array(arrow, values, mask)


def _arrow_type(arrow: Any, depth: int, item: str) -> Any:
    kind = arrow.string() if item in ("", "|O") else arrow.from_numpy_dtype(np.dtype(item))
    for _ in range(depth):
        kind = arrow.list_(kind)
    return kind


def _arrow_lists(arrow: Any, values: Any, mask: Any) -> Any:
    """Makes variable-size lists, although all have one size: Parquet loses missing lists of a fixed size."""
    offsets = buffers.array(arrow, np.arange(len(values) + 1, dtype=np.int32) * values.shape[1])
    inner = values.reshape(-1, *values.shape[2:])
    items = _arrow_lists(arrow, inner, None) if inner.ndim > 1 else buffers.array(arrow, inner)
    return arrow.ListArray.from_arrays(offsets, items, mask=None if mask is None else buffers.array(arrow, mask))
