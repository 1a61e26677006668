"""What happened in a stream, on one timeline over all descriptor sets."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

#: Cause -> what it means, and what to do.
CAUSES = {
    "line damage": "bytes were changed or lost on the way; check cable, baud rate and grounding",
    "overload": "the device left out packets while others came; send less, or raise the baud rate: `mip bandwidth`",
    "pause": "nothing came, and nothing was damaged: the device was idle, unplugged, or not recorded",
    "reset": "the device started anew; check its power supply",
    "clock step": "the time jumped, but data did not pause; the time source was set or found",
    "changed format": "the message format was changed",
}


#: Fields of a new format do not come in the same packets.
_NEAR = 4096


@dataclass
class Event:
    """Something that happened in bytes `begin` to `end` of the stream."""

    cause: str
    begin: int
    end: int
    time: int | None  # in ns, by the clock of the report
    seconds: float = 0.0  # that are missing
    sets: set[int] = field(default_factory=set)
    details: list[str] = field(default_factory=list)

    def overlaps(self, other: Event) -> bool:
        slack = _NEAR if self.cause == other.cause == "changed format" else 0
        return self.begin <= other.end + slack and other.begin <= self.end + slack

    def absorb(self, other: Event) -> None:
        """Becomes both."""
        self.begin, self.end = min(self.begin, other.begin), max(self.end, other.end)
        self.sets |= other.sets
        self.seconds = max(self.seconds, other.seconds)
        self.time = other.time if self.time is None else self.time
        self.details += [text for text in other.details if text not in self.details]


def merged(events: Iterable[Event]) -> list[Event]:
    """Events of one cause that overlap are one. A gap is explained by what else happened in it."""
    apart: list[Event] = []
    for event in sorted(events, key=lambda e: (_RANK[e.cause], e.begin)):
        other = next((e for e in apart if e.overlaps(event) and (e.cause == event.cause or explains(e, event))), None)
        if other is None:
            apart.append(event)
        elif other.cause == event.cause:
            other.absorb(event)
        else:
            other.seconds = max(other.seconds, event.seconds)
            other.sets |= event.sets
            other.time = event.time if other.time is None else other.time
    return sorted(apart, key=lambda e: e.begin)


#: What explains others comes first.
_RANK = {"reset": 0, "clock step": 1, "line damage": 2, "changed format": 3, "pause": 4, "overload": 5}


def explains(event: Event, gap: Event) -> bool:
    """Is a gap, or a format that changes with a reset, what the event has caused?"""
    if gap.cause in ("pause", "overload"):
        return _RANK[event.cause] < _RANK[gap.cause]
    return event.cause == "reset" and gap.cause in ("clock step", "changed format")


__all__ = ["CAUSES", "Event", "explains", "merged"]
