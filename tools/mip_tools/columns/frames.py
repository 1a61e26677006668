"""Converts tables to data frames of pandas, Polars or Arrow."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import CLOCKS, MissingExtra, timestamps
from . import between, resample, tables, times
from .column import Column
from .tables import Form, Series

if TYPE_CHECKING:
    from .log import Log
    from .reader import Kind

LIBRARIES = ("pandas", "polars", "pyarrow")


def frame(
    log: Log,
    kinds: Sequence[Kind],
    by: str,
    library: str,
    time: str | None,
    invalid: str,
    units: bool,
    position: bool,
) -> Any:
    """See `Log.frame`."""
    form = Form(by, invalid=invalid, time=time is not None, position=position)
    form.check()
    _library(library)
    columns = log.columns(kinds)
    form = form._replace(clock=_clock(log, columns, time))
    return made(tables.whole(log, columns, form).columns, library, units)


def resampled(
    log: Log, kinds: Sequence[Kind] | None, rate: str | float, method: str, library: str, time: str, units: bool
) -> Any:
    """See `Log.resample`."""
    every = resample.step(rate)
    form = Form(invalid="mask")
    if kinds is None:
        kinds = data_of(log)
    columns = log.columns(kinds)
    form = form._replace(clock=_clock(log, columns, time))
    return made(resample.resampled(log, columns, every, method, form), _library(library), units)


def nmea(log: Log, library: str, time: str | None) -> Any:
    """See `Log.nmea`."""
    clock = times.chosen(log, [n for n in log.sets() if n >= 0x80]) if time == "auto" else time or ""
    if clock and clock not in CLOCKS:
        raise ValueError(f"time {time!r}: auto, None or one of {', '.join(CLOCKS)}")
    return made(between.table(log, clock).columns, _library(library), True)


def data_of(log: Log) -> list[Kind]:
    """Lists all data fields of a log, except timestamps."""
    found = tables.survey(log, Form(wanted=lambda set, descriptor: set >= 0x80))[0]
    return [one for one in found if timestamps.clock_of(max(one[0], 0x80), one[1].DESCRIPTOR) is None]


def _library(name: str) -> str:
    if name not in LIBRARIES:
        raise ValueError(f"library {name!r}: {', '.join(LIBRARIES)}")
    return name


def _clock(log: Log, columns: Sequence[Column[Any]], time: str | None) -> str:
    """Chooses the clock of a table; if none is named, the first one that the log has."""
    if time in (None, "auto"):
        return times.chosen(log, sorted({n for c in columns for n in c.sets}))
    if time not in CLOCKS:
        raise ValueError(f"time {time!r}: auto, None or one of {', '.join(CLOCKS)}")
    return str(time)


def made(columns: Sequence[Series], library: str, units: bool) -> Any:
    """Makes a frame of this library. Raises MissingExtra."""
    return import_module(f".{library}_frame", __package__).made(columns, units)


def titled(one: Series, units: bool = True) -> str:
    """Returns the name with its unit: "scaled_accel.x [g]"."""
    unit = one.facts.get("unit", "")
    return f"{one.name} [{unit}]" if units and unit else one.name


def library(name: str) -> Any:
    """Imports a library that an extra of the package installs. Raises MissingExtra."""
    try:
        return import_module(name)
    except ImportError as error:
        raise MissingExtra(name, name) from error


def objects(one: Series) -> list[Any]:
    """Converts the values to Python objects; missing ones are None."""
    items = [item.tolist() if isinstance(item, np.ndarray) else item for item in one.values]
    if one.mask is None:
        return items
    return [None if gone else item for item, gone in zip(items, one.mask.tolist())]
