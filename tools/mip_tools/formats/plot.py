"""Draws values of a log over time."""

from __future__ import annotations

import argparse
import logging
import os
from collections.abc import Iterable, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

from ..binding import Data, MissingExtra, Parameter, UnknownName, info
from ..errors import Failure, Misuse
from ..files import outputs
from ..names.occurrence import Occurrence
from ..names.selection import matching_fields, one_field
from ..text import clocks

if TYPE_CHECKING:
    from ..columns import Log


FORMATS = ("png", "svg", "pdf")


class Curve(NamedTuple):
    kind: Occurrence
    parameter: Parameter
    path: str  # the name in a column
    element: str  # of a vector; empty for all


def matplotlib_pyplot(window: bool) -> Any:
    try:
        import matplotlib
        import numpy  # noqa: F401
    except ImportError:
        raise Failure(str(MissingExtra("matplotlib", "plot"))) from None
    if not window:
        matplotlib.use("Agg")
    matplotlib.rcParams["agg.path.chunksize"] = 20_000
    # On a slow machine, it would warn, the first time, that looking for fonts takes a moment.
    logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)
    import matplotlib.pyplot as pyplot

    if window and matplotlib.get_backend().lower() == "agg":
        raise Failure("no window can be opened here; write an image with -o FILE.png")
    return pyplot


def image_format(output: str | None) -> str | None:
    """Returns the format of an image file, by its extension; None if there is no file. Raises Misuse."""
    if output is None:
        return None
    ending = os.path.splitext(output)[1].lstrip(".").lower()
    if output == "-":
        return "png"
    if ending not in FORMATS:
        raise Misuse(f"'.{ending}' is not a known format; name a file that ends in .png, .svg or .pdf")
    return ending


def save(figure: Any, output: str) -> None:
    """Writes a figure. Raises Failure."""
    with outputs.whole(output) as out:
        figure.savefig(out, format=image_format(output), dpi=120)


def curves_of(name: str) -> list[Curve]:
    """Finds the curves of a name: a field, one of its parameters, or an element of a parameter."""
    occurrence, path = _split(name)
    kind = occurrence.kind
    if not issubclass(kind, Data):
        raise Misuse(f"{occurrence.name} is not a data field; `mip info` lists the fields of a log")
    numbers = [p for p in info(kind).members if _drawable(p)]
    if not path:
        plain = [p for p in numbers if p.type is None]  # enumerations and flags must be named
        if not plain:
            raise Misuse(f"{occurrence.name} has no numbers to draw; name one of its parameters")
        return [Curve(occurrence, p, p.attribute, "") for p in plain]
    by_name = {p.name: p for p in numbers}
    own = kind.NAME.partition(".")[2]
    if path[0] not in by_name and own in by_name:  # sensor.scaled_accel.x
        path = [own, *path]
    if path[0] not in by_name or len(path) > 2:
        raise Misuse(f"{occurrence.name} has no number '{'.'.join(path)}'; it has {', '.join(by_name)}")
    p = by_name[path[0]]
    element = path[1] if len(path) > 1 else ""
    if element and element not in p.elements:
        has = f"it has {', '.join(p.elements)}" if p.elements else "it is one number"
        whole = _title(Curve(occurrence, p, p.attribute, ""))
        raise Misuse(f"{whole} has no element '{element}'; {has}")
    return [Curve(occurrence, p, p.attribute, element)]


def _drawable(p: Parameter) -> bool:
    return p.kind in ("scalar", "array", "bits") and p.length is None and p.scalar != "char"


def _split(name: str) -> tuple[Occurrence, list[str]]:
    parts = name.split(".")
    last: Failure | None = None
    for count in range(len(parts), 0, -1):
        begin = ".".join(parts[:count])
        try:
            matching_fields(begin)
        except (Failure, UnknownName) as error:
            last = last or (error if isinstance(error, Failure) else None)
            continue
        return one_field(begin), parts[count:]  # raises Misuse if several sets have it
    raise last or Misuse(f"'{name}' is not a field")


