"""`mip info`: the contents of a log."""

from __future__ import annotations

import argparse
import json
import sys
from typing import TYPE_CHECKING, Any

from ..errors import Failure
from ..logs import inputs
from ..logs.assumed import reason_for_no_date, synchronization
from ..logs.recognize import begin_of, no_packets
from ..options import add_device
from ..text import show
from ..text.clocks import dated, stamp
from ..text.numbers import count_text, hertz, readable

if TYPE_CHECKING:
    from ..columns.intervals import Place
    from ..logs.report import Report

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
    parser.add_argument("files", nargs="+", metavar="FILE", help="a log; - for standard input")
    add_device(parser)
    parser.add_argument("--json", action="store_true", help="print a JSON object for each log, one per line")


#: The parts between restarts of a clock that are listed.
_SPANS = 4

# --------------------------------------------------------------------------- for people


def run(options: argparse.Namespace) -> int:
    status = 0
    for name in options.files:
        try:
            _print_report(name, options.device, options.json)
        except Failure as failure:
            if name == options.files[-1]:
                raise
            status = failure.status
            print(f"mip info: {failure}", file=sys.stderr)
        if not options.json and name != options.files[-1]:
            print(flush=True)
    return status


def _print_report(name: str, device: str | None, as_object: bool) -> None:
    with inputs.open_columns(name, device, empty=True) as log:
        from ..logs.report import report_on

        report = report_on(log)
        empty = None if report.packets else no_packets(name, begin_of(log))
    print(json.dumps(as_json(name, report)) if as_object else "\n".join(report_lines(name, report)))
    if empty:
        raise empty


def report_lines(name: str, report: Report) -> list[str]:
    """Formats the report as text."""
    name = "standard input" if name == "-" else name
    text = [f"{name}: {readable(report.size)}, {count_text(report.packets, 'packet')}"]
    text += list(_span(report))
    text += list(_damage(report))
    if report.fields:
        text += ["", *_table(report)]
    text += list(_gaps(report))
    return text


def _span(report: Report) -> Any:
    from ..columns.intervals import common_spans, seconds_of

    clocks = report.best
    for clock in (clocks.steady, clocks.dated if clocks.undated else ""):
        if clock:
            spans = common_spans(report.clocks[clock].values())
            spent = seconds_of(spans)
            text = ", then ".join(
                f"{stamp(clock, first, 3)} to {stamp(clock, last, 3)}" for first, last in spans[:_SPANS]
            )
            more = f", then {len(spans) - _SPANS} more" if len(spans) > _SPANS else ""
            utc = ", as UTC" if dated(clock) else ""
            restarts = f", which restarts {count_text(len(spans) - 1, 'time')}" if spans[1:] and not utc else ""
            name = "time" if clock == clocks.steady else "date"
            yield f"{name}: {text}{more}, {duration(spent)} ({clock} clock{utc}{restarts})"
    for number, times in report.timeline.sets.items():
        for clock, (_, time) in times.stuck.items():
            if clock == report.clock_of(number) or not clocks.best:
                yield f"stuck: the {clock} clock of {show.set_name(number)} is stuck at {stamp(clock, time, 3)}"
    if report.packets and not clocks.dated:
        yield f"no date: {reason_for_no_date(report.timeline)}"
    yield from synchronization(report.timeline)
    yield from report.assumed


def _damage(report: Report) -> Any:
    if not report.skipped:
        yield "skipped: nothing"
    else:
        parts = [
            count_text(n, what)
            for n, what in ((report.damaged, "damaged packet"), (report.sentences, "NMEA sentence"))
            if n
        ]
        share = report.skipped / report.size
        yield (
            f"skipped: {count_text(report.skipped, 'byte')} ({share:.2%}) in {count_text(report.runs, 'place')}"
            + (f": {', '.join(parts)}" if parts else "")
        )
    if report.malformed:
        yield f"malformed: {count_text(report.malformed, 'packet')} with a field that runs past its end"


def _table(report: Report) -> list[str]:
    rows = [("", "count", "rate Hz")]
    for number, count in sorted(report.sets.items()):
        times = report.times.get(number)
        rate = times.rate if times else None
        rows.append((f"{show.set_name(number)} (0x{number:02X})", str(count), hz(rate)))
        for (set_number, descriptor), kind in sorted(report.fields.items()):
            if set_number == number:
                rows.append((f"  {kind.name}", str(kind.count), hz(report.rate(set_number, descriptor))))
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    return [f"{a:<{widths[0]}}  {b:>{widths[1]}}  {c:>{widths[2]}}".rstrip() for a, b, c in rows]


def _gaps(report: Report) -> Any:
    for number, times in sorted(report.times.items()):
        clock = report.clock_of(number)
        count, missing, places = times.gaps
        if count:
            yield ""
            yield (
                f"{show.set_name(number)}: {count_text(count, 'gap')}, {duration(missing)} are missing; the longest:"
            )
            yield from (_at(clock, place) for place in places)
        if times.backwards:
            yield ""
            yield f"{show.set_name(number)}: time goes back {count_text(times.backwards, 'time')}:"
            yield from (_at(clock, place) for place in times.backward)


def _at(clock: str, place: Place) -> str:
    return f"  {place.seconds:+.6g} s before {stamp(clock, place.time, 3)}, byte {place.offset}"


def hz(rate: float | None) -> str:
    """Formats a rate; `-` if it is unknown."""
    return "-" if rate is None else hertz(rate)


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
        "clock": report.best.best or None,
        "device_clock": report.best.undated or None,
        "no_date": None if report.best.dated else reason_for_no_date(report.timeline),
        "assumed": report.assumed,
        "sets": [_set_json(report, number) for number in sorted(report.sets)],
        "fields": [
            {"set": number, "descriptor": descriptor, "name": kind.name, "count": kind.count}
            | {"rate": report.rate(number, descriptor)}
            for (number, descriptor), kind in sorted(report.fields.items())
        ],
    }


def _set_json(report: Report, number: int) -> dict[str, Any]:
    from ..columns.intervals import Intervals, seconds_of

    times = report.times.get(number, Intervals())
    count, missing, places = times.gaps
    return {
        "set": number,
        "name": show.set_name(number),
        "packets": report.sets[number],
        "clock": report.clock_of(number) or None,
        "rate": times.rate,
        "first": times.first,
        "last": times.last,
        "seconds": seconds_of(times.spans),  # without the steps back of a clock that restarts
        "gaps": {"count": count, "seconds": missing, "longest": [p._asdict() for p in places]},
        "backward": {"count": times.backwards, "first": [p._asdict() for p in times.backward]},
    }
