"""`mip cut`: a part of a log."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from contextlib import ExitStack
from datetime import datetime, timezone
from typing import NamedTuple

from ..binding import Packet, PacketBuilder
from ..errors import Failure, Misuse
from . import clocks, inputs, outputs
from .arguments import add_selection
from .decoding import raw_fields
from .selection import Selection

EPILOG = """\
examples:
  mip cut log.bin -o part.bin --begin 60 --end 1:30        seconds from the start, or minutes
  mip cut log.bin -o part.bin --begin 2024-05-01T12:00:00  UTC, of a log with GPS time
  mip cut log.bin -o imu.bin --only sensor                 without other sets
  mip cut log.bin -o clean.bin                             without noise and damaged packets

A part holds whole packets, unchanged, without the bytes between them. --only and --without take
fields out of packets. A packet without a time has that of the one before.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("file", metavar="FILE", help="a log; - for standard input")
    add("-o", "--output", required=True, metavar="FILE", help="output file; - for standard output")
    add("--begin", type=_when, metavar="T", help="start at this time")
    add("--end", type=_when, metavar="T", help="end at this time")
    add("--bytes", type=_range, metavar="A:B", help="packets that begin in these bytes, B not included")
    add("--packets", type=_range, metavar="A:B", help="packets of these numbers, from 0, B not included")
    add("--keep-skipped", action="store_true", help="also keep bytes outside packets")
    add_selection(parser)


class _Range(NamedTuple):
    first: int
    end: int | None

    def has(self, number: int) -> bool:
        return self.first <= number and not self.past(number)

    def past(self, number: int) -> bool:
        return self.end is not None and number >= self.end


class When(NamedTuple):
    """A time in ns: from the start of the log, or since 1970 in UTC."""

    time: int
    absolute: bool


def _range(text: str) -> _Range:
    match = re.fullmatch(r"(\d*):(\d*)", text, re.ASCII)
    if match is None or text == ":":
        raise argparse.ArgumentTypeError(f"'{text}' is not a range; write 100:200, 100: or :200")
    wanted = _Range(int(match[1] or 0), int(match[2]) if match[2] else None)
    if wanted.end is not None and wanted.first > wanted.end:
        raise argparse.ArgumentTypeError(f"'{text}' begins after its end")
    return wanted


def _when(text: str) -> When:
    parts = re.fullmatch(r"(?:(?:(\d+):)?(\d+):)?(\d+(?:\.\d*)?)", text, re.ASCII)
    if parts is not None:
        hours, minutes = int(parts[1] or 0), int(parts[2] or 0)
        return When(round((hours * 3600 + minutes * 60 + float(parts[3])) * clocks.SECOND), False)
    try:
        when = datetime.fromisoformat(text.replace("Z", "+00:00"))
        if when.tzinfo is not None:
            when = when.astimezone(timezone.utc).replace(tzinfo=None)
        return When(clocks.from_date(when), True)
    except (ValueError, OverflowError):
        raise argparse.ArgumentTypeError(
            f"'{text}' is not a time; write 90 or 1:30 for time from the start, or 2024-05-01T12:00:00"
        ) from None


def run(options: argparse.Namespace) -> int:
    selection = Selection(options.only, options.without)
    outputs.refuse_input(options.output, options.file)
    begin, end = options.begin, options.end
    if begin and end and begin.absolute == end.absolute and begin.time > end.time:
        raise Misuse("--begin is after --end")
    packets = size = 0
    with ExitStack() as stack:
        name = options.file
        timed = options.begin is not None or options.end is not None
        if timed:
            name = stack.enter_context(inputs.seekable(name))
        bounds = _Bounds(options, name, timed)
        out = stack.enter_context(outputs.whole(options.output))
        for data, is_packet in _kept(name, bounds, selection, options.keep_skipped):
            out.write(data)
            size += len(data)
            packets += is_packet
        if not size:
            raise Failure(f"the part has no packets; {options.file} {bounds.known()}")
    outputs.note(f"{inputs.counted(packets, 'packet')}, {inputs.readable(size)}")
    return 0


class _Bounds:
    """The limits of the requested range."""

    def __init__(self, options: argparse.Namespace, name: str, timed: bool) -> None:
        self.bytes: _Range = options.bytes or _Range(0, None)
        self.packets: _Range = options.packets or _Range(0, None)
        self._begin: When | None = options.begin
        self._end: When | None = options.end
        self._dates = any(w is not None and w.absolute for w in (self._begin, self._end))
        self._clock = _clock(options.file, name, self._dates) if timed else None
        self._start: int | None = None
        self._now: int | None = None
        self.read = 0  # packets
        self.found = 0  # those that are within
        self.stopped = False  # before the end of the log

    def known(self) -> str:
        """Describes the log, for a range in which nothing was found."""
        if self.found:
            return "has other fields there; `mip info` lists them"
        if self._now is None or self._start is None or self.stopped:
            return f"has {inputs.counted(self.read, 'packet')}{' up to there' * self.stopped}"
        begin = ""
        if self._dates:
            begin = f"begins at {clocks.stamp(self._clock or '', self._start, 2)} and "
        return f"{begin}lasts {(self._now - self._start) / clocks.SECOND:.2f} s"

    def has(self, packet: Packet) -> bool:
        """By time; packets come in the order of the log."""
        if self._clock is None:
            return True
        own = clocks.moments(packet).get(self._clock)
        if own is not None:
            self._now = own
            self._start = own if self._start is None else self._start
        if self._now is None:
            return self._begin is None
        return self._after(self._begin, True) and not self._after(self._end, False)

    def _after(self, when: When | None, default: bool) -> bool:
        if when is None:
            return default
        assert self._now is not None and self._start is not None
        return self._now - (0 if when.absolute else self._start) >= when.time


def _clock(file: str, name: str, dates: bool) -> str:
    clock = clocks.best(lambda: (p.packet for p in inputs.pieces(name) if p.packet is not None))
    if clock is None:
        raise Failure(f"{file} has no valid times; use --packets or --bytes")
    if dates and not clocks.dated(clock):
        raise Failure(f"{file} has no dates; use seconds from the start")
    return clock


def _kept(name: str, bounds: _Bounds, selection: Selection, keep_skipped: bool) -> Iterator[tuple[bytes, bool]]:
    number = 0
    within = False
    for piece in inputs.pieces(name):
        if bounds.bytes.past(piece.offset) or bounds.packets.past(number):
            bounds.stopped = True
            return
        if piece.packet is None:
            if keep_skipped and (within or (number == 0 and bounds.bytes.has(piece.offset))):
                yield piece.data, False
            continue
        within = bounds.bytes.has(piece.offset) and bounds.packets.has(number)
        within = bounds.has(piece.packet) and within
        number += 1
        bounds.read = number
        bounds.found += within
        if within and (data := _reduced(piece.packet, selection)):
            yield data, True


def _reduced(packet: Packet, selection: Selection) -> bytes:
    """A packet with only the selected fields; nothing if it has none."""
    if selection.everything:
        return bytes(packet)
    fields = list(raw_fields(packet))
    wanted = [f for f in fields if selection.has(f.set, f.descriptor)]
    if len(wanted) == len(fields):
        return bytes(packet) if fields else b""
    if not wanted:
        return b""
    builder = PacketBuilder(packet.set)
    for raw in wanted:
        builder.add(raw.descriptor, raw.data)
    return bytes(builder.build())
