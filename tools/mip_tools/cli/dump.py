"""`mip dump`: packets with names, values and units."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator

from ..errors import Failure, Misuse
from . import inputs, ports, show
from .arguments import add_device, add_selection, device_id, positive
from .scan import Piece, Scanner
from .selection import Selection

EPILOG = """\
examples:
  mip dump 75 65 01 02 02 01 E0 C6       one packet explained
  mip dump log.bin | head                a line for each packet
  mip dump log.bin --only sensor.scaled_accel --tree
  mip dump /dev/ttyACM0 --skipped        live, with what comes between packets
  cat log.bin | mip dump -
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
    add("--raw", action="store_true", help="add each packet in hexadecimal")
    add("--skipped", action="store_true", help="also show bytes outside packets")
    add("--count", type=positive, metavar="N", help="end after N packets")
    add_device(parser)
    ports.add_arguments(parser)


def run(options: argparse.Namespace) -> int:
    selection = Selection(options.only, options.without)
    device = device_id(options.device)
    given = inputs.hex_bytes(options.input)
    explain = given is not None and not inputs.exists(options.input[0])
    as_tree = options.tree or (explain and not options.line)
    between = options.skipped or explain
    if not explain:
        _check(options.input)
    shown = packets = bytes_skipped = 0
    damage = ""
    for name in options.input if not explain else [""]:
        live = not explain and inputs.is_port(name)
        source = (
            _given(given or b"")
            if explain
            else ports.pieces(name, options)
            if live
            else inputs.pieces(name, progress=not sys.stdout.isatty())
        )
        for piece in source:
            if piece.packet is None:
                bytes_skipped += len(piece.data)
                damage = damage or show.damage(piece.data)
                if between:
                    print(f"{piece.offset:08x} {show.skipped(piece.data)}", flush=live)
                continue
            packets += 1
            fields = show.selected(piece.packet, selection)
            if not fields and not selection.everything:
                continue
            where = "" if explain else f"{piece.offset:08x} "
            if as_tree:
                text = "\n".join(show.tree(piece.packet, fields, device))
            else:
                text = show.line(piece.packet, fields, device)
            raw = f"\n  {piece.data.hex(' ')}" if options.raw else ""
            print(f"{where}{text}{raw}", flush=live)
            shown += 1
            if options.count is not None and shown >= options.count:
                return 0
    if not packets:
        count = inputs.counted(bytes_skipped, "byte")
        raise Failure(f"no packet in {count}: {damage or 'packets begin with 75 65'}")
    if not shown:
        print(f"mip dump: {inputs.counted(packets, 'packet')}, none with these fields", file=sys.stderr)
    return 0


def _check(given: list[str]) -> None:
    """Raises Misuse if these are bytes in hexadecimal with a mistake, and not names of files."""
    words = [w for text in given for w in re.split(r"[\s,:]+", text) if w]
    bad = [w for w in words if not re.fullmatch(r"(?i)(?:0x)?(?:[0-9a-f]{2})+", w)]
    if bad and len(words) > 2 * len(bad) + 1 and not any(map(inputs.exists, given)):
        raise Misuse(f"'{bad[0]}' is not a byte in hexadecimal, which has two digits")
    if len(bad) == len(words) == 1 and re.fullmatch(r"(?i)7565[0-9a-f]+", bad[0]):
        raise Misuse("an odd number of hexadecimal digits; two make a byte")


def _given(data: bytes) -> Iterator[Piece]:
    scanner = Scanner()
    yield from scanner.feed(data)
    yield from scanner.flush()
