"""Counts how often the warning bits in data are set."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from ..binding import BitsInfo, info
from ..columns import Log
from ..columns.scan import Array
from .examined import Key, Warned


class Flags:
    """The counts of warning bits, by set and descriptor."""

    def __init__(self, device: str | None) -> None:
        self._device = device
        self._watched: dict[Key, _Watched] = {}
        #: The fields whose flags depend on the device, which is not known.
        self.unnamed: list[str] = []

    def watch(self, key: Key, kind: Any) -> None:
        """Starts counting the warning bits of a type of field, if it has any."""
        places = [] if kind is None else list(self._places(kind))
        if places:
            self._watched[key] = _Watched(kind, places)

    def _places(self, kind: Any) -> Iterator[tuple[str, list[Any]]]:
        """Yields the parameters with warning bits."""
        for p in info(kind).parameters:
            if p.variants and self._device is None and any("type" in v.changes for v in p.variants):
                self.unnamed += [kind.NAME] if kind.NAME not in self.unnamed else []
            here = p.on(self._device) if self._device is not None else p
            if here.type is None or p.kind != "scalar":
                continue
            said = info(here.type)
            bits = [bit for bit in said.bits if bit.concerns] if isinstance(said, BitsInfo) else []
            if bits:
                yield p.attribute, bits

    def add(self, log: Log) -> None:
        """Counts the bits in the next part of a log."""
        columns = log.columns([(number, one.kind) for (number, _), one in self._watched.items()])
        for one, column in zip(self._watched.values(), columns):
            if len(column):
                one.total += len(column)
                for attribute, bits in one.places:
                    for bit in bits:
                        there = _set(column[attribute], bit.mask)
                        count, _ = one.counts.get((attribute, bit.name), (0, False))
                        one.counts[attribute, bit.name] = count + int(there.sum()), bool(there[-1])

    def warned(self, names: Mapping[Key, str]) -> Iterator[Warned]:
        """Yields the bits that were set."""
        for key, one in self._watched.items():
            for attribute, bits in one.places:
                for bit in bits:
                    count, last = one.counts.get((attribute, bit.name), (0, False))
                    if count:
                        yield Warned(names[key], bit.name, bit.text, bit.concerns, count, one.total, last)


class _Watched:
    """The counts of one type of field."""

    def __init__(self, kind: Any, places: list[tuple[str, list[Any]]]) -> None:
        self.kind = kind
        self.places = places  # attributes with their warning bits
        self.total = 0
        self.counts: dict[tuple[str, str], tuple[int, bool]] = {}  # how often, and whether in the last field


def _set(values: Array, mask: int) -> Array:
    """Finds the rows in which a bit is set; bitfields in bytes have a column for each byte."""
    filled: Any = np.ma.filled  # not typed in all versions
    whole: Array = filled(values, 0)
    if whole.ndim == 1:
        return np.asarray((whole & whole.dtype.type(mask)) != 0)
    size = whole.shape[1]
    return np.asarray((whole & np.frombuffer(mask.to_bytes(size, "little"), np.uint8)).any(axis=1))


__all__ = ["Flags"]
