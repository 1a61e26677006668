"""The inputs with which fuzz targets begin, made from the specification: its examples, each field, each command.

An input is bytes in the form that the head of its target (parser.c, fields.c, client.c) describes.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from conformance import scenarios
from mipgen import model as m
from mipgen.lower import codec
from support import all_fields, set_of

KINDS = 7
SEND, ANSWER, PACKET, BYTES, TIME = range(5)


def seeds(target: str, of: m.Model) -> list[bytes]:
    return list({"parser": parser, "fields": fields, "client": client}[target](of))


def variants(f: m.Field) -> Iterator[bytes]:
    """Data of a field: zeros and other numbers, for each function selector; counts and tags are small."""
    for function in [x.value for x in f.functions] or [None]:
        for data in (bytearray(f.max_size), bytearray(i % 7 + 1 for i in range(f.max_size))):
            if function is not None:
                data[0] = function
            for at, constant in f.signature:
                data[at : at + len(constant)] = constant
            yield bytes(data)
            yield bytes(data[: f.min_size])


def parser(of: m.Model) -> Iterator[bytes]:
    packets = [e.packet for e in of.examples]
    noise = scenarios.NMEA + scenarios.LONG
    for i, packet in enumerate(packets):
        piece = bytes((i % 256, i * 7 % 256))
        yield piece + packet
        yield piece + noise + packet + packets[i - 1][:-1] + packet


def fields(of: m.Model) -> Iterator[bytes]:
    for f in all_fields(of):
        for i, data in enumerate(variants(f)):
            yield bytes((0, set_of(f, of), f.descriptor, i)) + data
    for e in of.examples:
        yield bytes((0x80, e.set, 0, 0)) + e.packet[4:-2]


def sent(f: m.Field, number: int, data: bytes, choice: int = 0, slot: int = 0) -> bytes:
    return bytes((SEND, slot, number, f.descriptor, choice, len(data))) + data


def client(of: m.Model) -> Iterator[bytes]:
    for f in of.fields:
        if f.role != m.COMMAND:
            continue
        links = of.responses(f)
        for data in variants(f):
            for choice, response in enumerate(links) if links else [(255, None)]:
                answer = next(variants(response)) if response else b""
                end = bytes((ANSWER, 0, 0, choice, min(len(answer), 247))) + answer[:247]
                yield sent(f, f.set, data, choice) + end
                yield sent(f, f.set, data, choice | 128) + end
    for _, steps, _ in scenarios.scenarios(of):
        yield b"".join(step(s, of) for s in steps)


def encoded(f: m.Field, values: dict[str, Any]) -> bytes:
    try:
        return codec.encode(f, values)
    except codec.CodecError:  # some scenarios send what cannot be encoded
        return b""


def step(s: dict[str, Any], of: m.Model) -> bytes:
    """A step of a conformance request."""
    if s["step"] == "send":
        parts = []
        for slot, entry in enumerate(s["fields"]):
            known = of.candidates(s["set"], entry["descriptor"])
            f = next((k for k in known if k.full_name == entry["name"]), None)
            if f is not None:
                parts.append(sent(f, s["set"], encoded(f, entry["values"]), slot=slot % 4))
        return b"".join(parts)
    if s["step"] == "receive":
        data, piece = bytes.fromhex(s["bytes"]), s.get("chunk", 0) % 36
        cut = [data[at : at + 255] for at in range(0, len(data), 255)]
        return b"".join(bytes((BYTES + KINDS * piece, len(part))) + part for part in cut)
    if s["step"] == "time":
        return bytes((TIME,)) + min(s["milliseconds"], 0xFFFF).to_bytes(2, "big")
    return b""
