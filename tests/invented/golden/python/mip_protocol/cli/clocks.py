"""The times of packets: GPS time, an external clock or the device's own."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from .. import registry
from ..errors import DecodeError
from ..field import Data, Field
from ..packet import Packet, RawField
from ..parameter import Flag
from ..reflection import info
from ..simulator._facts import VALUES
from ..simulator.earth import leap_seconds, utc
from .decoding import raw_fields

#: Clocks, the best first.
CLOCKS = ("gps", "external", "reference")
SECOND = 1_000_000_000
WEEK = 604_800

_QUANTITIES = {
    "gps": ("gps.week", "gps.tow"),
    "external": ("gps.time",),
    "reference": ("reference.time",),
}


class _Source(NamedTuple):
    clock: str
    kind: type[Field]
    attributes: tuple[str, ...]
    flags: tuple[Flag, ...]


def moments(packet: Packet) -> dict[str, int]:
    """The valid times that a packet says, by their clocks."""
    found: dict[str, int] = {}
    for raw in raw_fields(packet):
        for source in _sources(raw):
            if source.clock not in found and (time := _time(source, raw)) is not None:
                found[source.clock] = time
    return found


_KNOWN: dict[tuple[int, int], tuple[_Source, ...]] = {}


def _sources(raw: RawField) -> tuple[_Source, ...]:
    key = (raw.set, raw.descriptor)
    known = _KNOWN.get(key)
    if known is None:
        kinds = registry.types(*key)
        known = _KNOWN[key] = tuple(_of_type(kinds[0])) if len(kinds) == 1 else ()
    return known


def _of_type(kind: type[Field]) -> Iterable[_Source]:
    said = VALUES.get(kind.NAME)
    if said is None or said.for_each or not issubclass(kind, Data):
        return
    places = {value.quantity: path for path, value in said.parameters.items() if value.factor == 1}
    for clock, quantities in _QUANTITIES.items():
        if all(q in places for q in quantities):
            attributes = tuple(places[q] for q in quantities)
            flags = [flag for a in attributes for flag in info(kind)[a].flags]
            yield _Source(clock, kind, attributes, tuple(dict.fromkeys(flags)))


def _time(source: _Source, raw: RawField) -> int | None:
    try:
        value = source.kind.decode(raw.data)
    except DecodeError:
        return None
    if not all(flag.holds(getattr(value, flag.attribute)) for flag in source.flags):
        return None
    numbers: list[Any] = [getattr(value, a) for a in source.attributes]
    if source.clock != "gps":
        return int(numbers[0])
    week, tow = numbers
    return week * WEEK * SECOND + round(tow * SECOND) if 0 <= tow < 2 * WEEK else None


class Timeline:
    """The time of each packet: its own, else the last one of its set."""

    def __init__(self, clock: str | None) -> None:
        self._clock = clock
        self._last: dict[int, int] = {}

    def at(self, packet: Packet) -> tuple[int | None, bool]:
        """The time, None if none is known, and whether it is the packet's own."""
        if self._clock is None:
            return None, False
        own = moments(packet).get(self._clock)
        if own is None:
            return self._last.get(packet.set), False
        self._last[packet.set] = own
        return own, True


def best(found: Callable[[], Iterable[Packet]]) -> str | None:
    """The best clock that the packets of a log have; looks no further than the first GPS time."""
    seen: set[str] = set()
    for packet in found():
        seen.update(moments(packet))
        if CLOCKS[0] in seen:
            break
    return next((clock for clock in CLOCKS if clock in seen), None)


def stamp(clock: str, time: int, digits: int = 9) -> str:
    """A time as text: UTC in ISO 8601 for GPS time, seconds for other clocks."""
    unit = 10 ** (9 - digits)
    second, rest = divmod((time + unit // 2) // unit * unit, SECOND)
    fraction = f".{rest // unit:0{digits}d}" if digits else ""
    if clock == "gps":
        try:
            return f"{utc(second * SECOND).isoformat(timespec='seconds')}{fraction}Z"
        except OverflowError:  # after the year 9999
            pass
    return f"{second}{fraction}"


__all__ = ["CLOCKS", "SECOND", "Timeline", "best", "leap_seconds", "moments", "stamp"]
