"""`mip info`: the contents of a log."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING, Any

from . import inputs, show
from .clocks import SECOND, dated, stamp
from .intervals import Intervals, Place

if TYPE_CHECKING:
    from .log_report import Report

EPILOG = """\
examples:
  mip info log.bin
  mip info log.bin --json | jq '.fields[].name'

Rates are in Hz, from the timestamps in the packets, without gaps. A gap is an interval between
packets of a set of more than 1.5 times the usual one. A damaged packet begins like a packet, but
has a wrong checksum or is incomplete.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    parser.add_argument("file", metavar="FILE", help="a log; - for standard input")
    parser.add_argument("--json", action="store_true", help="print JSON, for programs")


# --------------------------------------------------------------------------- for people


def run(options: argparse.Namespace) -> int:
    with inputs.columns(options.file) as log:
        from .log_report import examine

        report = examine(log)
    if options.json:
        print(json.dumps(as_json(options.file, report), indent=2))
    else:
        for text in lines(options.file, report):
            print(text)
    return 0


def lines(name: str, report: Report) -> list[str]:
    """Formats the report as text."""
    name = "standard input" if name == "-" else name
    text = [f"{name}: {inputs.readable(report.size)}, {_count(report.packets, 'packet')}"]
    text += list(_span(report))
    text += list(_damage(report))
    if report.fields:
        text += ["", *_table(report)]
    text += list(_gaps(report))
    return text


def _span(report: Report) -> Any:
    clock = report.clock
    if clock is None:
        if report.packets:
            yield "time: no valid timestamps"
        return
    firsts = [i.first for i in report.times.values() if i.first is not None]
    lasts = [i.last for i in report.times.values() if i.last is not None]
    first, last = min(firsts), max(lasts)
    yield (
        f"time: {stamp(clock, first, 3)} to {stamp(clock, last, 3)}, {duration((last - first) / SECOND)} "
        f"({clock} clock{', as UTC' if dated(clock) else ''})"
    )


def _damage(report: Report) -> Any:
    if not report.skipped:
        yield "skipped: nothing"
    else:
        parts = [
            _count(n, what)
            for n, what in ((report.damaged, "damaged packet"), (report.sentences, "NMEA sentence"))
            if n
        ]
        share = report.skipped / report.size
        yield (
            f"skipped: {_count(report.skipped, 'byte')} ({share:.2%}) in {_count(report.runs, 'place')}"
            + (f": {', '.join(parts)}" if parts else "")
        )
    if report.malformed:
        yield f"malformed: {_count(report.malformed, 'packet')} with a field that runs past its end"


def _table(report: Report) -> list[str]:
    rows = [("", "count", "rate Hz")]
    for number, count in sorted(report.sets.items()):
        times = report.times.get(number)
        rate = times.rate if times else None
        rows.append((f"{show.set_name(number)} (0x{number:02X})", str(count), hz(rate)))
        for (set, _), kind in sorted(report.fields.items()):
            if set == number:
                own = rate * kind.packets / times.count if rate and times else None
                rows.append((f"  {kind.name}", str(kind.count), hz(own)))
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    return [f"{a:<{widths[0]}}  {b:>{widths[1]}}  {c:>{widths[2]}}".rstrip() for a, b, c in rows]


def _gaps(report: Report) -> Any:
    clock = report.clock
    for number, times in sorted(report.times.items()):
        count, missing, places = times.gaps
        if count:
            yield ""
            yield (f"{show.set_name(number)}: {_count(count, 'gap')}, {duration(missing)} are missing; the longest:")
            yield from (_at(clock or "", place) for place in places)
        if times.backwards:
            yield ""
            yield f"{show.set_name(number)}: time goes back {_count(times.backwards, 'time')}:"
            yield from (_at(clock or "", place) for place in times.backward)


def _at(clock: str, place: Place) -> str:
    return f"  {place.seconds:+.6g} s before {stamp(clock, place.time, 3)}, byte {place.offset}"


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'s' * (number != 1)}"


def hz(rate: float | None) -> str:
    """Formats a rate; `-` if it is unknown."""
    return "-" if rate is None else f"{rate:.4g}"


def duration(seconds: float) -> str:
    """Formats a duration for people."""
    if seconds < 60:
        return f"{seconds:.3f} s"
    minutes, rest = divmod(seconds, 60)
    hours, minutes = divmod(int(minutes), 60)
    return f"{hours} h {minutes:02d} min {rest:04.1f} s" if hours else f"{minutes} min {rest:04.1f} s"


# --------------------------------------------------------------------------- for programs


def as_json(name: str, report: Report) -> dict[str, Any]:
    """Converts the report for JSON; times are in ns, since 1970 if the clock has a date."""
    return {
        "file": name,
        "bytes": report.size,
        "packets": report.packets,
        "malformed": report.malformed,
        "skipped": {
            "bytes": report.skipped,
            "places": report.runs,
            "damaged": report.damaged,
            "nmea": report.sentences,
        },
        "clock": report.clock,
        "sets": [_set_json(report, number) for number in sorted(report.sets)],
        "fields": [
            {"set": set, "descriptor": descriptor, "name": kind.name, "count": kind.count}
            for (set, descriptor), kind in sorted(report.fields.items())
        ],
    }


def _set_json(report: Report, number: int) -> dict[str, Any]:
    times = report.times.get(number, Intervals())
    count, missing, places = times.gaps
    return {
        "set": number,
        "name": show.set_name(number),
        "packets": report.sets[number],
        "rate": times.rate,
        "first": times.first,
        "last": times.last,
        "gaps": {"count": count, "seconds": missing, "longest": [p._asdict() for p in places]},
        "backward": {"count": times.backwards, "first": [p._asdict() for p in times.backward]},
    }


__all__ = ["duration", "hz"]
