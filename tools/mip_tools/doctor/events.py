"""The events of a stream: what happened, on one timeline for all descriptor sets."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import chain

#: Cause -> its meaning, and the remedy. Causes that explain others come first.
CAUSES = {
    "reset": "the device restarted; check its power supply",
    "duplicated": "packets occur twice: a program, or a second recording of the same data, has written them again",
    "out of order": "packets are not in the order in which they were sent: UDP, or a program with several threads",
    "clock step": "the time jumped, but data did not: the clock was set, a time source appeared, or logs were joined",
    "line damage": "bytes were changed or lost in transit; check cable, baud rate and grounding",
    "never written": "a block of the file is empty: the power failed, the disk was full, or a download is incomplete",
    "changed format": "the message format was changed",
    "pause": "no data arrived, and none was damaged: the device was idle, unplugged, or not recorded",
    "overload": "packets are missing while others arrived; send less, or raise the baud rate",
    "not a number": "values are NaN or infinite although they are marked as valid, or have no flags",
    "dead": "a channel has only the value 0: the device lacks this sensor, or it does not work",
    "frozen": "a channel repeats its value: the sensor, or the program that wrote the log, has stopped",
    "saturated": "the motion exceeds the range: choose a greater one, see `mip fields sensor_range`",
    "implausible": "many values leave the others by far: a wrong byte order, or the bytes of something else",
    "spikes": "single values leave all others by far: electrical interference, or damage that the checksum missed",
    "scale": "the values are in another unit than g, or the range or the calibration of the accelerometer is wrong",
    "orientation": "mount the device level, or set its mounting: `mip fields --search mounting`",
    "cut off": "the log ends within a packet: the recording or the transfer ended early",
}

_RANK = {cause: rank for rank, cause in enumerate(CAUSES)}

#: Format changes within this many bytes are one change: the fields need not be in the same packets.
_NEAR = 4096


@dataclass
class Event:
    """Something that happened in bytes `begin` to `end` of the stream."""

    cause: str
    begin: int
    end: int
    time: int | None  # in ns, by the clock of the report
    seconds: float = 0.0  # of missing data
    sets: set[int] = field(default_factory=set)
    details: list[str] = field(default_factory=list)

    def overlaps(self, other: Event) -> bool:
        slack = _slack(self.cause, other.cause)
        return self.begin <= other.end + slack and other.begin <= self.end + slack

    def absorb(self, other: Event) -> None:
        """Merges another event into this one."""
        self.begin, self.end = min(self.begin, other.begin), max(self.end, other.end)
        self.sets |= other.sets
        self.seconds = max(self.seconds, other.seconds)
        self.time = other.time if self.time is None else self.time
        self.details += [text for text in other.details if text not in self.details]


def merged_events(events: Iterable[Event]) -> list[Event]:
    """Merges overlapping events of one cause, and drops gaps that another event explains."""
    apart: dict[str, list[Event]] = {cause: [] for cause in _RANK}  # no two events of a cause overlap
    for event in sorted(events, key=lambda e: (_RANK[e.cause], e.begin)):
        near = (_first(apart[cause], event) for cause in _RANK if cause == event.cause or explains(cause, event.cause))
        other = next((e for e in near if e is not None), None)
        if other is None:
            apart[event.cause].append(event)
        elif other.cause == event.cause:
            other.absorb(event)
        else:
            other.seconds = max(other.seconds, event.seconds)
            other.sets |= event.sets
            other.time = event.time if other.time is None else other.time
    return sorted(chain.from_iterable(apart.values()), key=lambda e: e.begin)


def _first(events: list[Event], event: Event) -> Event | None:
    """Finds the first of the events of one cause that overlaps another event."""
    at = bisect_left(events, event.begin, key=lambda e: e.end + _slack(e.cause, event.cause))
    return events[at] if at < len(events) and events[at].overlaps(event) else None


def _slack(cause: str, other: str) -> int:
    return _NEAR if cause == other == "changed format" else 0


def explains(cause: str, other: str) -> bool:
    """Can this cause explain another one: any cause a gap, or a reset a changed format?"""
    if other in ("pause", "overload"):
        return _RANK[cause] < _RANK[other]
    return cause == "reset" and other in ("clock step", "changed format")
