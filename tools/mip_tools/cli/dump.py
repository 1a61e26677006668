"""`mip dump`: packets with names, values and units."""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Iterator
from importlib.util import find_spec

from ..errors import Failure, Misuse
from . import inputs, objects, ports, show, silence
from .arguments import add_device, add_selection, device_id, positive
from .scan import Piece, Scanner
from .selection import Selection

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
    silence.add_arguments(parser)
    ports.add_arguments(parser)


def run(options: argparse.Namespace) -> int:
    selection = Selection(options.only, options.without)
    device = device_id(options.device)
    given = inputs.hex_bytes(options.input)
    explain = given is not None and not inputs.exists(options.input[0])
    as_tree = options.tree or (explain and not options.line and not options.json)
    between = options.skipped or explain
    if not explain:
        _check(options.input)
    if _by_columns(options, explain) and (done := _fast(options, selection, device)) is not None:
        return done
    shown = packets = bytes_skipped = 0
    damage = ""
    for piece in _given(given or b"") if explain else _arriving(options):
        if piece is None:
            sys.stdout.flush()  # so that a reader of a pipe sees each packet at once
            continue
        if piece.packet is None:
            bytes_skipped += len(piece.data)
            damage = damage or show.damage(piece.data)
            if between:
                print(_skipped(piece, options.json))
            continue
        packets += 1
        fields = show.selected(piece.packet, selection)
        if not fields and not selection.everything:
            continue
        if options.json:
            print(objects.packet(piece.offset, piece.packet, fields, device, options.raw))
        else:
            place = "" if explain else f"{piece.offset:08x} "
            lines = show.tree(piece.packet, fields, device) if as_tree else [show.line(piece.packet, fields, device)]
            print(place + "\n".join([*lines, *([f"  {piece.data.hex(' ')}"] if options.raw else [])]))
        shown += 1
        if options.count is not None and shown >= options.count:
            return 0
    if not packets:
        count = inputs.counted(bytes_skipped, "byte")
        raise Failure(f"no packet in {count}: {damage or 'packets begin with 75 65'}")
    if not shown:
        _none_shown(packets)
    return 0


def _skipped(piece: Piece, as_json: bool) -> str:
    """Formats the line for bytes outside packets."""
    if as_json:
        return json.dumps({"offset": piece.offset, "skipped": piece.data.hex()})
    return f"{piece.offset:08x} {show.skipped(piece.data)}"


def _none_shown(packets: int) -> None:
    print(f"mip dump: {inputs.counted(packets, 'packet')}, none with these fields", file=sys.stderr)


def _by_columns(options: argparse.Namespace, explain: bool) -> bool:
    """Can the faster way by columns be used: lines or objects of whole files, with NumPy installed?"""
    if explain or options.tree or options.raw or options.skipped or options.count is not None:
        return False
    if not all(not inputs.is_port(name) and inputs.is_log(name) for name in options.input):
        return False
    return find_spec("numpy") is not None


def _fast(options: argparse.Namespace, selection: Selection, device: str | None) -> int | None:
    """Shows whole files. Returns None if they have no packet, so that the slower way reports the cause."""
    from .lines import Lines, Objects, lines

    packets, shown, form = 0, 0, Objects(device) if options.json else Lines(device)
    for name in options.input:
        with inputs.columns(name) as log:
            for count, texts in lines(log, selection, form):
                packets += count
                shown += len(texts)
                if texts:
                    print("\n".join(texts))
    if packets and not shown:
        _none_shown(packets)
    return 0 if packets else None


def _arriving(options: argparse.Namespace) -> Iterator[Piece | None]:
    for name in options.input:
        if inputs.is_port(name):
            yield from ports.pieces(name, options)
        else:
            yield from inputs.arriving(name, progress=not sys.stdout.isatty())


def _check(given: list[str]) -> None:
    """Raises Misuse if these words are hexadecimal bytes with a mistake, and not file names."""
    words = [w for text in given for w in re.split(r"[\s,:]+", text) if w]
    bad = [w for w in words if not re.fullmatch(r"(?i)(?:0x)?(?:[0-9a-f]{2})+", w)]
    if bad and len(words) > 2 * len(bad) + 1 and not any(map(inputs.exists, given)):
        raise Misuse(f"'{bad[0]}' is not a byte in hexadecimal, which has two digits")
    if len(bad) == len(words) == 1 and re.fullmatch(r"(?i)7565[0-9a-f]+", bad[0]):
        raise Misuse("an odd number of hexadecimal digits; each byte needs two")


def _given(data: bytes) -> Iterator[Piece]:
    scanner = Scanner()
    yield from scanner.feed(data)
    yield from scanner.flush()
