"""The noise of sensors: white noise, and a drift of the bias. It is stored as an integral that all fields share.

A rate contains the mean of the noise since it was last sent, a delta its integral. So both agree, and the deviation
depends on the interval.
"""

from __future__ import annotations

from functools import lru_cache
from math import expm1, sqrt
from random import Random

from mip_tools.geometry.earth import SECOND

Values = tuple[float, ...]

#: The number of past integrals that are stored, so that fields that start at the same time have the same noise.
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
        """Returns the integral since the first call; for a time before the last call, the last result."""
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
        """Returns the integral at an earlier time, even if it was not requested then."""
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


@lru_cache(64)
def _change(passed: float, drift: float, period: float) -> tuple[float, float, float, float, float]:
    """Computes the step of a Gauss-Markov process over a time: the remaining share, its contribution to the integral,
    the deviation of the change, the contribution of the change to the integral, and the deviation of the rest."""
    lost = -expm1(-passed / period)
    decay = 1 - lost
    spread = drift * sqrt(lost * (1 + decay))
    together = drift * drift * period * lost * lost
    whole = drift * drift * period * (2 * passed - period * lost * (3 - decay))
    of_change = together / (spread * spread)
    return decay, period * lost, spread, of_change, sqrt(max(0.0, whole - of_change * together))
