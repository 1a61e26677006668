"""`mip monitor`: the latest values, live."""

from __future__ import annotations

import argparse
import shutil
import sys
import time

from ..files import outputs, signals
from ..monitor.latest import Latest, device_pieces
from ..names.selection import Selection
from ..options import add_baud, add_device, add_timeout, hertz, seconds

EPILOG = """\
examples:
  mip monitor /dev/ttyACM0
  mip monitor localhost:5000 filter_data sensor.scaled_accel --rate 10
  mip monitor /dev/ttyACM0 --duration 5 > values.txt

On a terminal, the values that fit on the screen are shown until Ctrl-C: name the fields to show. If
the output is not a terminal, all values are printed again at each refresh.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("input", metavar="PORT", help="a port, a log, or - for standard input")
    add("names", nargs="*", default=[], metavar="NAME", help="only these fields or sets")
    add("--rate", type=hertz, default=4.0, metavar="HZ", help="refresh rate (default: 4)")
    add("--duration", type=seconds, metavar="S", help="stop after S seconds")
    add_device(parser)
    add_timeout(parser)
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    latest = Latest(Selection(options.names), options.device)
    screen = _Screen()
    shown = time.monotonic()
    with signals.handled(signals.interrupt):
        try:
            for piece in device_pieces(options, latest):
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
    return 0


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
            more = f"… {len(lines) - shown} more lines; name the fields to show"
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
