"""The noise of sensors: white noise, and a drift of the bias. It is kept as an integral, which all fields share.

A rate shows the mean of the noise since it was last sent, a delta its integral, so that both agree, and the deviation
follows from the interval.
"""

from __future__ import annotations

from functools import lru_cache
from math import expm1, sqrt
from random import Random

from .earth import SECOND

Values = tuple[float, ...]

#: Moments that are kept, so that fields that begin to be sent together see the same noise before.
KEPT = 8


class Noise:
    """The noise of one sensor.

    `density`: the Allan deviation of the white noise at 1 s; `drift`: the standard deviation of the bias, which changes
    with the correlation time `period`.
    """

    def __init__(self, axes: int, random: Random, density: float, drift: float = 0.0, period: float = 1.0) -> None:
        self.density = density
        self._drift, self._period = drift, period
        self._gauss = random.gauss
        self._time: int | None = None
        self._axes = range(axes)
        self._integral: Values = (0.0,) * axes
        self.bias: Values = tuple(drift * random.gauss(0.0, 1.0) for _ in self._axes)
        self._kept: dict[int, Values] = {}

    def integral(self, now: int) -> Values:
        """The integral since the first call; for a time before the last one, the last result."""
        if self._time is None:
            self._time = now
        passed = (now - self._time) / SECOND
        if passed <= 0:
            return self._integral
        white = self.density * sqrt(passed)
        gauss, bias = self._gauss, self.bias
        if not self._drift:
            self._integral = tuple([x + white * gauss(0.0, 1.0) for x in self._integral])
        else:
            # The drift and its integral, which depend on each other, after this time.
            decay, of_bias, spread, of_change, rest = _change(passed, self._drift, self._period)
            rest = sqrt(rest * rest + white * white)
            new = [spread * gauss(0.0, 1.0) for _ in self._axes]
            self._integral = tuple(
                [
                    x + of_bias * b + of_change * change + rest * gauss(0.0, 1.0)
                    for x, b, change in zip(self._integral, bias, new)
                ]
            )
            self.bias = tuple([decay * b + change for b, change in zip(bias, new)])
        self._time = now
        return self._integral

    def before(self, then: int, now: int) -> Values:
        """The integral at a time before now, which may not have been requested then."""
        last = self.integral(now)
        if then not in self._kept:
            passed = max(now - then, 0) / SECOND
            white = self.density * sqrt(passed)
            self._keep(then, tuple([x - b * passed - white * self._gauss(0.0, 1.0) for x, b in zip(last, self.bias)]))
        return self._kept[then]

    def _keep(self, time: int, integral: Values) -> None:
        self._kept[time] = integral
        if len(self._kept) > KEPT:
            del self._kept[next(iter(self._kept))]

    def white(self, deviation: float) -> Values:
        """Additional white noise, independent of all else."""
        return tuple([deviation * self._gauss(0.0, 1.0) for _ in self._axes])


@lru_cache(64)
def _change(passed: float, drift: float, period: float) -> tuple[float, float, float, float, float]:
    """A Gauss-Markov process after a time: how much of it is left, what it adds to its integral, the deviation
    of its change, what the change adds to the integral, and the deviation of the rest."""
    lost = -expm1(-passed / period)
    decay = 1 - lost
    spread = drift * sqrt(lost * (1 + decay))
    together = drift * drift * period * lost * lost
    whole = drift * drift * period * (2 * passed - period * lost * (3 - decay))
    of_change = together / (spread * spread)
    return decay, period * lost, spread, of_change, sqrt(max(0.0, whole - of_change * together))


__all__ = ["Noise", "Values"]
