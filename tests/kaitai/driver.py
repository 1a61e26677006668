"""The conformance driver in Python: what the compiled mip.ksy reads, in the form of docs/conformance.md.

    driver.py mip.json

The file mip.ksy says what the attributes of an object are called and of what type they are. The driver itself computes
the checksum, which Kaitai Struct cannot, and takes from the data what a Python number does not hold: the bits of a NaN.
"""

from __future__ import annotations

import json
import math
import struct
import sys
from pathlib import Path
from typing import Any

import kaitaistruct
from mip import Mip

Tree = dict[str, Any]
TREE: Tree = json.loads(Path(sys.argv[1]).read_text("utf-8"))
HOMES: dict[str, str] = TREE["types"]["field"]["instances"]["data"]["type"]["cases"]
ERRORS: tuple[tuple[type[Exception], str], ...] = (
    (EOFError, "truncated"),
    (kaitaistruct.ValidationExprError, "count"),
    (kaitaistruct.ValidationNotEqualError, "constant"),
)


class Walk:
    """Goes through objects in the order of the bytes that they are read from."""

    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, 0

    def take(self, size: int) -> bytes:
        self.at += size
        return self.data[self.at - size : self.at]

    def record(self, thing: Any, spec: Tree, scope: Tree) -> Any:
        """The value of an object, whose type has this description."""
        kind = spec.get("-kind")
        if kind in ("bits", "bytes"):
            return self.bits(thing, spec["seq"], kind)
        scope = {**scope, **spec.get("types", {})}
        values = {}
        for attribute in spec.get("seq", ()):
            value = getattr(thing, attribute["id"], None)
            if value is None:
                continue
            if "repeat" in attribute:
                found: Any = [self.value(v, attribute, scope) for v in value]
            else:
                found = self.value(value, attribute, scope)
            if not isinstance(attribute.get("valid"), int):  # a constant, which is not a value
                values[attribute.get("-orig-id", attribute["id"])] = found
        return list(values.values()) if kind == "vector" else values

    def bits(self, thing: Any, seq: list[Tree], kind: str) -> Any:
        """The number, or the bytes, that the bits are part of."""
        number = width = 0
        for part in seq:
            size, value = int(part["type"][1:]), int(getattr(thing, part["id"]))
            number = number | value << width if kind == "bytes" else number << size | value
            width += size
        self.take(width // 8)
        return list(number.to_bytes(width // 8, "little")) if kind == "bytes" else number

    def value(self, value: Any, attribute: Tree, scope: Tree) -> Any:
        type_name = attribute["type"]
        if type_name in scope:
            return self.record(value, scope[type_name], scope)
        if type_name == "str":
            assert self.take(len(value)).decode("latin-1") == value
            return value
        raw = self.take(int(type_name[1]))
        if type_name[0] != "f":
            return int(value)
        bits = struct.pack(">f" if len(raw) == 4 else ">d", value)
        if math.isnan(value):
            assert math.isnan(struct.unpack(">f" if len(raw) == 4 else ">d", raw)[0])
            bits = raw
        return "0x" + bits.hex()


def field(found: Any) -> Tree:
    """A field of a packet as it is in an answer."""
    if not found.is_sound:
        return {"error": "field_length"}
    raw, answer = found.content.bytes, {"descriptor": found.descriptor}
    try:
        data = found.data
    except tuple(e for e, _ in ERRORS) as error:
        return {**answer, "error": next(word for e, word in ERRORS if isinstance(error, e)), "raw": raw.hex()}
    kind = TREE["enums"]["kind"].get(str(int(found.kind)), {})
    spec = TREE["types"][HOMES[f"kind::{kind['id']}"]] if kind else {}
    name = kind.get("-orig-id")
    if spec.get("-kind") == "layouts":
        data = data.layout
        spec = TREE["types"].get(spec["seq"][0]["type"]["cases"].get(str(data_number(found))), {})
        if spec:  # the set is that of the packet
            name = f"{name.partition('.')[0]}.{spec['-orig-id'].partition('.')[2]}"
    if not spec:
        assert data == raw
        return {**answer, "raw": raw.hex()}
    walk = Walk(raw)
    values = walk.record(data, spec, TREE["types"])
    assert walk.at == data._io.pos(), (walk.at, data._io.pos())
    return {**answer, "name": name, "role": kind["-role"], "values": values, "trailing": len(raw) - walk.at}


def data_number(found: Any) -> int:
    number: int = found.data.number
    return number


def decode(packet: bytes) -> Tree:
    if packet[:2] != b"ue":
        return {"error": "sync"}
    part = Mip.from_bytes(packet).parts[0]
    if not part.is_packet or len(packet) != part.packet.length + 6:
        return {"error": "length"}
    a = b = 0
    for byte in packet[:-2]:
        a = (a + byte) & 0xFF
        b = (b + a) & 0xFF
    if part.packet.checksum != a << 8 | b:
        return {"error": "checksum"}
    return {"set": part.packet.set, "fields": [field(f) for f in part.packet.payload.fields]}


def answer(line: str) -> Tree:
    try:
        request = json.loads(line)
        packet = bytes.fromhex(request["packet"]) if request["op"] == "decode" else None
    except (KeyError, TypeError, ValueError):
        packet = None
    return {"error": "request"} if packet is None else decode(packet)


if __name__ == "__main__":
    for line in sys.stdin:
        print(json.dumps(answer(line)))
