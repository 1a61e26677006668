"""`mip monitor`: the latest values, live."""

from __future__ import annotations

import argparse
import shutil
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator
from typing import NamedTuple

from . import inputs, outputs, ports, show, signals, silence
from .arguments import add_device, device_id, hertz, seconds
from .decoding import Found, decoded, name_of, raw_fields
from .scan import Piece
from .selection import Selection

EPILOG = """\
examples:
  mip monitor /dev/ttyACM0
  mip monitor localhost:5000 filter_data sensor.scaled_accel --rate 10
  mip monitor /dev/ttyACM0 --duration 5 > values.txt

On a terminal with the extra `monitor` (textual), the view fills the screen: arrows and the mouse
scroll, / filters by names and values, space pauses, q quits. Without the extra, only the values
that fit on the screen are shown, and Ctrl-C ends the program. If the output is not a terminal, all
values are printed again at each refresh.
"""

#: Seconds after which a value is old.
STALE = 3.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("input", metavar="PORT", help="a port, a log, or - for standard input")
    add("names", nargs="*", default=[], metavar="NAME", help="only these fields or sets")
    add("--rate", type=hertz, default=4.0, metavar="HZ", help="refresh rate (default: 4)")
    add("--duration", type=seconds, metavar="S", help="stop after S seconds")
    add_device(parser)
    silence.add_arguments(parser)
    ports.add_arguments(parser)


class _Latest:
    """The last field of a kind, and the arrival times of the last ones."""

    __slots__ = ("found", "times")

    def __init__(self, found: Found) -> None:
        self.found = found
        self.times: deque[float] = deque(maxlen=200)

    def rate(self, now: float) -> float | None:
        """Returns the rate in Hz over the last seconds."""
        recent = [t for t in self.times if now - t < STALE]
        if len(recent) < 2:
            return None
        return (len(recent) - 1) / max(recent[-1] - recent[0], 1e-9)


class Shown(NamedTuple):
    """A field with its latest values."""

    set: int
    name: str  # in the set
    rate: float | None  # in Hz
    age: float  # in seconds
    values: list[str]

    @property
    def hertz(self) -> str:
        """The rate as text."""
        return "" if self.rate is None else f"{self.rate:.4g} Hz"

    @property
    def old(self) -> str:
        """The time since its arrival, if it is long."""
        return "" if self.age < STALE else f"{self.age:.0f} s ago"


class Latest:
    """The latest values of all fields that have arrived."""

    def __init__(self, selection: Selection, device: str | None) -> None:
        self._selection = selection
        self._device = device
        self._latest: dict[tuple[int, str], _Latest] = {}
        self.packets = self.skipped = 0

    def add(self, piece: Piece, now: float) -> None:
        """Adds a piece that has arrived."""
        if piece.packet is None:
            self.skipped += len(piece.data)
            return
        self.packets += 1
        for raw in raw_fields(piece.packet):
            if self._selection.has(raw.set, raw.descriptor):
                found = decoded(raw)
                one = self._latest.setdefault((raw.set, name_of(found)), _Latest(found))
                one.found = found
                one.times.append(now)

    @property
    def summary(self) -> str:
        """Summarizes the data that arrived."""
        return f"{self.packets} packets, {self.skipped} bytes skipped"

    def shown(self, now: float) -> Iterator[Shown]:
        """Yields the fields, ordered by set and name."""
        for (number, _), one in sorted(self._latest.items()):
            found = one.found
            name = show.short(found, show.set_name(number))
            values = [show.inside(found, self._device)]
            if found.value is not None:
                values = list(show.leaves(found.value, self._device))
            yield Shown(number, name, one.rate(now), now - one.times[-1], values)

    def lines(self) -> list[str]:
        """Formats all values as lines."""
        lines, set = [self.summary], None
        for one in self.shown(time.monotonic()):
            if one.set != set:
                set = one.set
                lines.append(f"{show.set_name(set)} (0x{set:02X})")
            old = f", {one.old}" if one.old else ""
            lines.append(f"  {one.name:<26} {one.hertz:>9}{old}")
            lines += [f"      {text}" for text in one.values]
        return lines


def run(options: argparse.Namespace) -> int:
    latest = Latest(Selection(options.names), device_id(options.device))
    if inputs.is_port(options.input) and sys.stdin.isatty() and outputs.redraws(sys.stdout):
        try:
            from .monitor_screen import fill
        except ImportError:  # textual is not installed
            pass
        else:
            try:
                fill(options, latest, pieces)
            finally:
                print("\n".join(_titled(options, latest)))
            return 0
    _draw(options, latest)
    return 0


def _draw(options: argparse.Namespace, latest: Latest) -> None:
    screen = _Screen()
    shown = time.monotonic()
    with signals.handled(signals.interrupt):
        try:
            for piece in pieces(options):
                now = time.monotonic()
                if piece is not None:
                    latest.add(piece, now)
                if now - shown >= 1 / options.rate:
                    shown = now
                    screen.draw(_titled(options, latest))
        except KeyboardInterrupt:  # the usual way to end it
            pass
        finally:
            screen.draw(_titled(options, latest))
            screen.close()


def pieces(options: argparse.Namespace, say: Callable[[str], object] | None = None) -> Iterator[Piece | None]:
    """Yields data as it arrives, until the time is over. Raises Failure, or Lost like `ports.pieces`."""
    if inputs.is_port(options.input):
        yield from ports.pieces(options.input, options, options.duration, say=say)
        return
    end = None if options.duration is None else time.monotonic() + options.duration
    for piece in inputs.arriving(options.input, progress=False):
        yield piece
        if end is not None and time.monotonic() >= end:
            return


def _titled(options: argparse.Namespace, latest: Latest) -> list[str]:
    first, *lines = latest.lines()
    return [f"{options.input}: {first}", *lines]


class _Screen:
    """Draws over what was drawn before, on a terminal."""

    def __init__(self) -> None:
        self._terminal = outputs.redraws(sys.stdout)
        if self._terminal:
            sys.stdout.write("\x1b[?1049h\x1b[?25l")
        self._last: list[str] = []

    def draw(self, lines: list[str]) -> None:
        self._last = lines
        if not self._terminal:
            print("\n".join(lines), end="\n\n", flush=True)
            return
        width, height = shutil.get_terminal_size()
        if len(lines) > height - 1:
            shown = max(height - 2, 0)
            more = f"… {len(lines) - shown} more lines; name the fields to show, or pip install textual"
            lines = [*lines[:shown], more]
        text = "\r\n".join(line[:width] + "\x1b[K" for line in lines)
        sys.stdout.write(f"\x1b[H{text}\x1b[J")
        sys.stdout.flush()

    def close(self) -> None:
        """Restores the terminal; the last values stay."""
        if self._terminal:
            sys.stdout.write("\x1b[?25h\x1b[?1049l")
            if self._last:
                print("\n".join(self._last))
