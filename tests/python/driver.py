"""The conformance driver for Python: one JSON request per line in, one JSON answer per line out.

Run with the generated package on PYTHONPATH.
"""

from __future__ import annotations

import json
import struct
import sys
from typing import Any

from mip_protocol import DecodeError, EncodeError, Packet, PacketBuilder, PacketError, Parser, registry
from mip_protocol.codec import single_from_bits, single_to_bits
from mip_protocol.field import Structure, chosen
from mip_protocol.reflection import PARAMETERS, Parameter


def answer(request: Any) -> dict[str, Any]:
    try:
        return {"parse": parse, "decode": decode, "encode": encode}[request["op"]](request)
    except EncodeError as error:
        return {"error": error.kind}
    except (KeyError, TypeError, ValueError, AttributeError):
        return {"error": "request"}


def parse(request: dict[str, Any]) -> dict[str, Any]:
    parser, packets = Parser(), []
    stream, chunk = bytes.fromhex(request["stream"]), request["chunk"]
    if chunk < 1:
        raise ValueError("no chunk")
    for at in range(0, len(stream), chunk):
        packets += parser.feed(stream[at : at + chunk])
    packets += parser.flush()
    return {"packets": [bytes(p).hex() for p in packets], "skipped": parser.skipped}


# --------------------------------------------------------------------------- decode


def decode(request: dict[str, Any]) -> dict[str, Any]:
    try:
        packet = Packet(bytes.fromhex(request["packet"]))
    except PacketError as error:
        return {"error": error.kind}
    fields: list[dict[str, Any]] = []
    try:
        for raw in packet:
            kind = chosen(registry.types(raw.set, raw.descriptor), raw)
            shown: dict[str, Any] = {"descriptor": raw.descriptor}
            try:
                if kind is None:
                    shown["raw"] = raw.data.hex()
                else:
                    value, trailing = kind.decode_with_trailing(raw.data)
                    shown |= {"name": kind.NAME, "role": kind.ROLE}
                    shown |= {"values": record(value), "trailing": trailing}
            except DecodeError as error:
                shown |= {"error": error.kind, "raw": raw.data.hex()}
            fields.append(shown)
    except PacketError as error:
        fields.append({"error": error.kind})
    return {"set": packet.set, "fields": fields}


def record(value: Structure) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for p in PARAMETERS[type(value)]:
        if p.kind == "constant":
            continue
        if p.kind == "counter":
            items = getattr(value, p.counts)
            if items is not None:
                found[p.name] = len(items)
            continue
        member = getattr(value, p.attribute)
        if p.kind == "switch":
            case = p.cases.get(getattr(value, p.tag))
            if getattr(value, p.tag) is not None and present(value, p):
                found[p.name] = {case.name: shown(case, member)} if case and member is not None else {}
        elif member is not None:
            found[p.name] = shown(p, member)
    return found


def present(value: Structure, p: Parameter) -> bool:
    """A union holds None both when it is empty and when it is absent: its case and what it needs tell."""
    if getattr(value, p.attribute) is not None:
        return True
    required = getattr(value, "REQUIRED", None)
    if required is None:
        return True
    number = [q.name for q in PARAMETERS[type(value)]].index(p.name)
    return bool(required.get(value.function, 0) >= number)  # type: ignore[attr-defined]


def shown(p: Parameter, value: Any) -> Any:
    if p.kind == "text":
        return value
    if p.scalar == "bits":
        return list(int(value).to_bytes(p.size, "little"))
    if p.kind == "array" and p.length is not None:
        return [element(p, v) for v in value]
    return element(p, value)


def element(p: Parameter, value: Any) -> Any:
    if isinstance(value, Structure):
        return record(value)
    if p.elements:
        return [number(p, v) for v in value]
    return number(p, value)


def number(p: Parameter, value: Any) -> Any:
    if p.scalar == "float":
        return f"0x{single_to_bits(value):08x}"
    if p.scalar == "double":
        return "0x" + struct.pack(">d", value).hex()
    return int(value)


# --------------------------------------------------------------------------- encode


