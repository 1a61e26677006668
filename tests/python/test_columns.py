"""Columns of logs hold what objects hold: every field, any bytes, however a log is cut."""

from __future__ import annotations

import gzip
import io
import os
import random
import struct
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from itertools import accumulate
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mipgen import codec
from mipgen import model as m
from packages import mip as invented
from packages import real
from strategies import drawn
from support import SPECS, all_fields, model

PACKAGES = {"real": real, "invented": invented}



def packet(number: int, *fields: tuple[int, bytes]) -> bytes:
    payload = b"".join(bytes((len(data) + 2, descriptor)) + data for descriptor, data in fields)
    head = bytes((0x75, 0x65, number, len(payload))) + payload
    return head + bytes((sum(head) & 255, sum(accumulate(head)) & 255))


def parsed(package: Any, stream: bytes) -> list[tuple[int, Any]]:
    """What `Parser` finds, and where."""
    parser, found, at = package.parser.Parser(), [], 0
    for part in (parser.feed(stream), parser.flush()):
        for one in part:
            at = stream.index(bytes(one), at)
            found.append((at, one))
            at += len(one)
    return found


# --------------------------------------------------------------------------- columns and objects


def leaves(package: Any, parameters: Any, value: Any, prefix: str = "") -> Iterator[tuple[str, Any]]:
    """What a column has in a row: by the object, and by the parameters."""
    structure = package.field.Structure
    for p in parameters:
        if p.kind == "counter" or p.constant is not None:
            continue
        held, name = None if value is None else getattr(value, p.attribute), prefix + p.attribute
        if p.kind == "switch":
            tag = None if value is None else getattr(value, p.tag)
            for own, case in p.cases.items():
                if case is not None:
                    chosen = held if own == tag else None
                    yield from leaf(package, structure, case, chosen, f"{name}.{case.attribute}")
        else:
            yield from leaf(package, structure, p, held, name)


def leaf(package: Any, structure: Any, p: Any, held: Any, name: str) -> Iterator[tuple[str, Any]]:
    nested = p.type is not None and issubclass(p.type, structure)
    if not nested:
        yield name, plain(p, held)
    elif p.length is None:
        yield from leaves(package, package.reflection.PARAMETERS[p.type], held, name + ".")
    else:
        parameters = package.reflection.PARAMETERS[p.type]
        names = [key for key, _ in leaves(package, parameters, None, name + ".")]
        rows = None if held is None else [dict(leaves(package, parameters, item, name + ".")) for item in held]
        for key in names:
            yield key, None if rows is None else [row[key] for row in rows]


def plain(p: Any, value: Any) -> Any:
    """A value as bits, numbers and lists."""
    if value is None or isinstance(value, str):
        return value
    if p.scalar == "bits":
        return list(int(value).to_bytes(p.size, "little"))
    if isinstance(value, (tuple, list)):
        return [plain(p, item) for item in value]
    if p.scalar == "float":
        return real.codec.single_to_bits(value)
    return struct.unpack(">Q", struct.pack(">d", value))[0] if p.scalar == "double" else int(value)


def cell(column: Any, row: int) -> Any:
    """The same from a column."""
    if hasattr(column, "offsets"):
        if column.mask is not None and column.mask[row]:
            return None
        return [cell(column.values, i) for i in range(int(column.offsets[row]), int(column.offsets[row + 1]))]
    mask = np.ma.getmaskarray(column)[row] if isinstance(column, np.ma.MaskedArray) else False
    if np.any(mask):
        return None
    value = np.asarray(column)[row]
    if isinstance(value, str):
        return value
    bits = {"f4": "u4", "f8": "u8"}.get(np.asarray(column).dtype.str[1:])
    value = np.asarray(value).view(bits) if bits else np.asarray(value)
    return value.tolist()


def expected(package: Any, stream: bytes) -> dict[Any, list[tuple[int, int, int, Any]]]:
    """Type -> packet number, offset, set and object of each field."""
    found: dict[Any, list[tuple[int, int, int, Any]]] = {}
    for number, (at, one) in enumerate(parsed(package, stream)):
        for value in package.registry.decode_packet(one):
            if isinstance(value, package.field.Field):
                found.setdefault(type(value), []).append((number, at, one.set, value))
    return found


