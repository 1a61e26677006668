"""`mip record`: writes what a device sends to a file."""

from __future__ import annotations

import argparse
from typing import Any

from ..devices.known import KnownDevice
from ..errors import Failure, Misuse
from ..files import outputs, signals
from ..options import add_baud, add_device, add_reopen, add_timeout, line_of, parse_rates, positive, seconds
from ..ports import connection
from ..ports.recording import Recording
from ..ports.start import ask_and_start
from ..text.numbers import readable

EPILOG = """\
examples:
  mip record /dev/ttyACM0 -o log.bin          until Ctrl-C
  mip record localhost:5000 -o log.bin --duration 60
  mip record /dev/ttyACM0 sensor.scaled_accel@100 sensor.scaled_gyro@100 -o log.bin
  mip record /dev/ttyACM0 -o - | mip dump -

With rates, the device is configured as by `mip stream`, with a timestamp; it continues afterwards.
Every byte is written as it arrives, including NMEA sentences and damaged packets; `mip cut` can
remove them. A recording begins with the identity of the device, so that all commands read its
flags correctly; with --device, none is requested. The file gets its name when the recording ends,
also by Ctrl-C. Until then, and if the program is killed, its name is
FILE.NUMBER.part.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("port", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT, rfc2217://HOST:PORT")
    add("names", nargs="*", default=[], metavar="NAME@HZ", help="start these fields, in place of others in their sets")
    add("-o", "--output", required=True, metavar="FILE", help="output file; - for standard output")
    add("--duration", type=seconds, metavar="S", help="stop after S seconds")
    add("--packets", type=positive, metavar="N", help="stop after N packets")
    add("--force", action="store_true", help="replace an older recording, if anything is received")
    add_device(parser, "the device, which is not asked then; `mip fields --devices` lists them")
    add_reopen(parser)
    add_timeout(parser)
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    old = options.output != "-" and outputs.holds_bytes(options.output)
    if old and not options.force:
        raise Failure(f"{options.output} exists; name another file, or replace it with --force")
    known = KnownDevice(options.device)
    names, rates = parse_rates(options.names, None)
    if bare := [name for name in names if name in options.names]:
        raise Misuse(f"{bare[0]} needs a rate, as in {bare[0]}@100")

    def begin(device: Any) -> bool:
        ask_and_start(device, known, rates, None, options.command)
        return True

    recording = Recording(line_of(options, options.port), options.duration, options.packets, begin)
    closed = False
    with signals.handled(signals.interrupt), outputs.whole(options.output, keep=True, replace=options.force) as out:
        try:
            recording.write(out)
        except KeyboardInterrupt:  # the usual way to end it
            pass
        except connection.Lost:
            closed = True
        finally:
            outputs.progress("")
        if not recording.size:
            what = "was closed before it sent anything" if closed else "has sent nothing"
            kept = f"; {options.output} is unchanged" if old else ""
            raise Failure(f"{options.port} {what}{kept}")
    for line in known.lines():
        outputs.note(line)
    outputs.note(recording.status())
    if closed:
        raise Failure(f"{options.port} was closed after {readable(recording.size)}, which are kept")
    return 0