def encode(request: dict[str, Any]) -> dict[str, Any]:
    if not 1 <= request["set"] <= 255 or not all(0 <= f["descriptor"] <= 255 for f in request["fields"]):
        raise ValueError("neither a set nor a descriptor")
    builder = PacketBuilder(request["set"])
    for field in request["fields"]:
        if "raw" in field:
            builder.add(field["descriptor"], bytes.fromhex(field["raw"]))
            continue
        kinds = registry.types(request["set"], field["descriptor"])
        kind = next((k for k in kinds if field["name"] == k.NAME), None)
        if kind is None:
            raise EncodeError("unknown", field["name"])
        builder.add(field["descriptor"], built(kind, field["values"]).encode())
    return {"packet": bytes(builder.build()).hex()}


def built(kind: Any, values: dict[str, Any]) -> Any:
    parameters = PARAMETERS[kind]
    known = {p.name for p in parameters if p.kind != "constant"}
    if not known >= values.keys():
        raise EncodeError("unknown", str(values.keys() - known))
    given: dict[str, Any] = {}
    for p in parameters:
        if p.kind == "constant":
            continue
        if p.name not in values:
            given.setdefault(p.attribute, None)
        elif p.kind == "counter":
            array = next(q.name for q in parameters if q.attribute == p.counts)
            if array not in values or len(values[array]) != values[p.name]:
                raise EncodeError("count", p.name)
        elif p.kind == "switch":
            given[p.attribute] = member(p, values[p.name], given[p.tag])
        else:
            given[p.attribute] = parsed(p, values[p.name])
    for p in parameters:
        if p.kind == "counter":
            given.pop(p.attribute, None)
            array = next(q for q in parameters if q.attribute == p.counts)
            if p.name not in values and array.name in values:
                raise EncodeError("missing", p.name)
    check_presence(kind, parameters, values)
    return kind(**given)


def check_presence(kind: Any, parameters: tuple[Parameter, ...], values: dict[str, Any]) -> None:
    """An empty union is None, as an absent one is: look for gaps and missing ones here."""
    required = getattr(kind, "REQUIRED", None)
    for number_, p in enumerate(parameters):
        if p.kind != "switch" or p.name in values:
            continue
        if required is None or required.get(values.get("function"), 0) >= number_:
            raise EncodeError("missing", p.name)


def member(p: Parameter, value: dict[str, Any], tag: Any) -> Any:
    case = p.cases.get(tag)
    if list(value) != ([case.name] if case else []):
        raise EncodeError("tag", p.name)
    return parsed(case, value[case.name]) if case else None


def parsed(p: Parameter, value: Any) -> Any:
    if p.kind == "text":
        return value
    if p.scalar == "bits":
        if len(value) != p.size:
            raise EncodeError("count", p.name)
        return p.type(int.from_bytes(octets(value), "little"))
    if p.kind == "array" and p.length is not None:
        return tuple(parsed_element(p, v) for v in value)
    return parsed_element(p, value)


def octets(values: list[int]) -> bytes:
    try:
        return bytes(values)
    except ValueError as error:
        raise EncodeError("range", str(error)) from error


def parsed_element(p: Parameter, value: Any) -> Any:
    if isinstance(p.type, type) and issubclass(p.type, Structure):
        return built(p.type, value)
    if p.elements:
        return tuple(parsed_number(p, v) for v in value)
    return parsed_number(p, value)


def parsed_number(p: Parameter, value: Any) -> Any:
    if p.scalar in ("float", "double"):
        raw = bytes.fromhex(value[2:]) if isinstance(value, str) else b""
        if len(raw) != (4 if p.scalar == "float" else 8):
            raise EncodeError("range", p.name)
        return single_from_bits(int.from_bytes(raw, "big")) if len(raw) == 4 else struct.unpack(">d", raw)[0]
    return int(value)


def main() -> None:
    for line in sys.stdin:
        try:
            request = json.loads(line)
        except ValueError:
            request = None
        print(json.dumps(answer(request)))


if __name__ == "__main__":
    main()
