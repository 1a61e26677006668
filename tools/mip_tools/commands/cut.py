"""`mip cut`: a part of a log."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from contextlib import ExitStack
from datetime import datetime, timezone
from typing import TYPE_CHECKING

from ..binding import SECOND, from_date
from ..errors import Failure, Misuse
from ..files import outputs
from ..logs import inputs
from ..logs.assumed import no_date, print_assumptions
from ..logs.bounds import Bounds, When
from ..names.selection import Selection
from ..options import add_device, add_selection
from ..text.numbers import count_text, readable

if TYPE_CHECKING:
    from ..columns import Log

#: Bytes of a log whose packets are in memory at the same time.
PART = 1 << 23

EPILOG = """\
examples:
  mip cut log.bin -o part.bin --begin 60 --end 1:30        from the start: seconds, or MIN:SEC
  mip cut log.bin -o part.bin --begin 2024-05-01T12:00:00  UTC, for a log with GPS time
  mip cut log.bin -o imu.bin --only sensor                 without other sets
  mip cut log.bin -o clean.bin                             without noise and damaged packets

A part contains whole packets, unchanged, without the bytes between them. --only and --without
remove fields from packets. A packet without a time has the time of the packet before it. A reply
with the name of the device is in each part, so that flags mean the same there.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("file", metavar="FILE", help="a log; - for standard input")
    add("-o", "--output", required=True, metavar="FILE", help="output file; - for standard output")
    add("--begin", type=_when, metavar="T", help="start at this time")
    add("--end", type=_when, metavar="T", help="end at this time")
    add_selection(parser)
    add_device(parser)


def _when(text: str) -> When:
    parts = re.fullmatch(r"(?:(?:(\d+):)?(\d+):)?(\d+(?:\.\d*)?)", text, re.ASCII)
    if parts is not None:
        hours, minutes = int(parts[1] or 0), int(parts[2] or 0)
        return When(round((hours * 3600 + minutes * 60 + float(parts[3])) * SECOND), False)
    try:
        when = datetime.fromisoformat(text.replace("Z", "+00:00"))
        if when.tzinfo is not None:
            when = when.astimezone(timezone.utc).replace(tzinfo=None)
        return When(from_date(when), True)
    except (ValueError, OverflowError):
        raise argparse.ArgumentTypeError(
            f"'{text}' is not a time; write 90 or 1:30 for time from the start, or 2024-05-01T12:00:00"
        ) from None


def run(options: argparse.Namespace) -> int:
    selection = Selection(options.only, options.without)
    outputs.refuse_input(options.output, options.file)
    bounds = Bounds(options.begin, options.end)
    begin, end = bounds.begin, bounds.end
    if begin and end and begin.absolute == end.absolute and begin.time > end.time:
        raise Misuse("--begin is after --end")
    inputs.need_numpy()
    from ..logs.part import Within, kept

    packets = size = 0
    with ExitStack() as stack:
        clock, log, parts = None, None, _arriving(options.file)
        if bounds.timed or inputs.is_log(options.file):
            log = stack.enter_context(inputs.open_columns(options.file, options.device))
            clock = _clock(log, options.file, bounds) if bounds.timed else None
            if clock:
                print_assumptions("cut", log, times=False, names=False)
            parts = ((0, part) for part in log.parts(PART))
        within = Within(bounds, clock)
        out = stack.enter_context(outputs.whole(options.output))
        for data, count in kept(parts, within, selection):
            out.write(data)
            out.flush()
            size += len(data)
            packets += count
        if not packets:
            raise Failure(f"the part has no packets; {options.file} {within.description()}")
    outputs.note(f"{count_text(packets, 'packet')}, {readable(size)}")
    return 0


def _clock(log: Log, name: str, bounds: Bounds) -> str:
    """Chooses the clock for the times of the cut. Raises Failure if the log has no suitable one."""
    from ..columns import timeline

    line = timeline.of_log(log)
    clocks_of_log = line.clocks(line.sets)
    if not clocks_of_log.best:
        raise Failure(f"{name} has no valid times")
    if bounds.dated and not clocks_of_log.dated:
        raise Failure(f"{name} has {no_date(line)}; use seconds from the start")
    return clocks_of_log.dated if bounds.dated else clocks_of_log.steady


def _arriving(name: str) -> Iterator[tuple[int, Log]]:
    """Yields the data that arrives in a pipe, each piece with its offset in the stream."""
    from ..columns import read_log

    place = 0
    for batch in inputs.batches(inputs.arriving(name)):
        data = b"".join(piece.data for piece in batch)
        yield place, read_log(data)
        place += len(data)
