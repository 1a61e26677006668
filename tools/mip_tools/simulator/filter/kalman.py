"""Simulates the error of an estimate together with the variance that a filter computes for it."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt


class Pair:
    """A quantity and its rate, such as a position and a velocity, or an angle and the bias of a gyroscope.

    A step changes the estimate at once, but the device shows the change gradually until the next step.
    """

    __slots__ = ("change", "change_of_rate", "error", "gauss", "p", "pr", "r", "rate")

    def __init__(self, gauss: Callable[[], float]) -> None:
        """`gauss` returns random numbers with a deviation of 1, or less for errors that are smaller than the
        variances."""
        self.gauss = gauss
        self.error = self.rate = self.p = self.pr = self.r = self.change = self.change_of_rate = 0.0

    def begin(self, deviation: float, of_rate: float) -> None:
        """Restarts with errors of these deviations."""
        self.p, self.pr, self.r = deviation * deviation, 0.0, of_rate * of_rate
        self.error, self.rate = deviation * self.gauss(), of_rate * self.gauss()
        self.change = self.change_of_rate = 0.0

    def shown(self, since: float, left: float) -> float:
        """Returns the error some seconds after the step, of whose change a part is not shown yet."""
        return self.error + self.rate * since - self.change * left

    def shown_rate(self, left: float) -> float:
        return self.rate - self.change_of_rate * left

    def predict(self, time: float, noise: float, of_rate: float) -> None:
        """Advances time. `noise` and `of_rate` are variances of white noise per second."""
        change = sqrt(of_rate * time) * self.gauss()
        rest = sqrt((noise + of_rate * time * time / 12) * time) * self.gauss()
        self.error += (self.rate + change / 2) * time + rest
        self.rate += change
        self.change, self.change_of_rate = change / 2 * time + rest, change
        self.p += (2 * self.pr + self.r * time + of_rate * time * time / 3 + noise) * time
        self.pr += (self.r + of_rate * time / 2) * time
        self.r += of_rate * time

    def measure(self, deviation: float, wrong: float | None = None) -> None:
        """Applies a measurement of the quantity. `wrong` is its error; by default, a random one."""
        d = (deviation * self.gauss() if wrong is None else wrong) - self.error
        s = self.p + deviation * deviation
        k, kr = self.p / s, self.pr / s
        self._correct(k * d, kr * d)
        self.r -= kr * self.pr
        self.p, self.pr = self.p * (1 - k), self.pr * (1 - k)

    def measure_rate(self, deviation: float, wrong: float | None = None) -> None:
        """Applies a measurement of the rate."""
        d = (deviation * self.gauss() if wrong is None else wrong) - self.rate
        s = self.r + deviation * deviation
        k, kr = self.pr / s, self.r / s
        self._correct(k * d, kr * d)
        self.p -= k * self.pr
        self.r, self.pr = self.r * (1 - kr), self.pr * (1 - kr)

    def _correct(self, change: float, of_rate: float) -> None:
        self.error += change
        self.rate += of_rate
        self.change += change
        self.change_of_rate += of_rate

    def likely(self, wrong: float, deviation: float) -> bool:
        """Does a measurement agree with the estimate?"""
        d = wrong - self.error
        return d * d <= LIKELY * (self.p + deviation * deviation)


#: The square of the number of standard deviations within which a measurement is used.
LIKELY = 25.0
