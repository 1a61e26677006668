"""Encodes and decodes packets by interpreting the model's parameters.

Slow and simple: the reference for examples and generated code. Values have the form of the
conformance protocol: numbers, lists, objects, and floats as the hexadecimal digits of their bits.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from mipgen import model as m
from mipgen.read.problems import nearest

from . import extent

Values = dict[str, Any]


class CodecError(Exception):
    """`kind` is the word that the conformance protocol uses."""

    def __init__(self, kind: str, message: str) -> None:
        super().__init__(message)
        self.kind = kind


# --------------------------------------------------------------------------- packets


def checksum(data: bytes) -> bytes:
    """
    >>> checksum(bytes.fromhex("756501020201")).hex()
    'e0c6'
    """
    a = b = 0
    for byte in data:
        a = (a + byte) & 0xFF
        b = (b + a) & 0xFF
    return bytes((a, b))


def build(model: m.Model, set_number: int, fields: list[tuple[int, bytes]]) -> bytes:
    if any(len(data) > m.MAX_FIELD_DATA for _, data in fields):
        raise CodecError("length", f"a field contains at most {m.MAX_FIELD_DATA} bytes of data")
    payload = b"".join(bytes((len(data) + 2, descriptor)) + data for descriptor, data in fields)
    if len(payload) > model.protocol.max_payload:
        raise CodecError("length", "the payload does not fit in a packet")
    head = bytes((*model.protocol.sync, set_number, len(payload))) + payload
    return head + checksum(head)


def split(model: m.Model, packet: bytes) -> list[tuple[int, bytes]]:
    """Splits a packet into its fields: (descriptor, data). Raises CodecError unless it is exactly one packet."""
    if packet[:2] != bytes(model.protocol.sync):
        begin, sync = (x.hex().upper() for x in (packet[:2], bytes(model.protocol.sync)))
        raise CodecError("sync", f"it begins with {begin}, not {sync}")
    if len(packet) < 6 or len(packet) != packet[3] + 6 or packet[2] in m.NO_SETS:
        raise CodecError("length", f"its {len(packet)} bytes are not a whole packet")
    if checksum(packet[:-2]) != packet[-2:]:
        printed, correct = (x.hex().upper() for x in (packet[-2:], checksum(packet[:-2])))
        raise CodecError("checksum", f"its checksum is {printed}, but should be {correct}")
    payload, fields = packet[4:-2], []
    while payload:
        length = payload[0]
        if length < 2 or length > len(payload):
            raise CodecError("field_length", f"a field of length {length} in {len(payload)} bytes")
        fields.append((payload[1], payload[2:length]))
        payload = payload[length:]
    return fields


def choose(candidates: tuple[m.Field, ...], data: bytes) -> m.Field | None:
    """Chooses the layout of a descriptor's data.

    The constants must match, as far as the data reaches. Of several matching layouts, it is the one of the same size,
    else the longest that fits into the data, else the shortest, of which the data is only a part.
    """
    if len(candidates) <= 1:
        return candidates[0] if candidates else None
    fitting = [
        f for f in candidates if all(constant.startswith(data[at : at + len(constant)]) for at, constant in f.signature)
    ]
    short_enough = [f for f in fitting if f.min_size <= len(data)]
    if short_enough:
        return max(short_enough, key=lambda f: f.min_size)
    return min(fitting, key=lambda f: f.min_size, default=None)


# --------------------------------------------------------------------------- decoding


@dataclass
class _Reader:
    data: bytes
    at: int = 0

    def take(self, size: int) -> bytes:
        if size > len(self.data) - self.at:
            short = size - (len(self.data) - self.at)
            raise CodecError("truncated", f"the data is {short} byte{'s' if short > 1 else ''} short")
        self.at += size
        return self.data[self.at - size : self.at]


def decode(f: m.Field, data: bytes) -> tuple[Values, int]:
    """Decodes a field. Returns its values, and the number of bytes left over."""
    reader, values = _Reader(data), Values()
    for p in f.always:
        _read(p, reader, values)
    required = f.required(values.get("function"))
    for group in f.groups:
        if not _read_group(group, required, reader, values):
            break
    return values, len(data) - reader.at


def _read_group(group: m.Group, required: int, reader: _Reader, values: Values) -> bool:
    if group.last > required and reader.at == len(reader.data):
        return False
    mark, more = reader.at, dict(values)
    try:
        for p in group.parameters:
            _read(p, reader, more)
    except CodecError as error:
        if group.last <= required or error.kind != "truncated":
            raise
        reader.at = mark
        return False
    if group.last > required and reader.at == mark:  # an empty union: same as absent
        return False
    values.update(more)
    return True


def _read(p: m.Parameter, reader: _Reader, values: Values) -> None:
    if p.constant is not None:
        number = int.from_bytes(reader.take(p.size), "big")
        if number != p.constant:
            raise CodecError("constant", f"{p.name} is {number}, not {p.constant}")
    else:
        values[p.name] = _value(p, reader, values)


def _value(p: m.Parameter, reader: _Reader, values: Values) -> Any:
    """Reads a value; `values` are the earlier values of its record."""
    if p.struct:
        return _record(p.struct.parameters, reader)
    if p.union:
        return _record(_chosen(p.union, values), reader)
    if p.kind == "bits":
        return list(reader.take(p.size))
    if p.kind == "text":
        return reader.take(_count(p, reader, values)).decode("latin-1")
    if p.kind == "array":
        return [_value(p.item, reader, {}) for _ in range(_count(p, reader, values))]
    return _number(p.scalar, reader.take(p.size))


def _record(parameters: Iterable[m.Parameter], reader: _Reader) -> Values:
    values = Values()
    for p in parameters:
        _read(p, reader, values)
    return values


def _chosen(union: m.Union, values: Values) -> tuple[m.Parameter, ...]:
    """Returns the content of the alternative that the tag selects: one parameter or none."""
    return tuple(c.parameter for c in union.cases if c.parameter and c.tag.value == values[union.tag])


def _count(p: m.Parameter, reader: _Reader, values: Values) -> int:
    size, left = extent.item_size(p), len(reader.data) - reader.at
    if p.count is not None:
        return p.count
    if p.counter is None:
        return min(left // size, p.capacity)
    count: int = values[p.counter]
    if count * size > left:
        raise CodecError("count", f"{p.counter} is {count}, but {left} bytes follow")
    if count > p.capacity:
        raise CodecError("count", f"{p.counter} is {count}, but a field contains at most {p.capacity}")
    return count


def _number(scalar: m.Scalar, raw: bytes) -> int | str:
    if scalar.kind == "float":
        return "0x" + raw.hex()
    return int.from_bytes(raw, "big", signed=scalar.kind == "signed")


# --------------------------------------------------------------------------- encoding


def encode(f: m.Field, values: Values) -> bytes:
    """Encodes a field in the shortest form that contains the given values."""
    out = bytearray()
    names = {p.name for p in f.parameters if p.constant is None}
    for name in values:
        if name not in names:
            raise CodecError("unknown", f"{f.full_name} has no parameter {name}")
    for p in f.always:
        _write(p, values, out)
    required = f.required(values.get("function"))
    ended: str | None = None
    for group in f.groups:
        absent = [p.name for p in group.parameters if p.constant is None and p.name not in values]
        if absent and group.last <= required:
            raise CodecError("missing", f"{absent[0]} is missing")
        if absent:
            ended = ended or absent[0]
        if ended is None:
            for p in group.parameters:
                _write(p, values, out)
        elif any(p.name in values for p in group.parameters):
            raise CodecError("missing", f"{ended} is missing")
    if len(out) > m.MAX_FIELD_DATA:
        raise CodecError("length", f"{len(out)} bytes do not fit in a field")
    return bytes(out)


def _write(p: m.Parameter, values: Values, out: bytearray) -> None:
    if p.constant is not None:
        out += p.octets
    elif p.name in values:
        _put(p, values[p.name], values, out)
    else:
        raise CodecError("missing", f"{p.name} is missing")


def _put(p: m.Parameter, value: Any, values: Values, out: bytearray) -> None:
    if p.struct:
        names = {q.name for q in p.struct.parameters if q.constant is None}
        for name in value:
            if name not in names:
                raise CodecError("unknown", f"{p.struct.name} has no parameter {name}")
        for q in p.struct.parameters:
            _write(q, value, out)
    elif p.union:
        chosen = _chosen(p.union, values)
        if list(value) != [q.name for q in chosen]:
            raise CodecError("tag", f"{p.tag} is {values[p.union.tag]}, but {p.name} contains {list(value)}")
        for q in chosen:
            _write(q, value, out)
    elif p.kind == "array":
        _check_count(p, value)
        for item in value:
            _put(p.item, item, {}, out)
    else:
        out += _octets(p, value, values)


def _octets(p: m.Parameter, value: Any, values: Values) -> bytes:
    """Encodes a number, a text, or a bitfield in bytes."""
    if p.kind == "bits":
        if not isinstance(value, list) or len(value) != p.size:
            raise CodecError("count", f"{p.name} needs {p.size} bytes")
        return b"".join(_bytes(p.scalar, byte) for byte in value)
    if p.kind == "text":
        value = value.ljust(p.count or 0) if isinstance(value, str) else value  # as devices pad texts
        _check_count(p, value)
        try:
            octets: bytes = value.encode("latin-1")
        except UnicodeEncodeError as error:
            raise CodecError("range", f"{p.name} is out of range") from error
        return octets
    if p.counts is not None:
        items = values.get(p.counts)
        if not isinstance(items, (list, str)) or len(items) != value:
            raise CodecError("count", f"{p.name} is {value}")
    return _bytes(p.scalar, value)


def encode_value(p: m.Parameter, value: Any) -> bytes:
    """Encodes one value, independently of the other values of its record."""
    out = bytearray()
    _put(p, value, {}, out)
    return bytes(out)


def counters(parameters: Iterable[m.Parameter], values: Values) -> Values:
    """Computes the counters of the arrays among the values."""
    return {p.name: len(values[p.counts]) for p in parameters if p.counts and p.counts in values}


def _check_count(p: m.Parameter, value: Any) -> None:
    if (p.count is not None and len(value) != p.count) or len(value) > p.capacity:
        raise CodecError("count", f"{p.name} has {len(value)} elements")


def _bytes(scalar: m.Scalar, value: Any) -> bytes:
    if scalar.kind == "float":
        raw = bytes.fromhex(value[2:]) if isinstance(value, str) else b""
        if len(raw) != scalar.size:
            raise CodecError("range", f"{value!r} is not a {scalar.name}")
        return raw
    try:
        return int(value).to_bytes(scalar.size, "big", signed=scalar.kind == "signed")
    except OverflowError as error:
        raise CodecError("range", f"{value} does not fit in {scalar.name}") from error


# --------------------------------------------------------------------------- values written by people


def canonical(p: m.Parameter, value: Any, where: str) -> Any:
    """Converts a value as an example states it to the form above. Raises ValueError with a remedy."""
    if p.struct:
        return canonical_record(p.struct.parameters, value, where)
    if p.union:
        return canonical_record(p.alternatives, value, where)
    if p.kind == "bits":
        return _canonical_bytes(p, value, where)
    if p.kind == "text":
        if not isinstance(value, str):
            raise ValueError(f"{where} must be text, in quotes")
        if any(c > "\xff" for c in value):
            raise ValueError(f"{where} must be text of Latin-1 characters")
        return value.ljust(p.count or 0)
    if p.kind == "array":
        if not isinstance(value, list):
            raise ValueError(f"{where} must be a list")
        return [canonical(p.item, v, f"{where}[{i}]") for i, v in enumerate(value)]
    return _canonical_real(p.scalar, value, where) if p.scalar.kind == "float" else _canonical_number(p, value, where)


def canonical_record(parameters: Iterable[m.Parameter], values: Any, where: str) -> Values:
    if not isinstance(values, dict):
        raise ValueError(f"{where} must be a mapping of parameter names to values")
    by_name = {p.name: p for p in parameters}
    for name in values:
        if name not in by_name:
            raise ValueError(f"{where} has no parameter '{name}'{nearest(name, by_name)}")
    return {name: canonical(by_name[name], v, f"{where}.{name}") for name, v in values.items()}


def _canonical_bytes(p: m.Parameter, value: Any, where: str) -> list[int]:
    try:
        octets = list(bytes.fromhex(value) if isinstance(value, str) else bytes(list(value)))
    except (TypeError, ValueError):
        octets = []
    if len(octets) != p.size:
        raise ValueError(f"{where} must be {p.size} bytes: a list of numbers, or hexadecimal digits in quotes")
    return octets


def _canonical_real(scalar: m.Scalar, value: Any, where: str) -> str:
    if isinstance(value, str) and re.fullmatch(f"0x[0-9A-Fa-f]{{{2 * scalar.size}}}", value):
        return value.lower()
    if isinstance(value, (str, bool)) or value is None:
        raise ValueError(
            f"{where}: {value!r} is neither a number nor the {2 * scalar.size} hexadecimal digits of its bits"
        )
    try:
        return "0x" + struct.pack(">f" if scalar.size == 4 else ">d", value).hex()
    except (OverflowError, struct.error) as error:
        raise ValueError(f"{where}: {value!r} does not fit in a {scalar.name}") from error


def _canonical_number(p: m.Parameter, value: Any, where: str) -> int:
    named = p.named
    if isinstance(value, str) and isinstance(named, m.Enum):
        entry = named.by_name(value)
        if entry is None:
            near = nearest(value, [v.name for v in named.values])
            raise ValueError(f"{where}: '{named.name}' has no value '{value}'{near}")
        return entry.value
    if isinstance(value, list) and isinstance(named, m.Bitfield):
        bits = {b.name: b for b in named.bits}
        unknown = [n for n in value if not isinstance(n, str) or n not in bits]
        if unknown:
            near = nearest(str(unknown[0]), bits)
            raise ValueError(f"{where}: '{named.name}' has no bit '{unknown[0]}'{near}")
        mask = 0
        for n in value:
            mask |= bits[n].mask
        return mask
    if isinstance(value, (bool, int)):
        return int(value)
    raise ValueError(f"{where}: {value!r} is not a whole number")


def in_numbers(value: object, element: m.Scalar | m.Enum | m.Bitfield | m.Vector | m.Struct | None) -> object:
    """Converts a checked default: names of values and bits become numbers, lists become tuples."""
    if isinstance(element, m.Enum) and isinstance(value, str):
        member = element.by_name(value)
        return member.value if member else 0
    if isinstance(element, m.Bitfield) and isinstance(value, list) and all(isinstance(x, str) for x in value):
        return sum({b.name: b.mask for b in element.bits}.get(str(x), 0) for x in value)
    return tuple(in_numbers(x, element) for x in value) if isinstance(value, list) else value
