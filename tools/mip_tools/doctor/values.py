"""Examines values: channels that are not numbers, frozen, dead or saturated, spikes, and gravity."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ..binding import info, timestamps
from ..columns import Column, Log
from ..columns.scan import Array
from ..devices.facts import NOISE, value_sources
from .events import Event
from .examined import Key

#: A channel with this many equal values in a row is frozen, if it has noise or changes all the time elsewhere.
_FROZEN, _FEW = 100, 20
#: The share of values that change in a channel that changes all the time.
_ALIVE = 0.9
#: A channel that has its greatest value this many times, and often twice in a row, is saturated.
_SATURATED = 5
#: A value that differs from both neighbours by this many usual steps is a spike.
_SPIKE = 100
#: Spikes in more than one of so many values are not those of a disturbance.
_MANY = 10
#: A device with less variation, in g, is at rest; gravity is then within this angle of the z axis.
_REST, _LEVEL = 0.05, np.cos(np.radians(60))
_GRAVITY = "measured.specific_force"

#: When a packet at this offset was sent.
When = Callable[[int], "int | None"]


class _Run(NamedTuple):
    """Equal values: how many, where and when the first is, the value."""

    number: int = 0
    offset: int = 0
    time: int | None = None
    value: float = 0.0


_NONE = _Run()


@dataclass
class _Extreme:
    """The greatest value so far, or the least."""

    sign: int
    value: float = -np.inf  # times the sign
    first: _Run = _NONE
    count: int = 0
    pairs: int = 0  # equal neighbours among them

    def add(self, values: Array, offset: Array, when: When, before: float | None) -> None:
        values = values * self.sign
        most = float(values.max())
        if most < self.value:
            return
        if most > self.value:
            at = int(offset[values.argmax()])
            self.value, self.count, self.pairs, self.first = most, 0, 0, _Run(0, at, when(at))
        there = values == most
        self.count += int(there.sum())
        self.pairs += int((there[1:] & there[:-1]).sum()) + bool(there[0] and before == values[0] * self.sign)


@dataclass
class _Channel:
    """One element of a parameter."""

    name: str
    has_noise: bool
    count: int = 0
    changes: int = 0
    bad: _Run = _NONE
    spikes: _Run = _NONE
    run: _Run = _NONE
    longest: _Run = _NONE
    last: float | None = None
    ends: tuple[Array, Array] | None = None  # the last two values and their offsets, neighbours of the next ones
    extremes: tuple[_Extreme, _Extreme] = field(default_factory=lambda: (_Extreme(1), _Extreme(-1)))

    def add(self, values: Array, offset: Array, when: When) -> None:
        """Adds the next values, which are valid."""
        finite = np.isfinite(values)
        if not finite.all():
            at = int(offset[~finite][0])
            first = self.bad if self.bad.number else _Run(0, at, when(at))
            self.bad = first._replace(number=first.number + int((~finite).sum()))
            values, offset = values[finite], offset[finite]
        if not len(values):
            return
        self.count += len(values)
        changed = np.append(self.last is None or values[0] != self.last, values[1:] != values[:-1])
        begins = np.flatnonzero(changed)
        self.changes += len(begins)
        self._keep(self.run._replace(number=self.run.number + (int(begins[0]) if len(begins) else len(values))))
        if len(begins):
            counts = np.diff(begins, append=len(values))
            for i in (int(counts.argmax()), -1):
                at = int(offset[begins[i]])
                if counts[i] > self.longest.number or i == -1:
                    self._keep(_Run(int(counts[i]), at, when(at), float(values[begins[i]])))
        if self.has_noise:
            for extreme in self.extremes:
                extreme.add(values, offset, when, self.last)
            self._find_spikes(values, offset, when)
        self.last = float(values[-1])

    def _keep(self, run: _Run) -> None:
        self.run = run
        if run.number > self.longest.number:
            self.longest = run

    def _find_spikes(self, values: Array, offset: Array, when: When) -> None:
        if self.ends is not None:
            values, offset = np.append(self.ends[0], values), np.append(self.ends[1], offset)
        self.ends = values[-2:].copy(), offset[-2:].copy()
        steps = np.diff(values.astype(np.float64))
        moves = np.abs(steps[steps != 0])
        usual = float(np.median(moves)) if len(moves) > _FEW else 0.0
        if usual:
            there = (steps[:-1] * steps[1:] < 0) & (np.minimum(np.abs(steps[:-1]), np.abs(steps[1:])) > _SPIKE * usual)
            rows = np.flatnonzero(there) + 1
            if len(rows):
                at = int(offset[rows[0]])
                first = self.spikes if self.spikes.number else _Run(0, at, when(at), float(values[rows[0]]))
                self.spikes = first._replace(number=first.number + len(rows))

    def findings(self) -> Iterator[tuple[str, _Run, str]]:
        """Yields causes, where they begin, and texts."""
        if self.bad.number:
            yield "not a number", self.bad, f"{self.bad.number} of {self.bad.number + self.count} values"
        if self.spikes.number:
            yield (
                "implausible" if _MANY * self.spikes.number > self.count else "spikes",
                self.spikes,
                f"{self.spikes.number} values leave the others by far, such as {self.spikes.value:.6g}",
            )
        high, low = self.extremes
        for extreme in (high, low):
            alone = extreme.count > self.longest.number or self.longest.value != extreme.sign * extreme.value
            if (
                extreme.count >= _SATURATED
                and 2 * extreme.pairs >= extreme.count
                and alone
                and high.value != -low.value
            ):
                yield "saturated", extreme.first, f"{extreme.count} values are {extreme.sign * extreme.value:.6g}"
                return
        run, others = self.longest, self.count - self.longest.number
        always = run.number == self.count and run.number >= _FEW
        alive = run.value and others >= _FEW and self.changes > _ALIVE * others
        if (self.has_noise and (always or run.number >= _FROZEN)) or (alive and run.number >= _FROZEN):
            dead = always and not run.value
            yield "dead" if dead else "frozen", run, f"{run.number} of {self.count} values are {run.value:.6g}"


class Values:
    """The channels of all fields."""

    def __init__(self) -> None:
        self._fields: dict[Key, tuple[Any, dict[str, list[_Channel]]]] = {}
        self._sums: dict[Key, Array] = {}  # of specific force, and of its squares

    def watch(self, key: Key, kind: Any, name: str) -> None:
        """Starts examining a type of field."""
        channels: dict[str, list[_Channel]] = {}
        for p in () if kind is None or timestamps.clocks_of(*key) else info(kind).parameters:
            if p.scalar in ("float", "double") and p.kind in ("scalar", "array") and p.length is None:
                source = value_sources(kind, key[0]).parameters.get(p.name)
                path = name if name.endswith(f".{p.name}") else f"{name}.{p.name}"
                has_noise = source is not None and source.quantity in NOISE and (len(p.elements) == 3)
                channels[p.attribute] = [
                    _Channel(f"{path}.{element}" if element else path, has_noise) for element in p.elements or ("",)
                ]
                if has_noise and source is not None and source.quantity == _GRAVITY:
                    self._sums[key] = np.zeros(7)
        if channels:
            self._fields[key] = kind, channels

    def add(self, log: Log, when: When) -> None:
        """Examines the values in the next part of a log."""
        columns = log.columns([(number, kind) for (number, _), (kind, _) in self._fields.items()])
        for (key, (_, channels)), column in zip(self._fields.items(), columns):
            for path, elements in channels.items() if len(column) else ():
                self._add(key, column, path, elements, when)

    def _add(self, key: Key, column: Column[Any], path: str, elements: list[_Channel], when: When) -> None:
        filled: Any = np.ma.filled  # not typed in all versions
        values: Array = filled(column[path], 0).reshape(len(column), -1)
        valid = column.valid(path)
        valid = np.broadcast_to(valid[:, None] if valid.ndim == 1 else valid, values.shape)
        offset = column.offset
        for i, channel in enumerate(elements):
            channel.add(values[valid[:, i], i], offset[valid[:, i]], when)
        if key in self._sums:
            three = values[valid.all(axis=1) & np.isfinite(values).all(axis=1)].astype(np.float64)
            self._sums[key] += [len(three), *three.sum(axis=0), *(three**2).sum(axis=0)]

    def events(self) -> Iterator[Event]:
        """Yields what is wrong with values."""
        for (number, _), (_, channels) in self._fields.items():
            for elements in channels.values():
                for channel in elements:
                    for cause, run, text in channel.findings():
                        yield Event(cause, run.offset, run.offset, run.time, 0.0, {number}, [f"{channel.name}: {text}"])
        for (number, _), sums in self._sums.items():
            for cause, text in _gravity(sums):
                yield Event(cause, 0, 0, None, 0.0, {number}, [text])


def _gravity(sums: Array) -> Iterator[tuple[str, str]]:
    """Yields what is wrong with the size or the direction of gravity on a device at rest."""
    if sums[0] < _FEW:
        return
    mean = sums[1:4] / sums[0]
    spread = np.sqrt(np.maximum(sums[4:] / sums[0] - mean**2, 0))
    size = float(np.sqrt((mean**2).sum()))
    if spread.max() > _REST * max(size, 1.0) or not size:
        return
    x, y, z = (f"{value:.2f}" for value in mean.tolist())
    if not 0.9 < size < 1.1:
        yield "scale", f"at rest, the specific force is {size:.3g} g, not 1 g: ({x}, {y}, {z})"
    elif -mean[2] < _LEVEL * size:
        yield "orientation", f"at rest, the specific force is ({x}, {y}, {z}) g; on a level device, it is (0, 0, -1) g"
