"""Allan deviation: white noise and bias instability of a sensor at rest."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ..columns.distinct import distinct

#: Numbers of averages in a factor of ten of their length.
_PER_DECADE = 10
#: The ratio of the flattest part of an Allan deviation to the bias instability, as IEEE 952 defines it.
FLICKER = 0.664
#: How much the deviation rises behind a minimum that is not by chance.
_RISES = 1.15


def deviation(values: Any, rate: float) -> tuple[Any, Any]:
    """Computes the overlapping Allan deviation of each column. Returns the times, and a row for each of them."""
    longest = len(values) // 9
    count = max(int(_PER_DECADE * np.log10(max(longest, 1))), 1)
    sizes = distinct(np.logspace(0, np.log10(max(longest, 1)), count).astype(int))
    sums = np.vstack([np.zeros(values.shape[1]), np.cumsum(values - values.mean(axis=0), axis=0)])
    rows = []
    for size in sizes:
        means = (sums[size:] - sums[:-size]) / size
        rows.append(np.sqrt(np.mean((means[size:] - means[:-size]) ** 2, axis=0) / 2))
    return sizes / rate, np.array(rows)


def white_noise(times: Any, deviations: Any) -> Any:
    """Returns the deviation of the white noise at 1 s: the line with the slope -1/2 through the short times."""
    short = times <= max(1.0, float(times[0]) * 10)
    return np.exp(np.mean(np.log(deviations[short] * np.sqrt(times[short])[:, None]), axis=0))


class Instability(NamedTuple):
    """The first minimum of an Allan deviation, as a bias instability."""

    value: float
    time: float
    limit: bool
    """The deviation does not rise again, so the instability may be lower."""


def bias_instability(times: Any, deviations: Any) -> Instability:
    """Finds the first minimum of one axis."""
    lowest = 0
    for i, each in enumerate(deviations):
        if each > _RISES * deviations[lowest]:
            return Instability(deviations[lowest] / FLICKER, times[lowest], False)
        lowest = i if each < deviations[lowest] else lowest
    return Instability(deviations[lowest] / FLICKER, times[lowest], True)


#: What a device at rest measures at most: the turn of the earth and a bias, and how much gravity may differ from 1 g.
_TURN, _GRAVITY = 0.035, 0.05
#: How much more the means of a second may change than by white noise, and than usual.
_SMOOTH, _SUDDEN = 10.0, 20.0


def motion(values: Any, rate: float, unit: str) -> str:
    """Says how a device moves; empty if it is at rest."""
    strength = float(np.linalg.norm(values.mean(axis=0)))
    if (unit == "rad/s" and strength > _TURN) or (unit == "g" and abs(strength - 1) > _GRAVITY):
        return f"moves: it measures {strength:.3g} {unit}"
    size = max(round(rate), 1)
    means = values[: len(values) // size * size].reshape(-1, size, values.shape[1]).mean(axis=1)
    changes = np.abs(np.diff(means, axis=0))
    usual = np.maximum(np.median(changes, axis=0), 1e-30)
    white = np.diff(values, axis=0).std(axis=0) / np.sqrt(2 * rate)
    if size > 1 and (usual > _SMOOTH * white).any():
        return "moves all the time"
    sudden = (changes > _SUDDEN * usual).any(axis=1)
    return f"moves after {int(sudden.argmax()) + 1} s" if sudden.any() else ""
