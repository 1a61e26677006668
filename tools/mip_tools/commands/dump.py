"""`mip dump`: packets with names, values and units."""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Iterator
from importlib.util import find_spec

from ..devices.known import KnownDevice
from ..errors import Failure, Misuse
from ..logs import inputs
from ..logs.assumed import print_assumptions
from ..logs.recognize import MOST, UNKNOWN, recognized, without_checksum
from ..logs.scan import Piece, Scanner
from ..names.selection import Selection
from ..options import add_baud, add_device, add_selection, add_timeout, line_of, positive
from ..ports import connection
from ..text import objects, show
from ..text.numbers import count_text

EPILOG = """\
examples:
  mip dump 75 65 01 02 02 01 E0 C6       one packet explained
  mip dump log.bin | head                a line for each packet
  mip dump log.bin --only sensor.scaled_accel --tree
  mip dump /dev/ttyACM0 --skipped        live, with the bytes between packets
  cat log.bin | mip dump - --json | jq .
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add(
        "input",
        nargs="+",
        metavar="INPUT",
        help="a file of bytes or of hexadecimal digits, - for standard input, bytes in hexadecimal, "
        "or a port such as /dev/ttyACM0, COM3, HOST:PORT",
    )
    add_selection(parser)
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--tree", action="store_true", help="a line for each value, with bytes")
    form.add_argument("--line", action="store_true", help="a line for each packet (default, except for bytes)")
    form.add_argument("--json", action="store_true", help="a JSON object for each packet, as it arrives")
    add("--raw", action="store_true", help="add each packet in hexadecimal")
    add("--skipped", action="store_true", help="also show bytes outside packets")
    add("--count", type=positive, metavar="N", help="stop after N packets")
    add_device(parser)
    add_timeout(parser)
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    selection = Selection(options.only, options.without)
    bytes_given = inputs.typed_bytes(options.input)
    explain = bytes_given is not None and not inputs.exists(options.input[0])
    as_tree = options.tree or (explain and not options.line and not options.json)
    between = options.skipped or explain
    if not explain:
        _check(options.input)
    shown = packets = bytes_skipped = 0
    begin = b""  # before the first packet
    for piece, device in _pieces(bytes_given or b"", KnownDevice(options.device)) if explain else _arriving(options):
        if piece is None:
            sys.stdout.flush()  # so that a reader of a pipe sees each packet at once
        elif piece.packet is None:
            bytes_skipped += len(piece.data)
            begin += piece.data[: MOST - len(begin)] if not packets else b""
            if between and without_checksum(piece.data) is None:
                print(_skipped(piece, options.json))
        else:
            packets += 1
            shown += _show(piece, device, selection, options, as_tree, explain)
            if options.count is not None and shown >= options.count:
                return 0
    if not packets and (packet := without_checksum(begin)) is not None:
        if not _show(
            Piece(0, bytes(packet), packet), KnownDevice(options.device), selection, options, as_tree, explain
        ):
            _none_shown(1)
        print(f"mip dump: without checksum; it would be {show.spaced_bytes(bytes(packet)[-2:])}", file=sys.stderr)
        return 0
    if not packets:
        what = recognized(begin)
        usual = show.damage_text(begin) or ("packets begin with 75 65" if explain else what)
        raise Failure(f"no packet in {count_text(bytes_skipped, 'byte')}: {usual if what is UNKNOWN else what}")
    if not shown:
        _none_shown(packets)
    return 0


def _show(
    piece: Piece, device: KnownDevice, selection: Selection, options: argparse.Namespace, as_tree: bool, explain: bool
) -> bool:
    """Prints a packet. Returns False if it has none of the selected fields."""
    assert piece.packet is not None
    fields, reads = show.selected(piece.packet, selection), device.reads
    if not fields and not selection.everything:
        return False
    if options.json:
        print(objects.packet(piece.offset, piece.packet, fields, reads, options.raw))
    else:
        place = "" if explain else f"{piece.offset:08x} "
        lines = show.tree(piece.packet, fields, reads) if as_tree else [show.line(piece.packet, fields, reads)]
        print(place + "\n".join([*lines, *([f"  {piece.data.hex(' ')}"] if options.raw else [])]))
    return True


def _skipped(piece: Piece, as_json: bool) -> str:
    """Formats the line for bytes outside packets."""
    if as_json:
        return json.dumps({"offset": piece.offset, "skipped": piece.data.hex()})
    return f"{piece.offset:08x} {show.skipped(piece.data)}"


def _none_shown(packets: int) -> None:
    print(f"mip dump: {count_text(packets, 'packet')}, none with these fields", file=sys.stderr)


def _arriving(options: argparse.Namespace) -> Iterator[tuple[Piece | None, KnownDevice]]:
    """Yields what arrives from each input, with what is known of the device there."""
    for name in options.input:
        device = KnownDevice(options.device)
        if inputs.is_port(name):
            arriving = connection.port_pieces(line_of(options, name), begin=device.ask)
        else:
            if inputs.is_log(name) and find_spec("numpy") is not None:
                with inputs.open_columns(name, options.device, empty=True) as log:
                    print_assumptions("dump", log, times=False)  # also of a device that replies later
                    device = log.sender
                    device.news()
            arriving = inputs.arriving(name, progress=not sys.stdout.isatty(), empty=True)
        for piece in arriving:
            if piece is not None and piece.packet is not None:
                device.learn(piece.packet)
            for text in device.news():
                print(f"mip dump: {text}", file=sys.stderr)
            yield piece, device


def _check(arguments: list[str]) -> None:
    """Raises Misuse if these words are hexadecimal bytes with a mistake, and not file names."""
    words = [w for text in arguments for w in re.split(r"[\s,:]+", text) if w]
    bad = [w for w in words if not re.fullmatch(r"(?i)(?:0x)?(?:[0-9a-f]{2})+", w)]
    if bad and len(words) > 2 * len(bad) + 1 and not any(map(inputs.exists, arguments)):
        raise Misuse(f"'{bad[0]}' is not a byte in hexadecimal, which has two digits")
    if len(bad) == len(words) == 1 and re.fullmatch(r"(?i)7565[0-9a-z]+", bad[0]) and not inputs.exists(bad[0]):
        wrong = re.search(r"(?i)[g-z]+", bad[0])
        if wrong:
            raise Misuse(f"'{wrong[0]}' is not hexadecimal")
        raise Misuse("an odd number of hexadecimal digits; each byte needs two")


def _pieces(data: bytes, device: KnownDevice) -> Iterator[tuple[Piece, KnownDevice]]:
    scanner = Scanner()
    yield from ((piece, device) for piece in [*scanner.feed(data), *scanner.flush()])
