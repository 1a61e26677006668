"""The conformance driver for Python: one JSON request per line in, one JSON answer per line out.

Run with the generated package on PYTHONPATH.
"""

from __future__ import annotations

import json
import struct
import sys
from typing import Any

from mip_protocol import (
    Answer,
    Client,
    Command,
    DecodeError,
    EncodeError,
    MissingResponse,
    Packet,
    PacketBuilder,
    PacketError,
    Parser,
    RawField,
    Received,
    registry,
)
from mip_protocol.codec import single_from_bits, single_to_bits
from mip_protocol.field import Structure, chosen
from mip_protocol.reflection import Parameter, info


def answer(request: Any) -> dict[str, Any]:
    try:
        known = {"parse": parse, "decode": decode, "encode": encode, "client": client}
        return known[request["op"]](request)
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
    fields = []
    try:
        for raw in packet:
            fields.append(decoded(raw))
    except PacketError as error:
        fields.append({"error": error.kind})
    return {"set": packet.set, "fields": fields}


def decoded(raw: RawField) -> dict[str, Any]:
    kind = chosen(registry.types(raw.set, raw.descriptor), raw)
    try:
        if kind is None:
            return {"descriptor": raw.descriptor, "raw": raw.data.hex()}
        return with_values(raw, *kind.decode_with_trailing(raw.data))
    except DecodeError as error:
        return broken(raw, error)


def with_values(raw: RawField, value: Any, trailing: int) -> dict[str, Any]:
    shown: dict[str, Any] = {"descriptor": raw.descriptor, "name": value.name_in(raw.set), "role": value.ROLE}
    return shown | {"values": record(value), "trailing": trailing}


def broken(raw: RawField, error: Any) -> dict[str, Any]:
    return {"descriptor": raw.descriptor, "error": error.kind, "raw": raw.data.hex()}


def record(value: Structure) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for p in info(type(value)).parameters:
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
    """A union is None both when it is empty and when it is absent: its tag and what is required decide."""
    if getattr(value, p.attribute) is not None:
        return True
    required = getattr(value, "REQUIRED", None)
    if required is None:
        return True
    number = [q.name for q in info(type(value)).parameters].index(p.name)
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
    if not 0 <= request["set"] <= 255 or not all(0 <= f["descriptor"] <= 255 for f in request["fields"]):
        raise ValueError("neither a set nor a descriptor")
    builder = PacketBuilder(request["set"])
    for field in request["fields"]:
        if "raw" in field:
            builder.add(field["descriptor"], bytes.fromhex(field["raw"]))
            continue
        kinds = registry.types(request["set"], field["descriptor"])
        kind = next((k for k in kinds if field["name"] == k.name_in(request["set"])), None)
        if kind is None:
            raise EncodeError("unknown", field["name"])
        builder.add(field["descriptor"], built(kind, field["values"]).encode())
    return {"packet": bytes(builder.build()).hex()}


def built(kind: Any, values: dict[str, Any]) -> Any:
    parameters = info(kind).parameters
    known = {p.name for p in parameters if p.kind != "constant"}
    if not known >= values.keys():
        raise EncodeError("unknown", str(values.keys() - known))
    required = getattr(kind, "REQUIRED", None)
    given: dict[str, Any] = {}
    for number_, p in enumerate(parameters):
        if p.kind == "constant":
            continue
        if p.kind == "counter":
            array = next(q.name for q in parameters if q.attribute == p.counts)
            if p.name in values and (array not in values or len(values[array]) != values[p.name]):
                raise EncodeError("count", p.name)
            if p.name not in values and array in values:
                raise EncodeError("missing", p.name)
        elif p.name not in values:
            if p.kind == "switch" and (required is None or required.get(values.get("function"), 0) >= number_):
                raise EncodeError("missing", p.name)  # an empty union is None, like an absent one
            given.setdefault(p.attribute, None)
        elif p.kind == "switch":
            given[p.attribute] = member(p, values[p.name], given[p.tag])
        else:
            given[p.attribute] = parsed(p, values[p.name])
    return kind(**given)


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


# --------------------------------------------------------------------------- client


