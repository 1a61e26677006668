"""The conformance driver of C and C++ (docs/conformance.md): `driver.py PROGRAM`.

The program, driver.c with the library, does what is tested: it finds packets, decodes, encodes, and has the client.
This part turns its structures into values and values into structures, by the reflection tables of the library. It
contains no message definitions.
"""

from __future__ import annotations

import json
import re
import struct
import subprocess
import sys
from collections.abc import Iterator
from typing import Any

NUMBER, CONSTANT, COUNTER, TEXT, BITS, STRUCT, UNION = range(7)
ONE, FIXED, COUNTED, REST = range(4)
Json = dict[str, Any]


class Wrong(Exception):
    """A request that is rejected; its text is the error."""


class Program:
    def __init__(self, command: list[str]) -> None:
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.known: dict[tuple[int, str], int] = {}
        tables = self.ask("describe")
        self.order, self.types = tables["order"], tables["types"]

    def ask(self, *words: object) -> Any:
        assert self.process.stdin and self.process.stdout
        self.process.stdin.write(" ".join(map(str, words)) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:  # the library has failed
            sys.exit(abs(self.process.wait()))
        return json.loads(line)

    def find(self, number: int, name: str) -> Json:
        """The type that has this name in a set."""
        if (number, name) not in self.known:
            plain = re.fullmatch(r"[a-z0-9_]+\.[a-z0-9_]+", name)
            self.known[number, name] = self.ask("find", number, name) if plain else -1
        index = self.known[number, name]
        if index < 0:
            raise Wrong("unknown")
        return {"index": index, **self.types[index]}


class Memory:
    """A structure as it is in memory."""

    def __init__(self, order: str, content: bytes) -> None:
        self.order, self.bytes = order, bytearray(content)

    def get(self, kind: str, at: int) -> Any:
        bits = kind.translate({ord("f"): "I", ord("d"): "Q"})
        (number,) = struct.unpack_from(self.order + bits, self.bytes, at)
        return number if bits == kind else f"0x{number:0{2 * struct.calcsize(bits)}x}"

    def set(self, kind: str, at: int, value: Any) -> None:
        if kind in "fd":
            kind = {"f": "I", "d": "Q"}[kind]
            digits = 2 * struct.calcsize(kind)
            if not isinstance(value, str) or not re.fullmatch(rf"0x[0-9a-fA-F]{{{digits}}}", value):
                raise Wrong("range")
            value = int(value, 16)
        if not isinstance(value, int):
            raise Wrong("request")
        try:
            struct.pack_into(self.order + kind, self.bytes, at, value)
        except struct.error:
            raise Wrong("range") from None

    # ----------------------------------------------------------------------- values of a structure

    def record(self, parameters: list[Json], at: int, present: int = 0) -> Json:
        shown = [p for p in parameters if p["kind"] != CONSTANT and p["group"] <= present]
        return {p["name"]: self.value(p, parameters, at) for p in shown}

    def value(self, p: Json, among: list[Json], base: int) -> Any:
        at = base + p["offset"]
        if p["kind"] == UNION:
            member = self.case(p, among, base)
            return self.record([member], at, member["group"]) if member else {}
        if p["kind"] == BITS:
            return list(self.bytes[at : at + p["item_size"]])
        if p["length"] == ONE:
            return self.item(p, at)
        count = p["capacity"]
        if p["length"] == COUNTED:
            count = self.value(among[p["by"]], among, base)
        elif p["length"] == REST:
            count = self.bytes[base + p["count_offset"]]
        if p["kind"] == TEXT:
            return self.bytes[at : at + count].decode("latin-1")
        return [self.item(p, at + i * p["item_size"]) for i in range(count)]

    def item(self, p: Json, at: int) -> Any:
        if p["kind"] == STRUCT:
            return self.record(p["record"], at)
        size = struct.calcsize(p["scalar"])
        numbers = [self.get(p["scalar"], at + i * size) for i in range(p["elements"])]
        return numbers if p["elements"] > 1 else numbers[0]

    def case(self, p: Json, among: list[Json], base: int) -> Any:
        """The selected member of a union; None if it is empty."""
        tag = among[p["by"]]
        value = self.get(tag["scalar"].upper(), base + tag["offset"])
        return next((member for number, member in p["cases"] if number == value), None)

    # ----------------------------------------------------------------------- a structure of values

    def fill_field(self, of: Json, values: Json) -> None:
        """Parameters of one group are all present or all absent."""
        refuse_unknown(of["record"], values)
        required, ended = 0, False
        for number, members in groups(of["record"]):
            there = [p["name"] in values for p in members if p["kind"] != CONSTANT]
            if number and (ended or not all(there)):
                if any(there) or (number <= required and not all(there)):
                    raise Wrong("missing")
                ended = True
                continue
            for p in members:
                self.fill(p, of["record"], 0, values)
            if members[0] is of["record"][0] and of["required"]:
                function = self.value(members[0], members, 0)
                required = of["required"][function] if function < len(of["required"]) else 0
            if number:
                self.bytes[of["present"]] = number

    def fill_record(self, parameters: list[Json], base: int, values: Any) -> None:
        if not isinstance(values, dict):
            raise Wrong("request")
        refuse_unknown(parameters, values)
        for p in parameters:
            self.fill(p, parameters, base, values)

    def fill(self, p: Json, among: list[Json], base: int, values: Json) -> None:
        at = base + p["offset"]
        if p["kind"] == CONSTANT:
            return
        if p["name"] not in values:
            raise Wrong("missing")
        value = values[p["name"]]
        if p["kind"] == COUNTER:
            items = values.get(among[p["by"]]["name"])
            if not isinstance(value, int):
                raise Wrong("request")
            if not isinstance(items, (list, str)) or value != len(items):
                raise Wrong("count")
        if p["kind"] == UNION:
            self.fill_union(p, self.case(p, among, base), at, value)
        elif p["kind"] == BITS:
            self.fill_items(
                p | {"scalar": "B", "capacity": p["item_size"], "item_size": 1, "length": FIXED}, base, value
            )
        elif p["length"] == ONE:
            self.fill_item(p, at, value)
        else:
            self.fill_items(p, base, value)

    def fill_union(self, p: Json, member: Any, at: int, value: Any) -> None:
        if not isinstance(value, dict):
            raise Wrong("request")
        if list(value) != ([member["name"]] if member else []):
            raise Wrong("tag")
        if member:
            self.fill(member, [member], at, value)

    def fill_items(self, p: Json, base: int, value: Any) -> None:
        at, text, fixed = base + p["offset"], p["kind"] == TEXT, p["length"] == FIXED
        if not isinstance(value, str if text else list):
            raise Wrong("request")
        if len(value) > p["capacity"] or (fixed and not text and len(value) < p["capacity"]):
            raise Wrong("count")
        if p["length"] == REST:
            self.bytes[base + p["count_offset"]] = len(value)
        if text:
            try:
                data = value.encode("latin-1")
            except UnicodeEncodeError:
                raise Wrong("range") from None
            data = data.ljust(p["capacity"]) if fixed else data
            self.bytes[at : at + len(data)] = data
            return
        for i, item in enumerate(value):
            self.fill_item(p, at + i * p["item_size"], item)

    def fill_item(self, p: Json, at: int, value: Any) -> None:
        if p["kind"] == STRUCT:
            self.fill_record(p["record"], at, value)
        elif p["elements"] == 1:
            self.set(p["scalar"], at, value)
        elif not isinstance(value, list):
            raise Wrong("request")
        elif len(value) != p["elements"]:
            raise Wrong("count")
        else:
            for i, number in enumerate(value):
                self.set(p["scalar"], at + i * struct.calcsize(p["scalar"]), number)


def refuse_unknown(parameters: list[Json], values: Json) -> None:
    if values.keys() - {p["name"] for p in parameters if p["kind"] != CONSTANT}:
        raise Wrong("unknown")


def groups(parameters: list[Json]) -> Iterator[tuple[int, list[Json]]]:
    """The parameters that are present together; each that is always present stands alone."""
    at = 0
    while at < len(parameters):
        number, end = parameters[at]["group"], at + 1
        while number and end < len(parameters) and parameters[end]["group"] == number:
            end += 1
        yield number, parameters[at:end]
        at = end


# --------------------------------------------------------------------------- requests


def whole(value: Any, least: int, most: int) -> int:
    if not isinstance(value, int) or not least <= value <= most:
        raise Wrong("request")
    return value


def hexadecimal(value: Any) -> str:
    """A word for the program."""
    if not isinstance(value, str) or not re.fullmatch(r"(?:[0-9a-fA-F]{2})*", value):
        raise Wrong("request")
    return f"x{value.lower()}"


class Driver:
    def __init__(self, program: Program) -> None:
        self.program = program

    def answer(self, line: str) -> Json:
        try:
            request = json.loads(line)
            op = request["op"]
            handler = {"parse": self.parse, "decode": self.decode, "encode": self.encode, "client": self.client}[op]
            return handler(request)
        except Wrong as wrong:
            return {"error": str(wrong)}
        except (ValueError, KeyError, TypeError):
            return {"error": "request"}

    def parse(self, request: Json) -> Json:
        found: Json = self.program.ask("parse", whole(request["chunk"], 1, 1 << 60), hexadecimal(request["stream"]))
        return found

    def decode(self, request: Json) -> Json:
        found: Json = self.program.ask("decode", hexadecimal(request["packet"]))
        return {**found, "fields": [self.shown(f) for f in found["fields"]]} if "fields" in found else found

    def shown(self, field: Json) -> Json:
        """A field of a packet with its values."""
        if "type" not in field:
            return field
        of = self.program.types[field.pop("type")]
        memory = Memory(self.program.order, bytes.fromhex(field.pop("value")))
        present = memory.bytes[of["present"]] if of["present"] >= 0 else 0
        return {**field, "role": of["role"], "values": memory.record(of["record"], 0, present)}

    def encode(self, request: Json) -> Json:
        number, fields = whole(request["set"], 0, 255), request["fields"]
        if not isinstance(fields, list):
            raise Wrong("request")
        words = self.words(number, fields, self.field) if 0 < number < 255 else []  # those sets have no packets
        found: Json = self.program.ask("encode", number, *words)
        return found

    def words(self, number: int, fields: list[Any], make: Any) -> list[str]:
        """The fields as words. Of several mistakes, the first one counts: what precedes it is encoded."""
        words: list[str] = []
        for field in fields:
            try:
                words += make(number, field)
            except Wrong as wrong:
                before = self.program.ask("encode", number, *words) if words else {}
                raise Wrong(before.get("error", str(wrong))) from None
        return words

    def field(self, number: int, field: Json) -> list[str]:
        if isinstance(field, dict) and "raw" in field:
            return ["raw", str(whole(field["descriptor"], 0, 255)), hexadecimal(field["raw"])]
        return self.named(number, field)[1]

    def named(self, number: int, field: Any) -> tuple[Json, list[str]]:
        if not isinstance(field, dict):
            raise Wrong("request")
        name, values = field.get("name"), field.get("values")
        descriptor = whole(field.get("descriptor", 0), 0, 255)
        if not isinstance(name, str) or not isinstance(values, dict):
            raise Wrong("request")
        of = self.program.find(number, name)
        if "descriptor" in field and of["descriptor"] != descriptor:
            raise Wrong("unknown")
        memory = Memory(self.program.order, bytes(of["size"]))
        memory.fill_field(of, values)
        return of, ["value", str(of["index"]), f"x{memory.bytes.hex()}"]

    def command(self, number: int, field: Any) -> list[str]:
        of, words = self.named(number, field)
        if of["role"] != "command":
            raise Wrong("unknown")
        return words

    # ----------------------------------------------------------------------- the client

    def client(self, request: Json) -> Json:
        return {"events": Session(self).play(request["steps"])}


class Session:
    """The steps of a client."""

    def __init__(self, driver: Driver) -> None:
        self.driver, self.now = driver, 0
        self.events: list[Json] = []
        driver.program.ask("client")

    def play(self, steps: Any) -> list[Json]:
        if not isinstance(steps, list):
            raise Wrong("request")
        kinds = {"send": self.send, "receive": self.receive, "time": self.wait, "end": self.end}
        for step in steps:
            kinds[step["step"]](step)
        return self.events

    def ask(self, word: str, *words: object) -> None:
        """Makes a step, and adds its events: answers come before the fields of their packet that answer nothing."""
        found = self.driver.program.ask(word, self.now, *words)
        for entry in found["events"]:
            parts = entry.get("parts", [entry])
            answers = [p for p in parts if "event" in p]
            fields = [self.driver.shown(p) for p in parts if "event" not in p]
            for answer in answers:
                if "response" in answer:
                    answer["response"] = self.driver.shown(answer["response"])
            self.events += answers
            if fields or not answers:
                self.events.append({"event": "received", "set": entry["set"], "fields": fields})

    def send(self, step: Json) -> None:
        number, fields = whole(step["set"], 1, 255), step["fields"]
        if not isinstance(fields, list) or not fields:
            raise Wrong("request")
        try:
            words = self.driver.words(number, fields, self.driver.command)
        except Wrong as wrong:
            if str(wrong) == "request":
                raise
            self.events.append({"event": "not_sent", "error": str(wrong)})
            return
        self.ask("send", number, *words)

    def receive(self, step: Json) -> None:
        self.ask("receive", whole(step.get("chunk", 1 << 30), 1, 1 << 60), hexadecimal(step["bytes"]))

    def wait(self, step: Json) -> None:
        self.now = (self.now + whole(step["milliseconds"], 0, (1 << 32) - 1)) % (1 << 32)
        self.ask("time")

    def end(self, step: Json) -> None:
        self.ask("end")


if __name__ == "__main__":
    driver = Driver(Program(sys.argv[1:]))
    for line in sys.stdin:
        print(json.dumps(driver.answer(line)), flush=True)
