"""`mip stream`: writes what a device sends as lines or messages, as it arrives."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from ..binding import Data, MipError, NoSuchRate, Refused, session, timestamps
from ..errors import Failure, Misuse
from ..occurrence import Occurrence
from . import inputs, live, outputs, ports, show, signals, silence, table_options
from .arguments import hertz, positive, seconds
from .clocks import CLOCKS, dated
from .scan import Piece
from .selection import Selection, fields

if TYPE_CHECKING:
    from ..binding import DeviceAtPort, Field

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

Ctrl-C ends the stream. exit status: 4 if nothing arrives within --timeout
"""

_RATE = re.compile(r"(.+)@([^@]*)")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("input", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT; a log, or - for standard input")
    add("names", nargs="*", default=[], metavar="NAME[@HZ]", help="only these fields or sets; fields may have a rate")
    add("--rate", type=hertz, metavar="HZ", help="start the named fields at this rate")
    add("--format", choices=(*live.FORMATS, "foxglove"), default="jsonl", help="default: jsonl")
    add("-o", "--output", default="-", metavar="FILE", help="output file (default: standard output)")
    add("--listen", metavar="HOST:PORT", help="foxglove: where clients connect (default: 127.0.0.1:8765)")
    add("--duration", type=seconds, metavar="S", help="stop after S seconds")
    add("--packets", type=positive, metavar="N", help="stop after N packets")
    table_options.add_arguments(parser)
    silence.add_arguments(parser)
    ports.add_arguments(parser)


def run(options: argparse.Namespace) -> int:
    names, rates = asked(options.names, options.rate)
    selection = Selection(names, data=True)
    at_port = inputs.is_port(options.input)
    if rates and not at_port:
        raise Misuse(f"{options.input} is not a port; rates are for devices")
    outputs.refuse_input(options.output, options.input)
    if options.listen and options.format != "foxglove":
        raise Misuse("--listen is for --format foxglove")
    if options.format == "foxglove":
        return _serve(options, _counted(_arriving(options, rates, at_port), options.packets), selection)
    found = [one for name in names for one in _single(name)] if all(map(_single, names)) else []
    arriving = _counted(_arriving(options, rates, at_port), options.packets)
    with signals.handled(signals.interrupt), outputs.whole(options.output, keep=True) as out:
        try:
            live.write(out, options.format, arriving, options, selection, found)
        except KeyboardInterrupt:  # the usual way to end it
            pass
    return 0


def _serve(options: argparse.Namespace, arriving: Iterator[Piece | None], selection: Selection) -> int:
    """Serves the data to Foxglove."""
    from . import foxglove

    if options.output != "-":
        raise Misuse("with --format foxglove, no file is written; for a file, use --format mcap")
    if not inputs.is_port(options.input) and options.input != "-":
        raise Misuse(
            f"{options.input} is a log; `mip export {options.input} -o log.mcap` writes a file that Foxglove can open"
        )
    server = foxglove.Server(options.input)
    place = options.listen or foxglove.USUAL
    with signals.handled(signals.interrupt), foxglove.serving(server, place) as url:
        print(f"mip stream: open {url} in Foxglove", file=sys.stderr, flush=True)
        try:
            live.serve(server, arriving, options, selection)
        except KeyboardInterrupt:  # the usual way to end it
            pass
    return 0


Rates = dict[Occurrence, float]


def asked(words: list[str], rate: float | None) -> tuple[list[str], Rates]:
    """Parses the names, and the rates of fields. Raises Misuse."""
    if rate is not None and not words:
        raise Misuse("--rate needs fields; name them, as in sensor.scaled_accel")
    names: list[str] = []
    rates: Rates = {}
    for word in words:
        said = _RATE.fullmatch(word)
        name, wanted = (said[1], _hertz(said[2])) if said else (word, rate)
        names.append(name)
        if wanted is not None:
            rates |= {one: wanted for one in _of_one_set(name)}
    return names, rates


def _hertz(text: str) -> float:
    try:
        return hertz(text)
    except argparse.ArgumentTypeError as error:
        raise Misuse(str(error)) from None


def _single(name: str) -> list[Occurrence]:
    """Finds the field with this name in each set that has it; empty if the name is that of a set."""
    try:
        return [one for one in fields(name) if issubclass(one.kind, Data)]
    except Misuse:
        return []


def _of_one_set(name: str) -> list[Occurrence]:
    found = [one for one in fields(name) if issubclass(one.kind, Data)]
    if not found:
        raise Misuse(f"{name} is not a data field, and only these have a rate; `mip fields` lists them")
    if len(found) > 1:
        raise Misuse(f"'{name}' is in several sets; write {' or '.join(one.name for one in found)}")
    return found


def _start(device: DeviceAtPort, rates: Rates, time: str | None) -> None:
    """Starts fields at their rates, set by set. Shared fields are started in each of these sets.

    A timestamp is added if none is named, unless `time` is "none".
    """
    if session() is None:
        raise Failure("the specification of this package names no commands that start data")
    shared = {one.kind: rate for one, rate in rates.items() if isinstance(one.kind.SETS, range)}
    sets: dict[int, dict[type[Field], float]] = {}
    for one, rate in rates.items():
        if one.kind not in shared:
            sets.setdefault(one.set, {})[one.kind] = rate
    if not sets:
        raise Misuse("a shared field is sent in the packets of other fields; add one of a data set")
    for number, own in sets.items():
        wanted = {**shared, **own}
        for stamp in _timestamps(number, wanted, time):
            try:
                device.stream(wanted | stamp, set=number)
                break
            except (OSError, MipError) as error:
                if not stamp or not isinstance(error, (Refused, NoSuchRate)):
                    reason = ports.reason(error)
                    raise Failure(f"{show.set_name(number)} cannot be started: {reason}") from None


def _timestamps(number: int, wanted: dict[type[Field], float], time: str | None) -> Iterator[dict[type[Field], float]]:
    """Yields the timestamps to try for a set, with their rate: first one that is always valid, last no timestamp."""
    suitable = [clock for clock in reversed(CLOCKS) if time not in ("utc", "unix") or dated(clock)]
    known = [kind for clock in suitable for kind in timestamps.kinds(number, clock)]
    if time != "none" and not any(kind in wanted for kind in known):
        rate = 0 if 0 in wanted.values() else max(wanted.values())
        yield from ({kind: rate} for kind in known)
    yield {}


def _arriving(options: argparse.Namespace, rates: Rates, at_port: bool) -> Iterator[Piece | None]:
    if not at_port:
        return inputs.arriving(options.input, progress=False)
    begin = (lambda device: _start(device, rates, options.time)) if rates else None
    return ports.pieces(options.input, options, options.duration, begin)


def _counted(pieces: Iterator[Piece | None], most: int | None) -> Iterator[Piece | None]:
    """Yields pieces, up to `most` packets."""
    count = 0
    for piece in pieces:
        yield piece
        count += piece is not None and piece.packet is not None
        if count == most:
            return