def client(request: dict[str, Any]) -> dict[str, Any]:
    if not isinstance(request["steps"], list):
        raise ValueError("no list of steps")
    return {"events": Session().play(request["steps"])}


class Session:
    """A client, what it has sent, and what has happened."""

    def __init__(self) -> None:
        self.client = Client()
        self.now = 0  # milliseconds
        self.sent: list[Command] = []
        self.events: list[dict[str, Any]] = []

    def play(self, steps: list[dict[str, Any]]) -> list[dict[str, Any]]:
        kinds = {"send": self.send, "receive": self.receive, "time": self.time, "end": self.end}
        for step in steps:
            kinds[step["step"]](step)
        return self.events

    def number(self, command: Command) -> int:
        return next(i for i, c in enumerate(self.sent) if c is command)

    def happens(self, event: str, **what: Any) -> None:
        self.events.append({"event": event, **what})

    def send(self, step: dict[str, Any]) -> None:
        if not 1 <= step["set"] <= 255 or not step["fields"]:
            raise ValueError("neither a set nor a command")
        try:
            commands = []
            trial = PacketBuilder(step["set"])  # of several mistakes, the first one is reported
            for f in step["fields"]:
                commands.append(self.command(step["set"], f))
                trial.add(commands[-1].DESCRIPTOR, commands[-1].encode())
            packet = self.client.send(*commands, now=self.now / 1000)
        except EncodeError as error:
            self.happens("not_sent", error=error.kind)
            return
        self.sent += commands
        self.happens("sent", packet=packet.hex(), commands=[self.number(c) for c in commands])
        for command in commands:
            if not any(c is command for c in self.client.pending):
                self.happens("silent", command=self.number(command))

    def command(self, number: int, field: dict[str, Any]) -> Any:
        kinds = registry.types(number, field["descriptor"])
        kind = next((k for k in kinds if field["name"] == k.NAME and issubclass(k, Command)), None)
        if kind is None:
            raise EncodeError("unknown", field["name"])
        return built(kind, field["values"])

    def receive(self, step: dict[str, Any]) -> None:
        data = bytes.fromhex(step["bytes"])
        chunk = step.get("chunk", len(data) or 1)
        if chunk < 1:
            raise ValueError("no chunk")
        for at in range(0, len(data), chunk):
            self.show(self.client.receive(data[at : at + chunk], now=self.now / 1000))

    def time(self, step: dict[str, Any]) -> None:
        if step["milliseconds"] < 0:
            raise ValueError("time does not go back")
        self.now += step["milliseconds"]
        self.show(self.client.poll(now=self.now / 1000))

    def end(self, step: dict[str, Any]) -> None:
        self.show(self.client.flush(now=self.now / 1000))
        self.happens("end", waiting=[self.number(c) for c in self.client.pending], skipped=self.client.skipped)

    def show(self, events: list[Any]) -> None:
        for event in events:
            if isinstance(event, Answer):
                self.answer(event)
            elif isinstance(event, Received):
                malformed = event.packet.malformed
                fields = [*map(decoded, event.fields), *([{"error": malformed.kind}] if malformed else [])]
                self.happens("received", set=event.packet.set, fields=fields)
            else:
                self.happens("timed_out", command=self.number(event.command))

    def answer(self, event: Answer) -> None:
        number = self.number(event.command)
        if not event.accepted:
            self.happens("refused", command=number, code=int(event.code))
        elif isinstance(event.error, MissingResponse):
            self.happens("missing_response", command=number)
        elif event.raw is None:
            self.happens("acknowledged", command=number)
        elif event.error is not None:
            self.happens("undecodable", command=number, response=broken(event.raw, event.error))
        else:
            trailing = type(event.response).decode_with_trailing(event.raw.data)[1]  # type: ignore[union-attr]
            self.happens("acknowledged", command=number, response=with_values(event.raw, event.response, trailing))


def main() -> None:
    for line in sys.stdin:
        try:
            request = json.loads(line)
        except ValueError:
            request = None
        print(json.dumps(answer(request)))


if __name__ == "__main__":
    main()
