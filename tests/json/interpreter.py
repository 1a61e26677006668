"""The conformance driver for the JSON model: decodes and encodes with what mip.json and its README say, no more.

interpreter.py MIP.JSON       one JSON request per line in, one JSON answer per line out
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

Values = dict[str, Any]
FORMAT = "1"
NO_SETS = (0, 255)


class Wrong(Exception):
    """An error, with the word for it in the answer."""


class Reader:
    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, 0

    @property
    def left(self) -> int:
        return len(self.data) - self.at

    def take(self, size: int) -> bytes:
        if size > self.left:
            raise Wrong("truncated")
        self.at += size
        return self.data[self.at - size : self.at]


def name_in(f: Any, number: int) -> str:
    """The name of a field in a set."""
    return str(next((o["name"] for o in f.get("occurrences", ()) if o["set"] == number), f["name"]))


class Interpreter:
    def __init__(self, document: dict[str, Any]) -> None:
        if document["format"].partition(".")[0] != FORMAT:
            raise SystemExit(f"format {document['format']} is not known")
        self.packet, self.scalars = document["packet"], document["scalars"]
        self.structs = {t["name"]: t for t in document["types"] if t["kind"] == "struct"}
        self.fields = {f["name"]: f for f in document["fields"]}
        self.functions = {f["value"]: f["name"] for f in document["functions"]}
        self.acknowledge = self.fields[document["acknowledge"]]
        self.layouts: dict[tuple[int, int], list[Any]] = {}
        for f in document["fields"]:
            for place in f.get("occurrences", (f,)):
                self.layouts.setdefault((place["set"], f["descriptor"]), []).append(f)

    # ----------------------------------------------------------------------- packets

    def decode(self, packet: bytes) -> dict[str, Any]:
        if packet[:2] != bytes(self.packet["sync"]):
            raise Wrong("sync")
        if len(packet) < 6 or len(packet) != packet[3] + 6 or packet[2] in NO_SETS:
            raise Wrong("length")
        if checksum(packet[:-2]) != packet[-2:]:
            raise Wrong("checksum")
        fields: list[dict[str, Any]] = []
        payload = packet[4:-2]
        while payload:
            length = payload[0]
            if length < 2 or length > len(payload):
                fields.append({"error": "field_length"})
                break
            fields.append(self.field(packet[2], payload[1], payload[2:length]))
            payload = payload[length:]
        return {"set": packet[2], "fields": fields}

    def field(self, number: int, descriptor: int, data: bytes) -> dict[str, Any]:
        f = self.chosen(number, descriptor, data)
        if f is None:
            return {"descriptor": descriptor, "raw": data.hex()}
        try:
            values, trailing = self.values(f, data)
        except Wrong as error:
            return {"descriptor": descriptor, "error": str(error), "raw": data.hex()}
        head = {"descriptor": descriptor, "name": name_in(f, number), "role": f["role"]}
        return {**head, "values": values, "trailing": trailing}

    def encode(self, number: int, fields: list[Any]) -> bytes:
        if number in NO_SETS:
            raise Wrong("set")
        payload = b""
        for f in fields:
            data = bytes.fromhex(f["raw"]) if "raw" in f else self.data(number, f)
            if len(data) > self.packet["max_field_data"]:
                raise Wrong("length")
            payload += bytes((len(data) + 2, f["descriptor"])) + data
        if len(payload) > self.packet["max_payload"]:
            raise Wrong("length")
        head = bytes((*self.packet["sync"], number, len(payload))) + payload
        return head + checksum(head)

    # ----------------------------------------------------------------------- layouts

    def candidates(self, number: int, descriptor: int) -> list[Any]:
        if number < 0x80 and descriptor == self.acknowledge["descriptor"]:
            return [self.acknowledge]
        found = self.layouts.get((number, descriptor), [])
        return found or (self.layouts.get((255, descriptor), []) if number >= 0x80 else [])

    def chosen(self, number: int, descriptor: int, data: bytes) -> Any:
        found = self.candidates(number, descriptor)
        if len(found) < 2:
            return found[0] if found else None
        found = [f for f in found if all(there(c, data) for c in f.get("constants", ()))]
        held = [f for f in found if f["min_size"] <= len(data)]
        return max(held, key=lambda f: f["min_size"]) if held else min(found, key=lambda f: f["min_size"], default=None)

    def required(self, f: Any, function: int | None) -> int:
        if "calls" not in f:
            return sum(not p.get("optional") for p in f["parameters"])
        name = self.functions.get(function) if function is not None else None
        return next((len(c["required"]) for c in f["calls"] if c["function"] == name), 0)

    # ----------------------------------------------------------------------- decoding

    def values(self, f: Any, data: bytes) -> tuple[Values, int]:
        reader, values = Reader(data), Values()
        required = self.required(f, None)
        for op in f["operations"]:
            if op["kind"] != "group":
                self.read(op, reader, values)
                continue
            if op["first"] == 1 and "calls" in f:
                required = self.required(f, values["function"])
            if not self.read_group(op, op["last"] <= required, reader, values):
                break
        return values, reader.left

    def read_group(self, group: Any, required: bool, reader: Reader, values: Values) -> bool:
        if not required and reader.left == 0:
            return False
        before, found = reader.at, dict(values)
        try:
            for op in group["body"]:
                self.read(op, reader, found)
        except Wrong as error:
            if required or str(error) != "truncated":
                raise
            reader.at = before
            return False
        if not required and reader.at == before:
            return False
        values.update(found)
        return True

    def read(self, op: Any, reader: Reader, values: Values) -> None:
        if op["kind"] == "constant":
            if self.number(op["scalar"], reader) != op["value"]:
                raise Wrong("constant")
        else:
            values[op["member"]] = self.item(op, reader, values)

    def item(self, op: Any, reader: Reader, values: Values) -> Any:
        match op["kind"]:
            case "scalar" | "counter":
                return self.number(op["scalar"], reader)
            case "bits":
                return list(reader.take(op["size"]))
            case "text":
                return reader.take(self.count(op, 1, reader, values)).decode("latin-1")
            case "array":
                count = self.count(op, self.size(op["item"]), reader, values)
                return [self.item(op["item"], reader, {}) for _ in range(count)]
            case "struct":
                inner = Values()
                for part in self.structs[op["struct"]]["operations"]:
                    self.read(part, reader, inner)
                return inner
            case "switch":
                inner = Values()
                case_ = selected(op, values)
                if case_ is not None:
                    self.read(case_, reader, inner)
                return inner
        raise AssertionError(op)

    def number(self, scalar: str, reader: Reader) -> int | str:
        size, kind = self.scalars[scalar]["size"], self.scalars[scalar]["kind"]
        data = reader.take(size)
        return "0x" + data.hex() if kind == "float" else int.from_bytes(data, "big", signed=kind == "signed")

    def count(self, op: Any, size: int, reader: Reader, values: Values) -> int:
        if "count" in op:
            return int(op["count"])
        if "counter" not in op:
            return int(min(reader.left // size, op["capacity"]))
        count: int = values[op["counter"]]
        if count * size > reader.left or count > op["capacity"]:
            raise Wrong("count")
        return count

    def size(self, op: Any) -> int:
        match op["kind"]:
            case "scalar" | "constant" | "counter":
                return int(self.scalars[op["scalar"]]["size"])
            case "bits":
                return int(op["size"])
            case "struct":
                return int(self.structs[op["struct"]]["max_size"])
            case "text":
                return int(op["count"])
            case "array":
                return int(op["count"]) * self.size(op["item"])
        raise AssertionError(op)

    # ----------------------------------------------------------------------- encoding

    def data(self, number: int, entry: Any) -> bytes:
        f = next((f for f in self.candidates(number, entry["descriptor"]) if name_in(f, number) == entry["name"]), None)
        if f is None:
            raise Wrong("unknown")
        values = entry["values"]
        no_other(values, f["parameters"])
        out = bytearray()
        required, ended = self.required(f, None), False
        for op in f["operations"]:
            if op["kind"] != "group":
                self.write(op, values, out)
                continue
            if op["first"] == 1 and "calls" in f:
                required = self.required(f, values["function"])
            members = [i["member"] for i in op["body"] if i["kind"] != "constant"]
            if not all(name in values for name in members):
                if op["last"] <= required:
                    raise Wrong("missing")
                ended = True
            if ended:
                if any(name in values for name in members):
                    raise Wrong("missing")
                continue
            for inner in op["body"]:
                self.write(inner, values, out)
        return bytes(out)

    def write(self, op: Any, values: Values, out: bytearray) -> None:
        if op["kind"] == "constant":
            out += self.bytes(op["scalar"], op["value"])
        elif op["member"] not in values:
            raise Wrong("missing")
        else:
            self.put(op, values[op["member"]], values, out)

    def put(self, op: Any, value: Any, values: Values, out: bytearray) -> None:
        match op["kind"]:
            case "scalar":
                out += self.bytes(op["scalar"], value)
            case "counter":
                if len(values.get(op["array"], ())) != value:
                    raise Wrong("count")
                out += self.bytes(op["scalar"], value)
            case "bits":
                if len(value) != op["size"]:
                    raise Wrong("count")
                for byte in value:
                    out += self.bytes("u8", byte)
            case "text":
                value = value.ljust(op.get("count") or 0) if isinstance(value, str) else value
                fits(op, value)
                try:
                    out += value.encode("latin-1")
                except UnicodeEncodeError:
                    raise Wrong("range") from None
            case "array":
                fits(op, value)
                for item in value:
                    self.put(op["item"], item, {}, out)
            case "struct":
                struct = self.structs[op["struct"]]
                no_other(value, struct["parameters"])
                for part in struct["operations"]:
                    self.write(part, value, out)
            case "switch":
                case_ = selected(op, values)
                if list(value) != ([case_["member"]] if case_ is not None else []):
                    raise Wrong("tag")
                if case_ is not None:
                    self.write(case_, value, out)

    def bytes(self, scalar: str, value: Any) -> bytes:
        size, kind = self.scalars[scalar]["size"], self.scalars[scalar]["kind"]
        if kind == "float":
            if not isinstance(value, str) or len(value) != 2 + 2 * size:
                raise Wrong("range")
            return bytes.fromhex(value[2:])
        try:
            return int(value).to_bytes(size, "big", signed=kind == "signed")
        except OverflowError:
            raise Wrong("range") from None


def checksum(data: bytes) -> bytes:
    a = b = 0
    for byte in data:
        a = (a + byte) & 0xFF
        b = (b + a) & 0xFF
    return bytes((a, b))


def there(constant: Any, data: bytes) -> bool:
    at, size = constant["offset"], constant["size"]
    return bool(constant["value"].to_bytes(size, "big").startswith(data[at : at + size]))


def selected(switch: Any, values: Values) -> Any:
    return next((c.get("operation") for c in switch["cases"] if c["value"] == values[switch["tag"]]), None)


def fits(op: Any, value: Any) -> None:
    if len(value) != op.get("count", len(value)) or len(value) > op["capacity"]:
        raise Wrong("count")


def no_other(values: Values, parameters: list[Any]) -> None:
    if not values.keys() <= {p["name"] for p in parameters if "constant" not in p}:
        raise Wrong("unknown")


def answer(line: str, known: Interpreter) -> dict[str, Any]:
    try:
        request = json.loads(line)
        if request["op"] == "decode":
            return known.decode(bytes.fromhex(request["packet"]))
        if request["op"] == "encode" and request["set"] in range(256):
            return {"packet": known.encode(request["set"], request["fields"]).hex()}
    except Wrong as error:
        return {"error": str(error)}
    except (KeyError, TypeError, ValueError):
        pass
    return {"error": "request"}


if __name__ == "__main__":
    known = Interpreter(json.loads(Path(sys.argv[1]).read_text("utf-8")))
    for line in sys.stdin:
        print(json.dumps(answer(line, known)))
