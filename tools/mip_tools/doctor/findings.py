"""The findings about a stream, each with its cause and its remedy."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ..binding import DEVICE_CLOCK, SECOND, UnknownName, registry
from ..devices.known import in_words
from ..logs.assumed import REMEDY
from ..logs.recognize import UNKNOWN, recognized
from ..text import show
from ..text.clocks import dated, stamp
from ..text.numbers import count_text
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


def in_stream(examined: Examined) -> list[Finding]:
    """Lists the findings about a stream, the most serious first."""
    return [
        *_nothing(examined),
        *_malformed(examined),
        *_events(examined),
        *_synchronization(examined),
        *_validity(examined),
        *_warnings(examined),
        *_untimed(examined),
    ]


def _nothing(examined: Examined) -> Iterator[Finding]:
    if not examined.packets:
        what, remedy = recognized(examined.begin)
        yield Finding("no packets", f"no packet in {count_text(examined.size, 'byte')}: {what}", remedy)


def _malformed(examined: Examined) -> Iterator[Finding]:
    if examined.malformed:
        text = f"{count_text(examined.malformed, 'packet')} with a field that runs past the end"
        yield Finding(
            "malformed packets", text, "the program that made them set wrong lengths: their checksums are right"
        )


def _events(examined: Examined) -> Iterator[Finding]:
    for cause, meaning in CAUSES.items():
        own = [e for e in examined.events if e.cause == cause]
        if own:
            missing = sum(e.seconds for e in own)
            text = count_text(len(own), "time")
            text += f", {missing:.3f} s of data are missing" if missing else ""
            lines = [event_line(e, examined) for e in own[:LISTED]]
            more = [f"and {len(own) - LISTED} more"] if len(own) > LISTED else []
            whole = recognized(examined.begin) if cause == "line damage" else UNKNOWN
            yield Finding(
                cause, text, str(whole) if whole.what.startswith(("MIP with", "MIP in")) else meaning, (*lines, *more)
            )


def event_line(event: Event, examined: Examined) -> str:
    """Formats an event in one line: when, where, what."""
    when = "" if event.time is None or examined.clock is None else f"{stamp(examined.clock, event.time, 3)}, "
    sets = ", ".join(map(show.set_name, sorted(event.sets)))
    gap = [f"{event.seconds:.3f} s missing"] if event.seconds else []
    details = "; ".join([*gap, *event.details])
    return f"{when}byte {event.begin}{f', {sets}' if sets else ''}{f': {details}' if details else ''}"


def _synchronization(examined: Examined) -> Iterator[Finding]:
    for number, times in sorted(examined.times.items()):
        name, total = show.set_name(number), count_text(times.stamped, "timestamp")
        dates = sum(count for clock, count in times.valid.items() if dated(clock))
        lost = [(span.end - span.begin) / SECOND for span in times.lost if span.end is not None]
        if times.lost:
            text = (
                f"for {max(lost):.3g} s"
                if len(lost) == 1
                else f"{count_text(len(lost), 'time')}, for up to {max(lost, default=0):.3g} s"
            )
            until = " and until the end" if len(lost) < len(times.lost) else ""
            yield Finding("synchronization lost", f"{name}: {text}{until}", f"it needs {REMEDY}")
        elif times.alone.get(DEVICE_CLOCK) and not dates:
            text = f"{name}: none of {total} has a date; they count from power-on"
            yield Finding("not synchronized", text, f"to synchronize the device, it needs {REMEDY}")
        elif times.alone.get(DEVICE_CLOCK):
            text = f"{name}: {times.stamped - dates} of {total} have no date"
            yield Finding("not synchronized", text, f"to synchronize the device, it needs {REMEDY}")
        elif times.stamped and not dates:
            text = f"{name}: none of {total} is valid"
            yield Finding(
                "no valid time", text, "a GNSS receiver has none without a fix, and an external clock without pulses"
            )
        for clock, (offset, time) in times.stuck.items():
            if (clock == DEVICE_CLOCK) == bool(times.alone.get(DEVICE_CLOCK)):  # one freeze is one finding
                text = f"{name}: the {clock} clock is stuck at {stamp(clock, time, 3)}, byte {offset}"
                yield Finding("stuck", text, "restart the device; its data may be old, too")


def _validity(examined: Examined) -> Iterator[Finding]:
    for seldom in examined.seldom_valid:
        text = f"{seldom.title}: valid in {seldom.valid / seldom.total:.0%} of {seldom.total}".replace("%", " %")
        yield Finding("not valid", text, seldom.state)


def _warnings(examined: Examined) -> Iterator[Finding]:
    for w in examined.warned:
        if not w.last and w.count < _SELDOM * w.total:
            continue
        share = f"in {w.count / w.total:.0%} of {w.field}{', also at the end' if w.last else ', not at the end'}"
        fields, commands = _concerned(w.concerns)
        notes = [f"affects {', '.join(fields)}"] if fields else []
        notes += [f"see {', '.join(f'`mip fields {c}`' for c in commands)}"] if commands else []
        yield Finding(w.bit, f"set {share}", w.text, tuple(notes))
    if len(examined.devices) > 1:
        yield Finding(
            "several devices", f"the log has data of {in_words(examined.devices)}", "record each device by itself"
        )
    elif examined.unnamed:
        names = ", ".join(examined.unnamed)
        yield Finding("unknown device", f"{names}: flags depend on the device", "name the device with --device")


def _concerned(names: Sequence[str]) -> tuple[list[str], list[str]]:
    """Separates names into data fields and commands."""
    fields: list[str] = []
    commands: list[str] = []
    for name in names:
        try:
            data = registry.by_name(name).SETS[0] >= 0x80
        except UnknownName:
            continue
        (fields if data else commands).append(name)
    return fields, commands


def _untimed(examined: Examined) -> Iterator[Finding]:
    for number in examined.untimed:
        text = f"{show.set_name(number)} has no timestamps, so its gaps cannot be found"
        yield Finding("no timestamps", text, "add a timestamp to its message format")
