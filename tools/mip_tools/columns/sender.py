"""The device that sent a log, and how its flags are read: the same for all parts of the log, and in all tools."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..binding import registry
from ..devices.known import KnownDevice, identity_type, named_by_device
from ..names.occurrence import occurrence_in
from . import scan, walk
from .distinct import distinct
from .scan import Array

#: Bytes of a log that are searched at once.
_SEARCHED = 1 << 20
#: Bytes of a log whose flags are in memory at the same time.
_PART = 1 << 24


class Sender(KnownDevice):
    """The device of a log or of a stream."""

    def __init__(self, named: str | KnownDevice | None = None, at_port: str | None = None) -> None:
        """See `KnownDevice`; one that is given continues to learn."""
        if isinstance(named, KnownDevice):
            vars(self).update(vars(named))
        else:
            super().__init__(named, at_port)

    def device(self, log: Any) -> str | None:
        """Returns the id of the device."""
        if self.named is None and "searched" not in log.source.notes:
            log.source.notes["searched"] = True
            for reply in identity_replies(log):
                self.add_reply(reply, "from the log")
        return self.id

    def survey(self, log: Any) -> None:
        """Learns from all fields of a log, unless the device is known."""
        if self.device(log) is None and "surveyed" not in log.source.notes:
            log.source.notes["surveyed"] = True
            whole = log.whole()
            for part in whole.parts(_PART) if whole.size > _PART else (whole,):
                runs = (run for piece in part.pieces() for run in piece.runs or ())
                fields = {(run.set, run.descriptor) for run in runs if run.set >= 0x80}
                self.add_fields(fields)
                kinds = [
                    occurrence_in(number, kind)
                    for number, descriptor in sorted(fields)
                    for kind in registry.types(number, descriptor)
                    if named_by_device(kind)
                ]
                for column in part.columns(kinds) if kinds else ():
                    names = named_by_device(column.type) if len(column) else ()
                    self.add_values(column.type, {name: _numbers(np.asarray(column[name])) for name in names})

    def assumed(self, log: Any, names: bool) -> list[str]:
        """Says in a line each what is assumed about the device; see `lines`."""
        self.survey(log)
        return self.lines(names)


def _numbers(values: Array) -> list[int]:
    """Returns the different numbers in a column; bitfields in bytes have a column for each byte."""
    if values.ndim == 1:
        return [*map(int, distinct(values))]
    return [int.from_bytes(row, "little") for row in {row.tobytes() for row in values}]


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
