"""`mip stream`: writes what a device sends as lines or messages, as it arrives."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from typing import Any

from ..binding import Data
from ..devices.known import KnownDevice
from ..errors import Failure, Misuse
from ..files import outputs, signals
from ..files.pages import FOXGLOVE
from ..formats import foxglove, live
from ..formats.json_messages import refuse_options_of_tables
from ..logs import inputs
from ..logs.scan import Piece
from ..names.occurrence import Occurrence
from ..names.selection import Selection, matching_fields
from ..options import (
    Rates,
    add_baud,
    add_device,
    add_reopen,
    add_rows,
    add_timeout,
    hertz,
    line_of,
    parse_rates,
    positive,
    seconds,
)
from ..ports import connection
from ..ports.silence import Line
from ..ports.start import ask_and_start

EPILOG = """\
examples:
  mip stream /dev/ttyACM0                            all data, a line for each instant
  mip stream /dev/ttyACM0 sensor.scaled_accel sensor.scaled_gyro --rate 100
  mip stream /dev/ttyACM0 sensor.scaled_accel@100 sensor.scaled_mag@20 --format csv | head
  mip stream localhost:5000 --format mcap -o drive.mcap --duration 60
  mip stream /dev/ttyACM0 --format foxglove          open ws://localhost:8765 in Foxglove
  mip record /dev/ttyACM0 -o - | mip stream - --format csv

With rates, the device is configured to send these fields instead of all others in their sets, and
a timestamp unless you name one; it continues afterwards. Without rates, it is not configured. Lines
have the format of `mip export`, with the time of the device. The data of the first second determine
the clock, and the columns of csv if no fields are named.

Ctrl-C ends the stream. exit status: 3 if the device rejects a command, 4 if nothing arrives within
--timeout
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("input", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT; a log, or - for standard input")
    add("names", nargs="*", default=[], metavar="NAME[@HZ]", help="only these fields or sets; fields may have a rate")
    add("--rate", type=hertz, metavar="HZ", help="start the named fields at this rate")
    add("--format", choices=(*live.FORMATS, "foxglove"), default="jsonl", help="default: jsonl")
    add("-o", "--output", default="-", metavar="FILE", help="output file (default: standard output)")
    add("--listen", metavar="HOST:PORT", help="foxglove: where clients connect (default: 127.0.0.1:8765)")
    add("--origin", action="append", default=[], metavar="URL",
        help="foxglove: a further site whose pages may connect; * for all (default: those of Foxglove)")  # fmt: skip
    add("--duration", type=seconds, metavar="S", help="stop after S seconds")
    add("--packets", type=positive, metavar="N", help="stop after N packets")
    add_rows(parser)
    add_device(parser)
    add_reopen(parser)
    add_timeout(parser)
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    names, rates = parse_rates(options.names, options.rate)
    selection = Selection(names, data=True)
    at_port = inputs.is_port(options.input)
    if rates and not at_port:
        raise Misuse(f"{options.input} is not a port; rates are for devices")
    outputs.refuse_input(options.output, options.input)
    if (options.listen or options.origin) and options.format != "foxglove":
        raise Misuse("--listen and --origin are for --format foxglove")
    if options.format in ("mcap", "foxglove"):
        refuse_options_of_tables(options, options.format)
    sender = KnownDevice(options.device)
    line = line_of(options, options.input)._replace(gaps=[] if options.reopen else None)
    arriving = _counted(_arriving(options, line, rates, at_port, sender), options.packets)
    if options.format == "foxglove":
        return _serve(options, arriving, selection, sender, line.gaps)
    columns = [kind for name in names for kind in _single(name)] if all(map(_single, names)) else []
    errors: list[Failure] = []
    with signals.handled(signals.interrupt), outputs.whole(options.output, keep=True) as out:
        try:
            live.write_stream(
                out,
                options.format,
                _until_error(arriving, errors),
                options,
                selection,
                columns,
                sender,
                at_port and options.time != "none",
                line.gaps,
            )
        except KeyboardInterrupt:  # the usual way to end it
            pass
        except Failure as error:
            errors.append(error)
        if errors:
            raise errors[0]
    return 0


def _serve(
    options: argparse.Namespace,
    arriving: Iterator[Piece | None],
    selection: Selection,
    sender: KnownDevice,
    gaps: list[float] | None,
) -> int:
    """Serves the data to Foxglove."""
    if options.output != "-":
        raise Misuse("with --format foxglove, no file is written; for a file, use --format mcap")
    if not inputs.is_port(options.input) and options.input != "-":
        raise Misuse(
            f"{options.input} is a log; `mip export {options.input} -o log.mcap` writes a file that Foxglove can open"
        )
    server = foxglove.Server(options.input)
    place = options.listen or foxglove.USUAL
    with signals.handled(signals.interrupt), foxglove.serving(server, place, (*FOXGLOVE, *options.origin)) as url:
        print(f"mip stream: open {url} in Foxglove", file=sys.stderr, flush=True)
        try:
            foxglove.serve(server, *live.messages(arriving, options, selection, device=sender, gaps=gaps))
        except KeyboardInterrupt:  # the usual way to end it
            pass
    return 0


def _single(name: str) -> list[Occurrence]:
    """Finds the field with this name in each set that has it; empty if the name is that of a set."""
    try:
        return [occurrence for occurrence in matching_fields(name) if issubclass(occurrence.kind, Data)]
    except Misuse:
        return []


def _arriving(
    options: argparse.Namespace, line: Line, rates: Rates, at_port: bool, sender: KnownDevice
) -> Iterator[Piece | None]:
    if not at_port:
        return inputs.arriving(options.input, progress=False)

    def begin(device: Any) -> bool:
        ask_and_start(device, sender, rates, options.time, options.command)
        return not rates

    return connection.port_pieces(line, options.duration, begin)


def _until_error(pieces: Iterator[Piece | None], errors: list[Failure]) -> Iterator[Piece | None]:
    """Yields pieces. An error after the first one, such as a lost port, only ends them and is added to `errors`: what
    came before, and still waits to be written, is written then."""
    came = False
    try:
        for piece in pieces:
            came = came or piece is not None
            yield piece
    except Failure as error:
        if not came:
            raise
        errors.append(error)


def _counted(pieces: Iterator[Piece | None], most: int | None) -> Iterator[Piece | None]:
    """Yields pieces, up to `most` packets."""
    count = 0
    for piece in pieces:
        yield piece
        count += piece is not None and piece.packet is not None
        if count == most:
            return
