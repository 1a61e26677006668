"""Counts how often the warning bits in data are set."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..binding import BitsInfo, UnknownName, info, registry, timestamps
from ..columns import Log
from ..columns.scan import Array
from ..columns.states import in_state
from ..devices.known import named_by_device
from .examined import Key, SeldomValid, Warned

#: A field is seldom valid if a smaller share of its values is.
_SELDOM = 0.5
#: The states in which a filter has no solution yet.
_NOT_READY = ("startup", "init")
#: The field whose bits are all faults, except those that only say that a receiver has no position.
_TESTS, _NO_POSITION = "system_data.built_in_test", re.compile(r"receiver_\d_(no_solution|solution_fault)")


class Flags:
    """The counts of warning bits, by set and descriptor."""

    def __init__(self, log: Log) -> None:
        self._reads = log.reads
        self._watched: dict[Key, _Watched] = {}
        self._valid: dict[Key, _Valid] = {}
        self._state = ""
        self._unnamed: dict[str, None] = {}

    @property
    def unnamed(self) -> list[str]:
        """The fields whose flags depend on the device, which neither is known nor follows from its data."""
        return list(self._unnamed)

    def watch(self, key: Key, kind: Any) -> None:
        """Starts counting the warning bits of a type of field, if it has any."""
        if kind is None:
            return
        places = list(self._places(kind))
        if places:
            self._watched[key] = _Watched(kind, places)
        if not timestamps.clocks_of(*key) and any(p.flags for p in info(kind).parameters):
            self._valid[key] = _Valid(kind)

    def _places(self, kind: Any) -> Iterator[tuple[str, list[Any]]]:
        """Yields the parameters with warning bits."""
        device = self._reads(kind)
        for p in info(kind).parameters:
            on = named_by_device(kind).get(p.attribute)
            if on and device is None and not any(p.attribute in q.holders for q in info(kind).parameters):
                self._unnamed[kind.NAME] = None
            its_type = on[device] if on and device is not None else p.type
            about = info(its_type) if its_type is not None else None
            bits = [bit for bit in about.bits if _warns(kind, bit)] if isinstance(about, BitsInfo) else []
            if bits:
                yield p.attribute, bits

    def add(self, log: Log) -> None:
        """Counts the bits in the next part of a log."""
        columns = log.columns([(number, watched.kind) for (number, _), watched in self._watched.items()])
        for watched, column in zip(self._watched.values(), columns):
            if len(column):
                watched.total += len(column)
                for attribute, bits in watched.places:
                    for bit in bits:
                        there = _set(column[attribute], bit.mask) & in_state(column, attribute, bit)
                        count, _ = watched.counts.get((attribute, bit.name), (0, False))
                        watched.counts[attribute, bit.name] = count + int(there.sum()), bool(there[-1])

        columns = log.columns([(number, counts.kind) for (number, _), counts in self._valid.items()])
        for counts, column in zip(self._valid.values(), columns):
            if len(column):
                valid = [column.valid(name) for name in column if column.parameters[name].flags]
                whole = np.any([v if v.ndim == 1 else v.any(axis=1) for v in valid], axis=0)
                counts.valid += int(whole.sum())
                counts.total += len(column)
                counts.last = bool(whole[-1])
        self._note_state(log)

    def _note_state(self, log: Log) -> None:
        """Notes the last state of the filter."""
        try:
            column = log["filter_data.status"]
        except (UnknownName, LookupError):
            return
        if len(column):
            number, kind = int(column["filter_state"][-1]), column.parameters["filter_state"].type
            name = info(kind).names.get(number) if kind is not None else None
            ready = "the filter is not ready: " if name in _NOT_READY else ""
            self._state = f"{ready}filter_state {number}{f' ({name})' if name else ''} at the end"

    def seldom_valid(self) -> Iterator[SeldomValid]:
        """Yields the fields that are not valid most of the time, and not at the end."""
        for (number, _), watched in self._valid.items():
            if watched.total and not watched.last and watched.valid < _SELDOM * watched.total:
                state = self._state if number in _filter_sets() else ""
                yield SeldomValid(info(watched.kind).title, watched.valid, watched.total, state)

    def warned(self, names: Mapping[Key, str]) -> Iterator[Warned]:
        """Yields the bits that were set."""
        for key, watched in self._watched.items():
            for attribute, bits in watched.places:
                for bit in bits:
                    count, last = watched.counts.get((attribute, bit.name), (0, False))
                    if count:
                        yield Warned(names[key], bit.name, bit.text, bit.concerns, count, watched.total, last)


class _Watched:
    """The counts of one type of field."""

    def __init__(self, kind: Any, places: list[tuple[str, list[Any]]]) -> None:
        self.kind = kind
        self.places = places  # attributes with their warning bits
        self.total = 0
        self.counts: dict[tuple[str, str], tuple[int, bool]] = {}  # how often, and whether in the last field


@dataclass
class _Valid:
    """How often any value of a type of field is valid."""

    kind: Any
    valid: int = 0
    total: int = 0
    last: bool = False


def _warns(kind: Any, bit: Any) -> bool:
    """Does a bit in a field report a fault?"""
    if kind.NAME == _TESTS:
        return not bit.alias and not _NO_POSITION.fullmatch(bit.name)
    return bool(bit.concerns)


def _filter_sets() -> tuple[int, ...]:
    try:
        return tuple(registry.by_name("filter_data.status").SETS)
    except UnknownName:
        return ()


def _set(values: Array, mask: int) -> Array:
    """Finds the rows in which a bit is set; bitfields in bytes have a column for each byte."""
    filled: Any = np.ma.filled  # not typed in all versions
    whole: Array = filled(values, 0)
    if whole.ndim == 1:
        return np.asarray((whole & whole.dtype.type(mask)) != 0)
    size = whole.shape[1]
    return np.asarray((whole & np.frombuffer(mask.to_bytes(size, "little"), np.uint8)).any(axis=1))
