"""The findings about a stream, each with its cause and its remedy."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ..binding import SECOND, UnknownName, registry
from ..cli import show
from ..cli.clocks import stamp
from ..cli.inputs import counted
from .events import CAUSES, Event
from .examined import Examined

#: The number of events of a cause that are listed.
LISTED = 5
#: A bit that is set in a smaller share of the fields, and not in the last one, is ignored: filters set it at start.
_SELDOM = 0.02


@dataclass(frozen=True)
class Finding:
    """One fault: its name, the symptom, and the remedy."""

    cause: str
    text: str
    remedy: str = ""
    details: tuple[str, ...] = ()


def of(examined: Examined) -> list[Finding]:
    """Lists the findings about a stream, the most serious first."""
    return [
        *_nothing(examined),
        *_events(examined),
        *_synchronization(examined),
        *_warnings(examined),
        *_untimed(examined),
    ]


def _nothing(examined: Examined) -> Iterator[Finding]:
    if not examined.packets:
        if examined.sentences:
            text = f"no packet, but {counted(examined.sentences, 'NMEA sentence')}"
            yield Finding(
                "no packets", text, "the port sends NMEA; enable MIP on it, or use another port of the device"
            )
        elif examined.size:
            yield Finding("no packets", f"no packet in {counted(examined.size, 'byte')}", "is the baud rate right?")
        else:
            yield Finding("no packets", "no bytes")


def _events(examined: Examined) -> Iterator[Finding]:
    for cause, meaning in CAUSES.items():
        own = [e for e in examined.events if e.cause == cause]
        if own:
            missing = sum(e.seconds for e in own)
            text = counted(len(own), "time")
            text += f", {missing:.3f} s of data are missing" if missing else ""
            lines = [line(e, examined) for e in own[:LISTED]]
            more = [f"and {len(own) - LISTED} more"] if len(own) > LISTED else []
            yield Finding(cause, text, meaning, (*lines, *more))


def line(event: Event, examined: Examined) -> str:
    """Formats an event in one line: when, where, what."""
    when = "" if event.time is None or examined.clock is None else f"{stamp(examined.clock, event.time, 3)}, "
    sets = ", ".join(map(show.set_name, sorted(event.sets)))
    gap = [f"{event.seconds:.3f} s missing"] if event.seconds else []
    said = "; ".join([*gap, *event.details])
    return f"{when}byte {event.begin}{f', {sets}' if sets else ''}{f': {said}' if said else ''}"


def _synchronization(examined: Examined) -> Iterator[Finding]:
    for number, (bad, all) in sorted(examined.unsynchronized.items()):
        text = f"{show.set_name(number)}: {bad} of {counted(all, 'timestamp')} with a date are not valid"
        yield Finding("not in time sync", text, "no time from the receiver yet, or no time and pulse at the input")


def _warnings(examined: Examined) -> Iterator[Finding]:
    for w in examined.warned:
        if not w.last and w.count < _SELDOM * w.total:
            continue
        share = f"in {w.count / w.total:.0%} of {w.field}{', also at the end' if w.last else ', not at the end'}"
        fields, commands = _concerned(w.concerns)
        notes = [f"affects {', '.join(fields)}"] if fields else []
        notes += [f"see {', '.join(f'`mip fields {c}`' for c in commands)}"] if commands else []
        yield Finding(w.bit, f"set {share}", w.text, tuple(notes))
    if examined.unnamed:
        names = ", ".join(examined.unnamed)
        yield Finding("unknown device", f"{names}: flags depend on the device", "name the device with --device")


def _concerned(names: Sequence[str]) -> tuple[list[str], list[str]]:
    """Separates names into data fields and commands."""
    fields: list[str] = []
    commands: list[str] = []
    for name in names:
        try:
            data = registry.by_name(name).SET >= 0x80
        except UnknownName:
            continue
        (fields if data else commands).append(name)
    return fields, commands


def _untimed(examined: Examined) -> Iterator[Finding]:
    for number in examined.untimed:
        text = f"{show.set_name(number)} has no timestamps, so its gaps cannot be found"
        yield Finding("no timestamps", text, "add a timestamp to its message format")


def duration(examined: Examined) -> float:
    """Returns the seconds from the first packet to the last, by the clock of the report."""
    times = [t for spans in examined.spans.values() for span in spans for t in span]
    return (max(times) - min(times)) / SECOND if times else 0.0


__all__ = ["Finding", "duration", "line", "of"]
