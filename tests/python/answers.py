"""What Python makes of streams, in the form that tests/c/fuzz/answers.c defines; with the package on PYTHONPATH."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from functools import cache

from mip_protocol import DecodeError, Packet, PacketError, Parser, RawField, registry
from mip_protocol.field import Field, chosen


@cache
def name_in(set: int, kind: type[Field]) -> str:
    return kind.name_in(set)


def shown(raw: RawField) -> str:
    kind = chosen(registry.types(raw.set, raw.descriptor), raw)
    if kind is None:
        return str(raw.descriptor)
    name = name_in(raw.set, kind)
    try:
        value, trailing = kind.decode_with_trailing(raw.data)
    except DecodeError as error:
        return f"{name}!{error.kind}"
    return f"{name}={value.encode().hex()}+{trailing}"


def found(packet: Packet) -> Iterator[str]:
    yield bytes(packet).hex()
    try:
        for raw in packet:
            yield shown(raw)
    except PacketError:
        yield "!"


def answer(line: str) -> str:
    piece, _, text = line.partition(" ")
    stream, parser, parts = bytes.fromhex(text), Parser(), list[str]()
    size = int(piece) or len(stream) or 1
    for at in range(0, len(stream), size):
        for packet in parser.feed(stream[at : at + size]):
            parts += found(packet)
    for packet in parser.flush():
        parts += found(packet)
    return " ".join([*parts, str(parser.skipped)])


if __name__ == "__main__":
    sys.stdout.writelines(f"{answer(line)}\n" for line in sys.stdin)
