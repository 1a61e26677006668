"""Columns as a data frame: pandas, Polars or an Arrow table."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..binding import CLOCKS, MissingExtra
from . import times
from .column import Column, absent
from .general import Ragged, Values
from .scan import Array

if TYPE_CHECKING:
    from .log import Log

#: What a frame has beside the parameters of fields.
_OWN = ("time", "time_own", "packet", "set", "offset")


class Series(NamedTuple):
    """One column of a frame."""

    name: str
    values: Values
    mask: Array | None  # True where there is no value
    facts: dict[str, str]  # unit, frame, …


def frame(
    log: Log, columns: Sequence[Column[Any]], library: str, time: str | None, invalid: str, units: bool, position: bool
) -> Any:
    """See `Log.frame`."""
    if library not in ("pandas", "polars", "pyarrow"):
        raise ValueError(f"library {library!r}: pandas, polars or pyarrow")
    if invalid not in ("keep", "mask"):
        raise ValueError(f"invalid {invalid!r}: keep or mask")
    if time is not None and time != "auto" and time not in CLOCKS:
        raise ValueError(f"time {time!r}: auto, None or one of {', '.join(CLOCKS)}")
    made = import_module(f".{library}_frame", __package__).made
    return made(_series(log, columns, time, invalid, position), units)


def _series(log: Log, columns: Sequence[Column[Any]], time: str | None, invalid: str, position: bool) -> list[Series]:
    clock = time
    if time == "auto":
        clock = times.chosen(log, sorted({n for c in columns for n in c.sets})) or None
    places, rows = _rows(columns)
    series: list[Series] = []
    if clock is not None:
        known = [column.time(clock) for column in columns]
        values = np.full(rows, "NaT", times.dtype(clock))
        own = np.zeros(rows, bool)
        for place, one in zip(places, known):
            values[place], own[place] = one.values, one.own
        series.append(Series("time", values, None, {"clock": clock}))
        series.append(Series("time_own", own, None, {}))
    if position:
        for name in ("packet", "set", "offset"):
            numbers = np.zeros(rows, np.uint8 if name == "set" else np.int64)
            for place, column in zip(places, columns):
                numbers[place] = getattr(column, name)
            series.append(Series(name, numbers, None, {}))
    for column, place, prefix in zip(columns, places, _prefixes(columns)):
        if not column.names:
            there = np.zeros(rows, bool)
            there[place] = True
            name = prefix or column.type.NAME.rpartition(".")[2]
            series.append(Series(name, there, None, {}))
        for part in _parameters(column, invalid, prefix):
            series.append(part if len(columns) == 1 else _spread(part, place, rows))
    return series


def _rows(columns: Sequence[Column[Any]]) -> tuple[list[Any], int]:
    """The rows of the frame that those of each column go to: packets together, and their number."""
    if len(columns) == 1:
        return [slice(None)], len(columns[0])
    keys = [column.packet * 256 + _turn(column.packet) for column in columns]
    whole = np.unique(np.concatenate(keys)) if keys else np.zeros(0, np.int64)
    return [np.searchsorted(whole, key) for key in keys], len(whole)


def _turn(packet: Array) -> Array:
    """0 for the first row of a packet, 1 for the second one, …"""
    numbers = np.arange(len(packet))
    new = np.ones(len(packet), bool)
    new[1:] = packet[1:] != packet[:-1]
    return np.asarray(numbers - np.maximum.accumulate(np.where(new, numbers, 0)))


def _prefixes(columns: Sequence[Column[Any]]) -> list[str]:
    """What stands before the names of each column's parameters: its name, in full if others share it."""
    short = [column.type.NAME.rpartition(".")[2] for column in columns]
    if len(set(short)) < len(short):
        return [column.name for column in columns]
    return [name if len(columns) > 1 else "" for name in short]


def _parameters(column: Column[Any], invalid: str, prefix: str) -> list[Series]:
    """The columns of a frame for one type: vectors get one for each element."""
    series = []
    for name in column.names:
        p, values = column.parameters[name], column[name]
        full = name
        if (prefix and prefix.rpartition(".")[2] != name) or "." in prefix:
            full = f"{prefix}.{name}"
        if full in _OWN:
            full = f"{column.type.NAME.rpartition('.')[2]}.{name}"
        facts = {"frame": p.frame} if p.frame else {}
        if p.type is not None:
            facts["type"] = p.type.__name__
        bad = ~column.valid(name) if invalid == "mask" and p.flags else None
        single = {"unit": p.units[0]} if len(set(p.units)) == 1 else {}
        if isinstance(values, Ragged):
            series.append(Series(full, values, values.mask, facts | single))
            continue
        gone = absent(values) if isinstance(values, np.ma.MaskedArray) else None
        if p.elements and values.ndim == 2:
            for i, element in enumerate(p.elements):
                unit = {"unit": p.units[min(i, len(p.units) - 1)]} if p.units else {}
                wrong = bad if bad is None or bad.ndim == 1 else np.asarray(bad[:, i])
                part = np.asarray(values)[:, i]
                series.append(Series(f"{full}.{element}", part, _either(gone, wrong), facts | unit))
        else:
            wrong = bad if bad is None or bad.ndim == 1 else np.asarray(bad.all(axis=1))
            series.append(Series(full, np.asarray(values), _either(gone, wrong), facts | single))
    return series


def _either(first: Array | None, second: Array | None) -> Array | None:
    if first is None or second is None:
        return second if first is None else first
    return first | second


def _spread(one: Series, place: Array, rows: int) -> Series:
    """The same with the rows that other types have."""
    mask = np.ones(rows, bool)
    mask[place] = False if one.mask is None else one.mask
    if isinstance(one.values, Ragged):
        items = np.empty(rows, object)
        items[place] = np.fromiter(one.values.rows(), object, len(one.values))
        return one._replace(values=items, mask=mask)
    values = np.zeros((rows, *one.values.shape[1:]), one.values.dtype)
    values[place] = one.values
    return one._replace(values=values, mask=mask if mask.any() else None)


def titled(one: Series, units: bool) -> str:
    """The name with its unit: "scaled_accel.x [g]"."""
    unit = one.facts.get("unit", "1")
    return f"{one.name} [{unit}]" if units and unit not in ("", "1") else one.name


def library(name: str) -> Any:
    """A library that an extra of the package brings."""
    try:
        return import_module(name)
    except ImportError as error:
        raise MissingExtra(name, name) from error


def objects(one: Series) -> list[Any]:
    """The values as Python has them; None where there is none."""
    rows = one.values.rows() if isinstance(one.values, Ragged) else one.values
    items = [item.tolist() if isinstance(item, np.ndarray) else item for item in rows]
    if one.mask is None:
        return items
    return [None if gone else item for item, gone in zip(items, one.mask.tolist())]
