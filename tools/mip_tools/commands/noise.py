"""`mip noise`: white noise and bias instability of sensors, from a log at rest."""

from __future__ import annotations

import argparse
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from ..errors import Failure
from ..formats import plot
from ..logs import inputs
from ..logs.assumed import print_assumptions
from ..names.selection import one_field
from ..options import add_device

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.scan import Array

EPILOG = """\
examples:
  mip noise log.bin                                       accelerometer and gyroscope
  mip noise log.bin sensor.scaled_mag --picture noise.png

Record a device that lies still, at its full rate: some minutes for the white noise, hours for the
bias instability, which is the first minimum of the Allan deviation / 0.664 (IEEE 952). It is an
upper limit (≤) if the deviation does not rise again up to the longest time, a ninth of the log.

Kalibr and VINS call the white noise the noise density, and take it in rad/s/√Hz and m/s²/√Hz:
1 °/s/√Hz is 0.01745 rad/s/√Hz, 100 µg/√Hz are 0.000981 m/s²/√Hz.
"""
_USUAL = ("sensor.scaled_accel", "sensor.scaled_gyro")
#: Unit -> that of the white noise with its factor, and that of the bias instability with its factor.
_UNITS = {
    "g": (1e6, "µg/√Hz", 1e3, "mg"),
    "rad/s": (57.29577951308232, "°/s/√Hz", 206264.80624709636, "°/h"),
}
#: Seconds that a log must have.
_SHORTEST = 30.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("file", metavar="FILE", help="a log; - for standard input")
    add("names", nargs="*", default=[], metavar="NAME", help="fields (default: accelerometer and gyroscope)")
    add("--picture", metavar="FILE", help="draw the Allan deviations: png, svg or pdf")
    add_device(parser)


def run(options: argparse.Namespace) -> int:
    inputs.need_numpy()
    pyplot = plot.matplotlib_pyplot(window=False) if plot.image_format(options.picture) else None
    curves: dict[str, tuple[Array, Array, str]] = {}
    lines: list[str] = []
    with inputs.open_columns(options.file, options.device) as log:
        print_assumptions("noise", log, times=False, names=False)
        for name in options.names or [name for name in _USUAL if name in log] or _USUAL[:1]:
            curves |= _examined(log, name, options.file, lines)
    print("\n".join(lines))
    if pyplot is not None:
        _draw(pyplot, curves, options.picture)
    return 0


def _examined(log: Log, name: str, file: str, lines: list[str]) -> dict[str, tuple[Array, Array, str]]:
    """Adds lines with the noise of a field; returns its curves by name: times, deviations and unit. Raises Failure."""
    import numpy as np

    from ..analysis import allan
    from ..columns import timeline

    column = log[one_field(name)]
    measured = [p for p in column if getattr(column[p], "dtype", np.dtype(bool)).kind == "f"]
    if not len(column) or not measured:
        raise Failure(f"{file} has no measurements of {column.name}")
    values, parameter = np.asarray(column[measured[0]], float), column.parameters[measured[0]]
    values = values.reshape(len(values), -1)
    clock = timeline.of_log(log).clocks(column.sets).steady  # that of all packets, also of those without a date
    rate, values = _regular(column.time(clock or None).values, values, column.name)
    if len(values) < _SHORTEST * rate:
        raise Failure(f"{column.name}: {len(values) / rate:.0f} s without a gap; {_SHORTEST:.0f} s are needed at least")
    if moves := allan.motion(values, rate, parameter.unit or ""):
        raise Failure(f"{column.name}: the device {moves}; record it at rest")
    times, deviations = allan.deviation(values, rate)
    factor, unit, bias_factor, bias_unit = _UNITS.get(
        parameter.unit or "", (1.0, f"{parameter.unit}/√Hz", 1.0, str(parameter.unit))
    )
    white = allan.white_noise(times, deviations) * factor
    lines.append(f"{column.name}: {len(values) / rate:.0f} s at {rate:.6g} Hz")
    for axis, element in enumerate(parameter.elements or (measured[0],)):
        bias = allan.bias_instability(times, deviations[:, axis])
        lines.append(
            f"  {element}  white noise {white[axis]:.4g} {unit}, bias instability "
            f"{'≤ ' * bias.limit}{bias.value * bias_factor:.3g} {bias_unit} at {bias.time:.3g} s"
        )
    return {column.name: (times, deviations, parameter.unit or "")}


def _regular(times: Array, values: Array, name: str) -> tuple[float, Array]:
    """Finds the rate, and the longest part without a gap. Raises Failure."""
    import numpy as np

    if len(times) < 3 or np.isnat(times).all():
        raise Failure(f"{name} has no times; add a timestamp to the message format")
    steps = np.diff(times).astype("timedelta64[ns]")
    steps = np.where(np.isnat(steps), np.nan, steps.astype(float) / 1e9)
    step = 0.0 if np.isnan(steps).all() else float(np.nanmedian(steps))
    breaks = [-1, *np.flatnonzero(~(np.abs(steps - step) < step / 2)), len(times) - 1]
    begin, end = max(pairwise(breaks), key=lambda part: part[1] - part[0])
    if step <= 0 or end - begin < 3:
        raise Failure(f"{name} has no regular times")
    taken = slice(begin + 1, end + 1)
    return float(1 / np.mean(steps[begin + 1 : end])), values[taken]


def _draw(pyplot: Any, curves: dict[str, tuple[Array, Array, str]], path: str) -> None:
    figure, axes = pyplot.subplots(1, len(curves), figsize=(6 * len(curves), 4.5), squeeze=False, layout="constrained")
    for axis, (name, (times, deviations, unit)) in zip(axes[0], curves.items()):
        for column, letter in zip(deviations.T, "xyz"):
            axis.loglog(times, column, label=letter)
        axis.set(title=name, xlabel="averaging time in s", ylabel=f"Allan deviation in {unit}")
        axis.grid(which="both", alpha=0.3)
        axis.legend()
    plot.save(figure, path)
