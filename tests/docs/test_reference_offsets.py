"""Offsets and lengths in the reference are those of the bytes."""

from __future__ import annotations

import random
import re
from typing import Any

from mipgen import model as m
from mipgen.lower import codec
from reference import Manual, table_with, words


class Filler:
    """Random values for a record, and the bytes that each of them should become, by path."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.bytes: dict[str, bytes] = {}
        self.counts: dict[str, int] = {}

    def record(self, parameters: tuple[m.Parameter, ...], prefix: str = "") -> dict[str, Any]:
        values: dict[str, Any] = {}
        counters = {p.counts: p.name for p in parameters if p.counts}
        tags = {p.tag for p in parameters if p.tag}
        for p in parameters:
            path = prefix + p.name
            if p.counts or p.name in tags:
                assert p.kind in ("counter", "scalar")
                value = self.random.randrange(3)
                if p.name in tags:
                    union = next(q for q in parameters if q.tag == p.name)
                    value = self.random.choice(union.cases).tag.value
                else:
                    self.counts[path] = value
                values[p.name] = value
                self.bytes[path] = value.to_bytes(p.size, "big")
            elif p.constant is not None:
                self.bytes[path] = p.constant.to_bytes(p.size, "big")
            elif p.tag:
                case = next(c for c in p.cases if c.tag.value == values[p.tag])
                q = case.parameter
                values[p.name] = {q.name: self.one(q, f"{path}.{q.name}", None)} if q else {}
                self.bytes[path] = self.bytes[f"{path}.{q.name}"] if q else b""
            else:
                counter = counters.get(p.name)
                values[p.name] = self.one(p, path, values[counter] if counter else None)
        return values

    def one(self, p: m.Parameter, path: str, count: int | None) -> Any:
        if p.struct:
            before = set(self.bytes)
            values = self.record(p.struct.parameters, f"{path}.")
            new = [k for k in self.bytes if k not in before]
            inner = [f"{path}.{q.name}" for q in p.struct.parameters]
            self.bytes[path] = b"".join(self.bytes[k] for k in new if k in inner)
            return values
        if p.kind == "text":
            self.bytes[path] = self.random.randbytes(self.elements(p, count))
            return self.bytes[path].decode("latin-1")
        if p.kind == "array":
            n = self.elements(p, count)
            items = [self.one(p.item, f"{path}[{i}]", None) for i in range(n)]
            self.bytes[path] = b"".join(self.bytes.pop(f"{path}[{i}]") for i in range(n))
            return items
        raw = self.bytes[path] = self.random.randbytes(p.size)
        if p.kind == "bits":
            return list(raw)
        if p.scalar.kind == "float":
            return "0x" + raw.hex()
        return int.from_bytes(raw, "big", signed=p.scalar.kind == "signed")

    def elements(self, p: m.Parameter, count: int | None) -> int:
        if p.count is not None or count is not None:
            return p.count if p.count is not None else int(count or 0)
        self.counts["rest"] = self.random.randrange(3)
        return self.counts["rest"]


def evaluate(expression: str, names: dict[str, int]) -> int:
    """The value of an expression such as "4 + 3*count"."""
    total = 0
    for term in expression.split(" + "):
        factor, _, name = term.rpartition("*")
        total += int(factor or 1) * (names[name] if not name.isdigit() else int(name))
    return total


def lengths(text: str, names: dict[str, int]) -> set[int]:
    """The values in a text such as "5, 7 or 10 + 3*count"; those with an absent counter are left out."""
    found = re.split(r", | or |; ", text)
    return {evaluate(x, names) for x in found if set(re.findall(r"[a-z_][\w.]*", x)) <= names.keys()}


def indexed(path: str) -> tuple[str, dict[str, int]]:
    """
    >>> indexed("a[2].b[1].c")
    ('a[i].b[j].c', {'i': 2, 'j': 1})
    """
    names: dict[str, int] = {}

    def letter(match: re.Match[str]) -> str:
        name = "ijklmn"[len(names)]
        names[name] = int(match[1])
        return f"[{name}]"

    return re.sub(r"\[(\d+)\]", letter, path), names


def test_offsets_are_those_of_the_bytes(manual: Manual) -> None:
    """Random values of every field are encoded; what is at each documented offset is that value."""
    for f in manual.fields:
        section, less = manual.parameters(f)
        rows = [(words(r["Name"]), r) for r in table_with(section, "Offset", "Name")]
        rows = [(name, r) for name, r in rows if f.selector or name != "function"]
        unseen = {name for name, _ in rows}
        for seed in range(200):
            filler = Filler(seed)
            values = filler.record(f.parameters)
            if f.functions:
                values["function"] = filler.random.choice(f.functions).value
                filler.bytes["function"] = bytes([values["function"]])
            data = codec.encode(f, values)
            assert len(data) + 2 in documented_lengths(manual, f, values, filler), f.full_name
            for path, raw in filler.bytes.items():
                name, indices = indexed(path)
                row = next((r for n, r in rows if n == name), None)
                assert row is not None, f"{f.full_name}: {name}"
                names = {**filler.counts, **indices}
                offset = evaluate(words(row["Offset"]), names) - less
                assert data[offset : offset + len(raw)] == raw, f"{f.full_name}: {name}"
                if words(row["Bytes"]) not in ("rest", "depends"):
                    assert evaluate(words(row["Bytes"]), names) == len(raw), f"{f.full_name}: {name}"
                unseen.discard(name)
            if not unseen:
                break
        assert not unseen, f.full_name


def documented_lengths(manual: Manual, f: m.Field, values: dict[str, Any], filler: Filler) -> set[int]:
    """The field lengths that the section states; for a command, the length of its shortest form is checked here."""
    section = manual.field(f)
    if f.family == "protocol":
        return {f.max_size + 2}
    if f.role != m.COMMAND:
        (text,) = re.findall(r"(?:^|\. )Field length: (.*?)\.(?: |$)", words(section), re.M)
        return lengths(text.replace(" with all optional parameters", ""), filler.counts)
    rows = table_with(section, "Send", "Field length")
    function = values.get("function")
    ((call, row),) = (
        (c, row) for c, row in zip(f.calls, rows, strict=True) if not c.function or c.function.value == function
    )
    needed = ["function", *(p.name for p in call.required)]
    short = codec.encode(f, {k: v for k, v in values.items() if k in needed})
    assert len(short) + 2 in lengths(words(row["Field length"]), filler.counts), f.full_name
    return {len(codec.encode(f, values)) + 2}
