"""Encodes and decodes packets by interpreting the model's operations.

Slow and simple: the reference for examples and generated code. Values have the form of the
conformance protocol: numbers, lists, objects, floats as the hexadecimal of their bits.
"""

from __future__ import annotations

import re
import struct
from dataclasses import dataclass
from typing import Any

from mipgen import model as m
from mipgen.read.problems import nearest

from . import extent

Values = dict[str, Any]

_FORMATS = {"u8": "B", "u16": "H", "u32": "I", "u64": "Q", "s8": "b", "s16": "h", "s32": "i", "s64": "q"}


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
        raise CodecError("length", f"a field holds at most {m.MAX_FIELD_DATA} bytes of data")
    payload = b"".join(bytes((len(data) + 2, descriptor)) + data for descriptor, data in fields)
    if len(payload) > model.protocol.max_payload:
        raise CodecError("length", "the payload is longer than a packet holds")
    head = bytes((*model.protocol.sync, set_number, len(payload))) + payload
    return head + checksum(head)


def split(model: m.Model, packet: bytes) -> list[tuple[int, bytes]]:
    """The fields of a packet: (descriptor, data). Raises on anything that is not one whole packet."""
    if packet[:2] != bytes(model.protocol.sync):
        begin, sync = (x.hex().upper() for x in (packet[:2], bytes(model.protocol.sync)))
        raise CodecError("sync", f"it begins with {begin}, not {sync}")
    if len(packet) < 6 or len(packet) != packet[3] + 6 or packet[2] in m.NO_SETS:
        raise CodecError("length", f"its {len(packet)} bytes are not a whole packet")
    if checksum(packet[:-2]) != packet[-2:]:
        printed, right = (x.hex().upper() for x in (packet[-2:], checksum(packet[:-2])))
        raise CodecError("checksum", f"its checksum is {printed}, but should be {right}")
    payload, fields = packet[4:-2], []
    while payload:
        length = payload[0]
        if length < 2 or length > len(payload):
            raise CodecError("field_length", f"a field of length {length} in {len(payload)} bytes")
        fields.append((payload[1], payload[2:length]))
        payload = payload[length:]
    return fields


def choose(candidates: tuple[m.Field, ...], data: bytes) -> m.Field | None:
    """The layout that data of a descriptor have.

    Constants tell it, as far as the data reach. Where several remain, it is the one of this size, else the longest
    that the data hold, else the shortest, of which they are a part only.
    """
    if len(candidates) <= 1:
        return candidates[0] if candidates else None
    fitting = [
        f
        for f in candidates
        if all(op.value.to_bytes(op.size, "big").startswith(data[at : at + op.size]) for at, op in f.constants)
    ]
    held = [f for f in fitting if f.min_size <= len(data)]
    if held:
        return max(held, key=lambda f: f.min_size)
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
    """The values of a field, and how many bytes are left over."""
    reader, values = _Reader(data), Values()
    required = f.required()
    for op in f.operations:
        if isinstance(op, m.GroupOp):
            if op.first == 1 and f.selector:
                required = f.required(values["function"])
            if not _read_group(op, required, reader, values):
                break
        else:
            _read(op, reader, values)
    return values, len(data) - reader.at


def _read_group(op: m.GroupOp, required: int, reader: _Reader, values: Values) -> bool:
    if op.last > required and reader.at == len(reader.data):
        return False
    mark, found = reader.at, dict(values)
    try:
        for inner in op.body:
            _read(inner, reader, found)
    except CodecError as error:
        if op.last <= required or error.kind != "truncated":
            raise
        reader.at = mark
        return False
    if op.last > required and reader.at == mark:  # an empty union: same as absent
        return False
    values.update(found)
    return True


def _read(op: m.Operation, reader: _Reader, values: Values) -> None:
    match op:
        case m.ConstantOp():
            found = int.from_bytes(reader.take(op.size), "big")
            if found != op.value:
                raise CodecError("constant", f"{op.member} is {found}, not {op.value}")
        case m.SwitchOp():
            case_ = next((c for c in op.cases if c.tag.value == values[op.tag]), None)
            inner = Values()
            if case_ is not None and case_.operation is not None:
                _read(case_.operation, reader, inner)
            values[op.member] = inner
        case m.GroupOp():
            raise AssertionError("groups are in fields only")
        case _:
            values[op.member] = _item(op, reader, values)