def compare(package: Any, stream: bytes) -> int:
    """All columns of a log against all objects; the number of values."""
    log = package.columns.read_log(stream)
    packets = parsed(package, stream)
    assert log.packets == len(packets)
    assert log.skipped == len(stream) - sum(len(one) for _, one in packets)
    wanted, seen = expected(package, stream), 0
    known = {kind for _, kind in package.registry.all_types()}
    for kind in wanted:
        assert kind in known
    for kind in known:
        rows = wanted.get(kind, [])
        column = log[kind]
        assert len(column) == len(rows), kind
        assert column.packet.tolist() == [row[0] for row in rows]
        assert column.offset.tolist() == [row[1] for row in rows]
        assert column.set.tolist() == [row[2] for row in rows]
        assert list(map(repr, column.objects())) == [repr(value) for *_, value in rows]
        for i, (*_, value) in enumerate(rows):
            held = dict(leaves(package, package.reflection.PARAMETERS[kind], value))
            assert list(held) == list(column.names) == list(column.parameters)
            for name, want in held.items():
                assert cell(column[name], i) == want, (kind, name, i)
                seen += 1
        if not rows:
            empty = list(dict(leaves(package, package.reflection.PARAMETERS[kind], None)))
            assert list(column.names) == empty
    assert {(c.set, c.type): c.count for c in log.types() if c.type} == {
        (s, k): sum(row[2] == s for row in rows) for k, rows in wanted.items() for s in {row[2] for row in rows}
    }
    return seen


@cache
def fields(spec: str, examples: int) -> list[tuple[int, bytes]]:
    """Every field with random values: set and bytes."""
    of, found = model(spec), []
    for f in all_fields(of):
        for values in drawn(f, examples):
            number = f.set if f.set not in (0, m.SHARED_SET) else 0x01 if not f.set else 0x80
            data = codec.encode(f, values)
            if len(data) <= 253:
                found.append((number, bytes((len(data) + 2, f.descriptor)) + data))
    return found


def streams(spec: str, seed: int, count: int) -> bytes:
    """Packets with random fields, many of them damaged, with noise in between."""
    rng, out = random.Random(seed), bytearray()
    every = fields(spec, 4)
    by_set: dict[int, list[bytes]] = {}
    for number, field in every:
        by_set.setdefault(number, []).append(field)
    for _ in range(count):
        number = rng.choice(list(by_set))
        payload = b""
        for _ in range(rng.randrange(5)):
            field = bytearray(rng.choice(by_set[number]))
            if rng.random() < 0.3:
                field[rng.randrange(len(field))] = rng.randrange(256)
            if rng.random() < 0.2:
                field[0] = max(2, min(255, field[0] + rng.randrange(-3, 4)))
                del field[field[0] :]
                field += rng.randbytes(field[0] - len(field))
            if len(payload) + len(field) <= 255:
                payload += field
        if rng.random() < 0.1:
            payload += rng.randbytes(rng.randrange(min(4, 256 - len(payload))))
        head = bytes((0x75, 0x65, number, len(payload))) + payload
        one = bytearray(head + bytes((sum(head) & 255, sum(accumulate(head)) & 255)))
        if rng.random() < 0.1:
            one[rng.randrange(len(one))] ^= 1 << rng.randrange(8)
        if rng.random() < 0.05:
            del one[rng.randrange(len(one)) :]
        out += one
        if rng.random() < 0.1:
            out += rng.choice([b"u", b"ue", b"ue\x80\xff", b"$GPGGA,1*00\r\n", rng.randbytes(9), packet(0, (1, b""))])
    return bytes(out)


@pytest.mark.parametrize("many", [1, 64])
@pytest.mark.parametrize("spec", sorted(SPECS))
def test_columns_equal_objects_on_damaged_streams(spec: str, many: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Value by value, bit by bit; `many` is 1 to take the way of frequent layouts for all packets."""
    package = PACKAGES[spec]
    monkeypatch.setattr(package.columns.walk, "_MANY", many)
    monkeypatch.setattr(package.columns.scan, "_MANY", many)
    assert compare(package, streams(spec, seed=many, count=700)) > 1000


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_columns_equal_objects_for_every_field(spec: str) -> None:
    package = PACKAGES[spec]
    stream = b"".join(packet(number, (field[1], field[2:])) for number, field in fields(spec, 8))
    assert compare(package, stream) > 1000
