"""Compares the specification with every layout of one revision of the vendor's SDK, and names what is missing.

The facts are no part of the project. They are one file, `witness.yaml`, that a program extracts from any revision:
layouts with their parameters in wire order, enumerations, bitfields, structures, and descriptors without a layout. Only
what decides the bytes is compared: a specification may name more values, bits and functions than the SDK.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from mipgen import model as m
from mipgen.read.nodes import Node, read
from mipgen.read.problems import Problems

from .manuals import Finding
from .sdk import Wire, shown, wire

WITNESS = "witness.yaml"


def audit(model: m.Model, folder: Path) -> list[Finding]:
    """What the revision has and the specification lacks, by line. Raises SpecError where the file cannot be read."""
    if not (folder / WITNESS).is_file():
        return []
    problems = Problems()
    root = read(folder / WITNESS, WITNESS, problems)
    problems.raise_if_any()
    assert root is not None
    return sorted(set(_Witness(model, root).findings()))


@dataclass
class _Witness:
    model: m.Model
    root: Node

    def findings(self) -> Iterator[Finding]:
        for node in self.root["layouts"]:
            for number, descriptor in self.places(node["key"].value):
                for message in self.layout(number, descriptor, node):
                    yield self.finding(node.position, number, descriptor, message)
        for key, name in self.entries("named"):
            for number, descriptor in self.places(key):
                if not self.is_named(number, descriptor):
                    yield self.finding(name.position, number, descriptor, f"not listed, not even as {name.value}")

    def finding(self, place: m.Position, number: int, descriptor: int, message: str) -> Finding:
        return Finding(place.file, place.line, f"(0x{number:02X},0x{descriptor:02X}): {message}")

    def places(self, key: str) -> list[tuple[int, int]]:
        """A descriptor in the set of a key, and in the sets with the same layouts."""
        first, second = (int(x, 16) for x in key.split(","))
        same = {int(name, 16): others for name, others in self.entries("same_layouts")}
        others = [int(n.value, 16) for n in same.get(first, ())]
        return [(number, second) for number in (first, *others)]

    def entries(self, key: str) -> Iterator[tuple[str, Node]]:
        if key in self.root:
            yield from self.root[key].items()

    def fields(self, number: int, descriptor: int) -> list[m.Field]:
        of = self.model.set(number)
        return [f for f in self.model.fields_in(of) if f.descriptor == descriptor] if of else []

    def is_named(self, number: int, descriptor: int) -> bool:
        of = self.model.set(number)
        family = self.model.family(of.family) if of else None
        known = family is not None and descriptor in {x.descriptor for x in family.named}
        return known or bool(self.fields(number, descriptor))

    # ----------------------------------------------------------------------- layouts

    def layout(self, number: int, descriptor: int, node: Node) -> list[str]:
        """What differs from the layout that comes nearest."""
        role, given = node["role"].value, list(node["parameters"])
        fields = [f for f in self.fields(number, descriptor) if f.role == role]
        if not fields:
            listed = ", ".join(self.spelt(p) for p in given) or "no parameters"
            return [f"the {role} {node['name'].value} is missing: {listed}"]
        return min(([*self.about(f, node), *self.record(f.counted, given)] for f in fields), key=len)

    def about(self, f: m.Field, node: Node) -> Iterator[str]:
        functions = set(node.scalar("functions", "")) - {x.letter for x in f.functions}
        if functions:
            yield f"{f.name} lacks the functions {''.join(sorted(functions))}"
        answers = {r.descriptor for r in self.model.responses(f)}
        if "response" in node and int(node["response"].value, 16) not in answers:
            yield f"{f.name} lacks the response {node['response'].value}"

    def record(self, ours: tuple[m.Parameter, ...], given: list[Node], inside: str = "") -> Iterator[str]:
        mine, theirs = [p.name for p in ours], [n["name"].value for n in given]
        for p, node in zip(ours, given, strict=False):
            name = f"{inside}{p.name}"
            own, other = wire(p, mine), _wire(node, theirs)
            if p.union and own != other and _same_cases(p, [_wire(n, theirs) for n in given[len(mine) - 1 :]]):
                return  # the SDK has one structure with names for all cases
            if _bytes(own) != _bytes(other):
                yield f"{name} is {shown(own)}, not {shown(other)}"
                continue
            yield from self.details(p, node, name)
        for node in given[len(ours) :]:
            yield f"{inside.rstrip('.') or 'the field'} lacks {self.spelt(node)}"
        for p in ours[len(given) :]:
            yield f"{inside}{p.name} is not in the SDK"

    def details(self, p: m.Parameter, node: Node, name: str) -> Iterator[str]:
        """Values, bits, members and cases."""
        match p.element:
            case m.Enum():
                known = {v.value for v in p.element.values}
                yield from (f"{name} lacks the value {v} ({k})" for k, v in self.values(node) if v not in known)
            case m.Bitfield():
                taken = {at for b in p.element.bits for at in range(b.first, b.last + 1)}
                for bit, first, width in self.bits(node):
                    if not taken.issuperset(range(first, first + width)):
                        yield f"{name} lacks the bits {first} to {first + width - 1} ({bit})"
            case m.Struct() if "struct" in node:
                yield from self.record(
                    p.element.parameters, list(self.root["structs"][node["struct"].value]), f"{name}."
                )
        if "cases" in node:
            cases = {c.tag.value: c.parameter for c in p.cases}
            for case in node["cases"]:
                tag, number = case["when"].plain()
                inner = cases.get(number)
                if inner is None:
                    yield f"{name} lacks the case {number} ({tag})"
                elif isinstance(inner.element, m.Struct) and "struct" in case:
                    members = list(self.root["structs"][case["struct"].value])
                    yield from self.record(inner.element.parameters, members, f"{name}.{case['name'].value}.")

    def values(self, node: Node) -> list[tuple[str, int]]:
        if "enum" in node:
            node = self.root["enums"][node["enum"].value]
        return [(k, v.value) for k, v in node["values"].items()] if "values" in node else []

    def bits(self, node: Node) -> list[tuple[str, int, int]]:
        """Without those that are reserved."""
        if "bitfield" in node:
            node = self.root["bitfields"][node["bitfield"].value]
        listed = [(k, *v.plain()) for k, v in node["bits"].items()] if "bits" in node else []
        return [(k, first, width) for k, first, width in listed if "RESERVED" not in k]

    def spelt(self, node: Node) -> str:
        """A parameter as one would read it in a header, with its values or bits."""
        of = "".join(f" of {node[key].value}" for key in ("of", "struct") if key in node)
        count = node.scalar("count") or node.scalar("by")
        more = [f"{k} {v}" for k, v in self.values(node)] or [f"{k} at {at}" for k, at, _ in self.bits(node)]
        unit = f" [{node['unit'].value}]" if "unit" in node else ""
        listed = f" ({', '.join(more)})" if more else ""
        return f"{node['name'].value} {node['type'].value}{of}{f'[{count}]' if count else ''}{unit}{listed}"


def _same_cases(p: m.Parameter, given: list[Wire]) -> bool:
    """Has each case of a union, the last parameter, these numbers?"""
    inner = [c.parameter.element for c in p.cases if c.parameter is not None]
    records = [t.parameters if isinstance(t, m.Struct) else () for t in inner]
    return all([wire(q, []) for q in record] == given for record in records)


def _bytes(wire: Wire) -> Wire:
    """A boolean is a byte."""
    return ("u8" if wire[0] == "bool" else wire[0], wire[1])


def _wire(node: Node, names: list[str]) -> Wire:
    if "by" in node and node["type"].value != "union":
        return node["type"].value, f"counted by parameter {names.index(node['by'].value) + 1}"
    return node["type"].value, node.scalar("count")