def _item(op: m.Operation, reader: _Reader, values: Values) -> Any:
    match op:
        case m.ScalarOp() | m.CounterOp():
            return _number(op.scalar, reader.take(op.size))
        case m.BitsOp():
            return list(reader.take(op.size))
        case m.TextOp():
            return reader.take(_count(op, extent.element(op), reader, values)).decode("latin-1")
        case m.ArrayOp():
            count = _count(op, extent.element(op), reader, values)
            return [_item(op.item, reader, {}) for _ in range(count)]
        case m.StructOp():
            inner = Values()
            for part in op.struct.operations:
                _read(part, reader, inner)
            return inner
    raise AssertionError(op)


def _count(op: m.TextOp | m.ArrayOp, size: int, reader: _Reader, values: Values) -> int:
    left = len(reader.data) - reader.at
    if op.count is not None:
        return op.count
    if op.counter is None:
        return min(left // size, op.capacity)
    count: int = values[op.counter]
    if count * size > left:
        raise CodecError("count", f"{op.counter} is {count}, but {left} bytes follow")
    if count > op.capacity:
        raise CodecError("count", f"{op.counter} is {count}, but a field holds {op.capacity}")
    return count


def _number(scalar: m.Scalar, raw: bytes) -> int | str:
    if scalar.kind == "float":
        return "0x" + raw.hex()
    return int.from_bytes(raw, "big", signed=scalar.kind == "signed")


# --------------------------------------------------------------------------- encoding


def encode(f: m.Field, values: Values) -> bytes:
    """The shortest form that holds the given values."""
    out = bytearray()
    required = f.required()
    known = {p.name for p in f.parameters if p.constant is None}
    for name in values:
        if name not in known:
            raise CodecError("unknown", f"{f.full_name} has no parameter {name}")
    ended: str | None = None
    for op in f.operations:
        if isinstance(op, m.GroupOp):
            if op.first == 1 and f.selector:
                required = f.required(values["function"])
            absent = [i.member for i in op.body if not isinstance(i, m.ConstantOp) and i.member not in values]
            if absent and op.last <= required:
                raise CodecError("missing", f"{absent[0]} is missing")
            if absent:
                ended = ended or absent[0]
            if ended is not None:
                if any(not isinstance(i, m.GroupOp) and i.member in values for i in op.body):
                    raise CodecError("missing", f"{ended} is missing")
                continue
            for inner in op.body:
                _write(inner, values, out)
        else:
            _write(op, values, out)
    if len(out) > m.MAX_FIELD_DATA:
        raise CodecError("length", f"{len(out)} bytes do not fit in a field")
    return bytes(out)


def _write(op: m.Operation, values: Values, out: bytearray) -> None:
    match op:
        case m.ConstantOp():
            out += op.value.to_bytes(op.size, "big")
        case m.GroupOp():
            raise AssertionError("groups are in fields only")
        case _:
            if op.member not in values:
                raise CodecError("missing", f"{op.member} is missing")
            _put(op, values[op.member], values, out)


def _put(op: m.Operation, value: Any, values: Values, out: bytearray) -> None:
    match op:
        case m.ScalarOp():
            out += _bytes(op.scalar, value)
        case m.CounterOp():
            items = values.get(op.array)
            if not isinstance(items, (list, str)) or len(items) != value:
                raise CodecError("count", f"{op.member} is {value}")
            out += _bytes(op.scalar, value)
        case m.BitsOp():
            if not isinstance(value, list) or len(value) != op.size:
                raise CodecError("count", f"{op.member} needs {op.size} bytes")
            for byte in value:
                out += _bytes(m.SCALARS["u8"], byte)
        case m.TextOp():
            _check_count(op, value)
            try:
                out += value.encode("latin-1")
            except UnicodeEncodeError as error:
                raise CodecError("range", f"{op.member} is out of range") from error
        case m.ArrayOp():
            _check_count(op, value)
            for item in value:
                _put(op.item, item, {}, out)
        case m.StructOp():
            known = {p.name for p in op.struct.parameters if p.constant is None}
            for name in value:
                if name not in known:
                    raise CodecError("unknown", f"{op.struct.name} has no parameter {name}")
            for part in op.struct.operations:
                _write(part, value, out)
        case m.SwitchOp():
            case_ = next((c for c in op.cases if c.tag.value == values[op.tag]), None)
            member = case_.operation if case_ is not None else None
            wanted = [member.member] if member is not None and not isinstance(member, m.GroupOp) else []
            if list(value) != wanted:
                raise CodecError("tag", f"{op.tag} is {values[op.tag]}, but {op.member} holds {list(value)}")
            if member is not None:
                _write(member, value, out)


def put(op: m.Operation, value: Any) -> bytes:
    """The bytes of one value, without what other values of its record say of it."""
    out = bytearray()
    _put(op, value, {}, out)
    return bytes(out)


def _check_count(op: m.TextOp | m.ArrayOp, value: Any) -> None:
    if (op.count is not None and len(value) != op.count) or len(value) > op.capacity:
        raise CodecError("count", f"{op.member} has {len(value)} elements")


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


def canonical(op: m.Operation, value: Any, where: str) -> Any:
    """A value as an example states it, in the form above. Raises ValueError with a remedy."""
    match op:
        case m.ScalarOp():
            return _canonical_number(op, value, where)
        case m.CounterOp() | m.ConstantOp():
            return _canonical_number(m.ScalarOp(op.member, op.scalar, None, op.size), value, where)
        case m.BitsOp():
            return _canonical_bytes(op, value, where)
        case m.TextOp():
            if not isinstance(value, str):
                raise ValueError(f"{where} must be text, in quotes")
            if any(c > "\xff" for c in value):
                raise ValueError(f"{where} must be text of Latin-1 characters")
            return value.ljust(op.count or 0)
        case m.ArrayOp():
            if not isinstance(value, list):
                raise ValueError(f"{where} must be a list")
            return [canonical(op.item, v, f"{where}[{i}]") for i, v in enumerate(value)]
        case m.StructOp():
            return canonical_record(op.struct.operations, value, where)
        case m.SwitchOp():
            members = tuple(c.operation for c in op.cases if c.operation is not None)
            return canonical_record(members, value, where)
    raise AssertionError(op)


def canonical_record(operations: tuple[m.Operation, ...], values: Any, where: str) -> Values:
    if not isinstance(values, dict):
        raise ValueError(f"{where} must be a mapping of parameter names to values")
    flat: dict[str, m.Operation] = {}
    for op in operations:
        for inner in op.body if isinstance(op, m.GroupOp) else (op,):
            assert not isinstance(inner, m.GroupOp)
            flat[inner.member] = inner
    for name in values:
        if name not in flat:
            raise ValueError(f"{where} has no parameter '{name}'{nearest(name, flat)}")
    return {name: canonical(flat[name], v, f"{where}.{name}") for name, v in values.items()}


def _canonical_bytes(op: m.BitsOp, value: Any, where: str) -> list[int]:
    try:
        found = list(bytes.fromhex(value) if isinstance(value, str) else bytes(list(value)))
    except (TypeError, ValueError):
        found = []
    if len(found) != op.size:
        raise ValueError(f"{where} must be {op.size} bytes: a list of numbers, or hexadecimal digits in quotes")
    return found


def _canonical_number(op: m.ScalarOp, value: Any, where: str) -> int | str:
    if op.scalar.kind == "float":
        if isinstance(value, str) and re.fullmatch(f"0x[0-9A-Fa-f]{{{2 * op.size}}}", value):
            return value.lower()
        if isinstance(value, (str, bool)) or value is None:
            raise ValueError(
                f"{where}: {value!r} is neither a number nor the {2 * op.size} hexadecimal digits of its bits"
            )
        try:
            return "0x" + struct.pack(">f" if op.size == 4 else ">d", value).hex()
        except (OverflowError, struct.error) as error:
            raise ValueError(f"{where}: {value!r} does not fit in a {op.scalar.name}") from error
    if isinstance(value, str) and isinstance(op.type, m.Enum):
        known = op.type.by_name(value)
        if known is None:
            near = nearest(value, [v.name for v in op.type.values])
            raise ValueError(f"{where}: '{op.type.name}' has no value '{value}'{near}")
        return known.value
    if isinstance(value, list) and isinstance(op.type, m.Bitfield):
        bits = {b.name: b for b in op.type.bits}
        unknown = [n for n in value if not isinstance(n, str) or n not in bits]
        if unknown:
            near = nearest(str(unknown[0]), bits)
            raise ValueError(f"{where}: '{op.type.name}' has no bit '{unknown[0]}'{near}")
        mask = 0
        for n in value:
            mask |= bits[n].mask
        return mask
    if isinstance(value, (bool, int)):
        return int(value)
    raise ValueError(f"{where}: {value!r} is not a whole number")
