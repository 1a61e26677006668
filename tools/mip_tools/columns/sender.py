"""The device that sent a log, and how its flags are read: the same for all parts of the log, and in all tools."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from ..binding import DEVICES, BitsInfo, Field, Parameter, info
from ..devices.known import KnownDevice, identity_type, in_words
from ..names.occurrence import every
from . import scan, walk
from .distinct import distinct
from .scan import Array

#: Bytes of a log that are searched at once.
_SEARCHED = 1 << 20
#: Bytes of a log whose flags are in memory at the same time.
_PART = 1 << 24


class Sender(KnownDevice):
    """The device of a log or of a stream. Of an unknown device, all flags seen so far decide together how they are
    read."""

    def __init__(self, named: str | KnownDevice | None = None, at_port: str | None = None) -> None:
        """See `KnownDevice`; one that is given continues to learn."""
        if isinstance(named, KnownDevice):
            self.named, self._devices, self._reported = named.named, named._devices, named._reported
        else:
            super().__init__(named, at_port)
        self._bits: dict[tuple[type[Field], str], int] = {}
        self._recognized: dict[str, tuple[str, ...]] = {}

    def device(self, log: Any) -> str | None:
        """Returns the id of the device."""
        if self.named is None:
            self._search(log)
        return self.id

    def _search(self, log: Any) -> None:
        if "searched" not in log.source.notes:
            log.source.notes["searched"] = True
            for reply in identity_replies(log):
                self.add_reply(reply, "from the log")

    def recognized(self, log: Any, kind: type[Field], p: Parameter, path: str) -> Parameter:
        """Returns a parameter as it is on an unknown device; `path` names the column with its flags."""
        key = (kind, path)
        if key not in log.source.notes:
            log.source.notes[key] = True
            self._bits[key] = self._bits.get(key, 0) | _bits(log, kind, path, p)
        here = p.recognized(self._bits[key])
        if here.flags != p.readings[-1].flags and self._bits[key]:
            devices = next(r.devices for r in p.readings if r.flags == here.flags)
            self._recognized[f"{kind.NAME}.{path}"] = devices
        return here

    @property
    def family(self) -> set[str]:
        """The devices whose flags are like those in the log; none if the log does not show it."""
        return set.intersection(*map(set, self._recognized.values())) if self._recognized else set()

    def senders(self, column: Any, able: Iterable[str]) -> set[str]:
        """Returns which of these devices may have sent a field: its values, and all flags seen so far, have a meaning
        on them. If the values decide, `assumed` says so."""
        able = set(able) & self.family or set(able)
        found = able
        for p in info(column.type).parameters:
            kinds = {p.on(device).type for device in able}
            if len(kinds) > 1 and len(column):
                values = distinct(np.asarray(column[p.attribute])).tolist()
                meant = {
                    kind: kind is not None and all(_means(info(kind), value) for value in values) for kind in kinds
                }
                found = {device for device in found if meant[p.on(device).type]} or found
        if found < able:
            self._recognized.setdefault(column.type.NAME, tuple(sorted(found)))
        return found

    def assumed(self, log: Any) -> list[str]:
        """Says in a line each what was assumed about the device."""
        self._search(log)
        same = [
            f"{name}: flags read as those of {_those_of(them)} (recognized)" for name, them in self._recognized.items()
        ]
        return [*self.lines(), *(same if self.id is None else [])]


def identity_replies(log: Any) -> list[Any]:
    """Returns the replies in the whole log in which a device identifies itself."""
    if log.is_whole and log.found:
        return list(log.objects(identity_type())) if identity_type() else []
    return [reply for part in near_replies(log) for reply in part.objects(identity_type())]


def near_replies(log: Any, first: int = 0) -> Iterator[Any]:
    """Yields the parts of a log, from an offset on, in which a device may identify itself: of a packet each, or none
    if what looks like a packet is a part of another one."""
    kind = identity_type()
    for begin in range(first, log.size, _SEARCHED) if kind is not None else ():
        limit = min(_SEARCHED, log.size - begin)
        data, length = log.source.piece(begin, limit, scan.AHEAD)
        at, _ = scan.candidates(data, 0, limit, length, kind.SET)
        for place in at[identifies(data, at)].tolist():
            yield log.part(begin + place, begin + place + 1)
        log.source.forget(begin, begin + limit)


def identifies(data: Array, at: Array) -> Array:
    """Returns which packets contain the reply with which a device identifies itself."""
    kind, found = identity_type(), np.zeros(len(at), bool)
    if kind is not None and len(at):
        own = np.flatnonzero(data[at + 2] == kind.SET)
        for run in walk.find_runs(data, at[own], data[at[own] + 2]) if len(own) else ():
            found[own[run.packet]] |= run.descriptor == kind.DESCRIPTOR
    return found


def _bits(log: Any, kind: type[Field], path: str, p: Parameter) -> int:
    """Returns all bits that are set in these flags anywhere in the log, or enough to know how they are read."""
    bits = 0
    whole = log.whole()
    for part in whole.parts(_PART) if whole.size > _PART else (whole,):
        for column in part.columns(every(kind)):
            if len(column):
                bits |= int(np.bitwise_or.reduce(np.asarray(column[path])))
        if bits and p.recognized(bits).flags == p.readings[-1].flags:
            break
    return bits


def _means(about: Any, value: int) -> bool:
    """Has a value of an enumeration, or each part of a bitfield, a meaning?"""
    if not isinstance(about, BitsInfo):
        return value in about.names
    parts = [(bit.type, (value & bit.mask) >> bit.first) for bit in about.bits if bit.type is not None]
    known = sum(bit.mask for bit in about.bits if not bit.alias)
    return not value & ~known and all(part in info(kind).names for kind, part in parts)


def _those_of(devices: tuple[str, ...]) -> str:
    """Names devices by their generations."""
    generations = sorted({DEVICES[device].generation or 0 for device in devices})
    if not all(generations):
        return in_words([DEVICES[device].title for device in devices])
    return f"generation{'s' * (len(generations) > 1)} {in_words([*map(str, generations)])}"
