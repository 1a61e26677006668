"""`mip record`: writes what a device sends to a file."""

from __future__ import annotations

import argparse
import time
from typing import IO

from ..errors import Failure
from . import inputs, outputs, ports, signals, silence
from .arguments import positive, seconds
from .scan import Scanner

EPILOG = """\
examples:
  mip record /dev/ttyACM0 -o log.bin          until Ctrl-C
  mip record localhost:5000 -o log.bin --duration 60
  mip record /dev/ttyACM0 -o - | mip dump -

Every byte is written as it arrives, including NMEA sentences and damaged packets; `mip cut` can
remove them. The file gets its name when the recording ends, by Ctrl-C too. Until then, and if the
program is killed, its name is FILE.NUMBER.part.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("port", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT, rfc2217://HOST:PORT")
    add("-o", "--output", required=True, metavar="FILE", help="output file; - for standard output")
    add("--duration", type=seconds, metavar="S", help="stop after S seconds")
    add("--packets", type=positive, metavar="N", help="stop after N packets")
    add("--force", action="store_true", help="replace an older recording, if anything is received")
    silence.add_arguments(parser)
    ports.add_arguments(parser)


def run(options: argparse.Namespace) -> int:
    old = options.output != "-" and outputs.holds_bytes(options.output)
    if old and not options.force:
        raise Failure(f"{options.output} exists; name another file, or replace it with --force")
    recording = _Recording(options)
    closed = False
    with signals.handled(signals.interrupt), outputs.whole(options.output, keep=True, replace=options.force) as out:
        try:
            recording.write(out)
        except KeyboardInterrupt:  # the usual way to end it
            pass
        except ports.Lost:
            closed = True
        finally:
            outputs.progress("")
        if not recording.size:
            what = "was closed before it sent anything" if closed else "has sent nothing"
            kept = f"; {options.output} is unchanged" if old else ""
            raise Failure(f"{options.port} {what}{kept}")
    outputs.note(recording.status())
    if closed:
        raise Failure(f"{options.port} was closed after {inputs.readable(recording.size)}, which are kept")
    return 0


class _Recording:
    def __init__(self, options: argparse.Namespace) -> None:
        self._options = options
        self._scanner = Scanner()
        self.size = 0
        self.packets = 0
        self.skipped = 0
        self._shown = self._start = time.monotonic()

    def write(self, out: IO[bytes]) -> None:
        """Writes the received bytes until the requested duration or number of packets is reached."""
        options = self._options
        watch: silence.Silence | None = None
        for data in ports.received(options.port, options, options.duration):
            watch = watch or silence.Silence(options.port, options)
            keep = len(data)
            if data:
                watch.data()
            for piece in self._scanner.feed(data):
                if piece.packet is not None:
                    watch.packet()
                self.packets += piece.packet is not None
                self.skipped += len(piece.data) * (piece.packet is None)
                if self.packets == options.packets:
                    keep = piece.offset + len(piece.data) - self.size
                    break
            out.write(data[:keep])
            out.flush()  # so that written bytes are safe even if this program is killed
            self.size += keep
            self._show()
            watch.check()
            if self.packets == options.packets:
                return

    def status(self) -> str:
        """Summarizes the recording."""
        spent = max(time.monotonic() - self._start, 1e-9)
        return (
            f"{spent:.0f} s, {inputs.readable(self.size)}, {self.packets} packets, "
            f"{self.packets / spent:.0f} per second, {self.skipped} bytes skipped"
        )

    def _show(self) -> None:
        now = time.monotonic()
        if now - self._shown > 0.5:
            self._shown = now
            outputs.progress(self.status())
