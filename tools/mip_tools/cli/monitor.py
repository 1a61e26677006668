"""`mip monitor`: the latest values, live."""

from __future__ import annotations

import argparse
import shutil
import sys
import time
from collections import deque
from collections.abc import Iterator

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

Ctrl-C ends it. If the output is not a terminal, the values are printed one after another.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("input", metavar="PORT", help="a port, a log, or - for standard input")
    add("names", nargs="*", default=[], metavar="NAME", help="these fields or sets only")
    add("--rate", type=hertz, default=4.0, metavar="HZ", help="how often to show (default: 4)")
    add("--duration", type=seconds, metavar="S", help="end after S seconds")
    add_device(parser)
    silence.add_arguments(parser)
    ports.add_arguments(parser)


class _Latest:
    """The last field of a kind, and the times of the last ones."""

    __slots__ = ("found", "times")

    def __init__(self) -> None:
        self.found: Found | None = None
        self.times: deque[float] = deque(maxlen=200)

    def rate(self, now: float) -> float | None:
        """Hz over the last seconds."""
        recent = [t for t in self.times if now - t < 3.0]
        if len(recent) < 2:
            return None
        return (len(recent) - 1) / max(recent[-1] - recent[0], 1e-9)


def run(options: argparse.Namespace) -> int:
    selection = Selection(options.names)
    device = device_id(options.device)
    screen = _Screen(options.input)
    latest: dict[tuple[int, str], _Latest] = {}
    shown = time.monotonic()
    end: float | None = None
    live = inputs.is_port(options.input)
    packets = skipped = 0
    with signals.handled(signals.interrupt):
        try:
            for piece in _pieces(options, live):
                now = time.monotonic()
                if end is None and options.duration is not None:  # the port is open now
                    end = now + options.duration
                if piece is not None and piece.packet is not None:
                    packets += 1
                    for raw in raw_fields(piece.packet):
                        if selection.has(raw.set, raw.descriptor):
                            field = decoded(raw)
                            one = latest.setdefault((raw.set, name_of(field)), _Latest())
                            one.found = field
                            one.times.append(now)
                elif piece is not None:
                    skipped += len(piece.data)
                if now - shown >= 1 / options.rate:
                    shown = now
                    screen.draw(_lines(latest, now, packets, skipped, device))
                if end is not None and now >= end:
                    break
            screen.draw(_lines(latest, time.monotonic(), packets, skipped, device))
        except KeyboardInterrupt:  # the usual way to end it
            screen.draw(_lines(latest, time.monotonic(), packets, skipped, device))
        except ports.Lost:
            screen.draw(_lines(latest, time.monotonic(), packets, skipped, device))
            raise
        finally:
            screen.close()
    return 0


def _pieces(options: argparse.Namespace, live: bool) -> Iterator[Piece | None]:
    if live:
        yield from ports.pieces(options.input, options, options.duration)
    else:
        yield from inputs.arriving(options.input, progress=False)


def _lines(
    latest: dict[tuple[int, str], _Latest], now: float, packets: int, skipped: int, device: str | None
) -> list[str]:
    lines = [f"{packets} packets, {skipped} bytes skipped"]
    set = None
    for (number, _), one in sorted(latest.items()):
        if number != set:
            set = number
            lines.append(f"{show.set_name(number)} (0x{number:02X})")
        rate = one.rate(now)
        assert one.found is not None
        old = "" if now - one.times[-1] < 3 else f", {now - one.times[-1]:.0f} s ago"
        head = f"  {show.short(one.found, show.set_name(number))}"
        lines.append(f"{head:<28} {'' if rate is None else f'{rate:.4g} Hz':>9}{old}")
        if one.found.value is None:
            lines.append(f"      {show.inside(one.found, device)}")
        else:
            lines += [f"      {text}" for text in show.leaves(one.found.value, device)]
    return lines


class _Screen:
    """Draws over what was drawn before, on a terminal."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._terminal = outputs.redraws(sys.stdout)
        if self._terminal:
            sys.stdout.write("\x1b[?1049h\x1b[?25l")
        self._last: list[str] = []

    def draw(self, lines: list[str]) -> None:
        lines = [f"{self._title}: {lines[0]}", *lines[1:]]
        self._last = lines
        if not self._terminal:
            print("\n".join(lines), end="\n\n", flush=True)
            return
        width, height = shutil.get_terminal_size()
        if len(lines) > height - 1:
            shown = max(height - 2, 0)
            more = f"… {len(lines) - shown} more lines; name the fields that you want"
            lines = [*lines[:shown], more]
        text = "\r\n".join(line[:width] + "\x1b[K" for line in lines)
        sys.stdout.write(f"\x1b[H{text}\x1b[J")
        sys.stdout.flush()

    def close(self) -> None:
        """The terminal is as before; the last values stay."""
        if self._terminal:
            sys.stdout.write("\x1b[?25h\x1b[?1049l")
            if self._last:
                print("\n".join(self._last))