def draw(pyplot: Any, log: Log, curves: Sequence[Curve], options: argparse.Namespace) -> Any:
    """Draws a figure with a diagram for each parameter, one above another, or with a single diagram."""
    np: Any = import_module("numpy")  # its masked arrays are not typed in all versions
    kinds = list(dict.fromkeys(c.kind for c in curves))
    columns = dict(zip(kinds, log.columns(kinds)))
    clock = _clock(log, columns.values())
    for kind, column in columns.items():
        if not len(column):
            raise Failure(f"{options.file} has no {kind.name}; `mip info` lists its fields")
    count = 1 if options.together else len(curves)
    figure, axes = pyplot.subplots(
        count,
        1,
        sharex=True,
        squeeze=False,
        figsize=(10, 1.0 + 2.2 * count + 1.5 * (count == 1)),
        layout="constrained",
    )
    several = len(curves) > 1 and options.together
    units = list(dict.fromkeys(c.parameter.unit for c in curves))
    for i, curve in enumerate(curves):
        axis = axes[0 if options.together else i][0]
        column = columns[curve.kind]
        values: Any = np.ma.filled(np.ma.asarray(column[curve.path], float), np.nan)
        valid = column.valid(curve.path)
        values = np.where(valid[:, None] if valid.ndim < values.ndim else valid, values, np.nan)
        times = _times(column, clock)
        for element, series in _series(curve, values):
            name = _title(curve) if several else curve.parameter.name
            label = f"{name}.{element}" if several and element else element or name
            axis.plot(times, series, label=label, linewidth=0.9, drawstyle=_style(curve))
        has_one_unit = len(units) == 1 or not options.together
        unit = curve.parameter.unit if has_one_unit else ", ".join(u for u in units if u not in ("", "1"))
        axis.set_ylabel("" if unit in ("", "1") else unit)
        if not options.together:
            axis.set_title(_title(curve), loc="left", fontsize=10)
        if values.dtype.kind == "f" and _style(curve) != "default":  # whole numbers
            axis.yaxis.get_major_locator().set_params(integer=True)
        if several or curve.parameter.elements:
            axis.legend(loc="upper right", fontsize=8)
    for (axis,) in axes:
        axis.grid(True, linewidth=0.3)
        axis.margins(x=0.01)
    if clocks.dated(clock):
        dates: Any = import_module("matplotlib.dates")
        places = dates.AutoDateLocator()
        axes[-1][0].xaxis.set_major_locator(places)
        axes[-1][0].xaxis.set_major_formatter(dates.ConciseDateFormatter(places))
    axes[-1][0].set_xlabel(_time_label(clock))
    return figure


def _clock(log: Log, columns: Iterable[Any]) -> str | None:
    """Chooses the clock of the time axis, the same for all curves: that of all packets."""
    from ..columns import timeline

    return timeline.of_log(log).clocks({number for column in columns for number in column.sets}).steady or None


def _title(curve: Curve) -> str:
    name, own = curve.kind.name, curve.parameter.name
    return name if name.partition(".")[2] == own else f"{name}.{own}"


def _style(curve: Curve) -> str:
    return "default" if curve.parameter.scalar in ("float", "double") else "steps-post"


def _series(curve: Curve, values: Any) -> list[tuple[str, Any]]:
    if values.ndim == 1:
        return [("", values)]
    elements = curve.parameter.elements
    return [(e, values[:, i]) for i, e in enumerate(elements) if not curve.element or e == curve.element]


def _times(column: Any, clock: str | None) -> Any:
    import numpy as np

    if clock is None:
        return column.packet
    times = column.time(clock).values
    if clocks.dated(clock):
        return times
    return np.where(np.isnat(times), np.nan, times.astype(np.int64) / 1e9)


def _time_label(clock: str | None) -> str:
    if clock is None:
        return "packet number"
    return "UTC" if clocks.dated(clock) else f"{clock} clock in s"
