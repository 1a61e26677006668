"""The inputs with which fuzz targets begin, made from the specification: its examples and each field.

An input is bytes in the form that the head of its target (parser.c, fields.c) describes.
"""

from __future__ import annotations

from collections.abc import Iterator

from conformance import scenarios
from mipgen import model as m
from support import all_fields, set_of


def seeds(target: str, of: m.Model) -> list[bytes]:
    return list({"parser": parser, "fields": fields}[target](of))


def variants(f: m.Field) -> Iterator[bytes]:
    """Data of a field: zeros and other numbers, for each function selector, whole and cut; counts and tags are
    small."""
    for function in [x.value for x in f.functions] or [None]:
        for data in (bytearray(f.max_size), bytearray(i % 7 + 1 for i in range(f.max_size))):
            if function is not None:
                data[0] = function
            for at, constant in f.signature:
                data[at : at + len(constant)] = constant
            yield from (bytes(data[:size]) for size in {*range(min(12, f.min_size)), f.min_size, f.max_size})


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
