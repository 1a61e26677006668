"""Compares the specification, field by field, with the layouts of another source.

The facts are not part of the project. They are two files in one folder: `layouts.yaml`, which gives layouts
by set and descriptor, and `names.yaml`, which gives the other source's names of fields. Names of parameters,
values and bits may differ; everything that determines what bytes mean is compared: types, order, counts,
functions, values, bits, units, frames, ranges, defaults, valid flags, and responses. What the facts call
uncertain must be uncertain in the specification too.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from mipgen import model as m
from mipgen.read.nodes import Node, read
from mipgen.read.problems import Problems

from .manuals import Finding

LAYOUTS, NAMES = "layouts.yaml", "names.yaml"

#: Facts about all layouts of one revision, which `witnesses` compares.
WITNESS = "witness.yaml"

#: A parameter on the wire: the name of a scalar, and how many. A vector is its number of scalars.
Wire = tuple[str, int | str | None]

#: Bits of a bitfield: the first and the last of each entry.
Spans = frozenset[tuple[int, int]]


def audit(model: m.Model, folder: Path) -> list[Finding]:
    """All differences. Raises SpecError where a file cannot be read. Without both files there is nothing to compare
    if the folder has a witness instead."""
    if (folder / WITNESS).is_file() and not any((folder / name).exists() for name in (LAYOUTS, NAMES)):
        return []
    problems = Problems()
    layouts, names = (read(folder / name, name, problems) for name in (LAYOUTS, NAMES))
    problems.raise_if_any()
    assert layouts is not None and names is not None
    findings = [*_Layouts(model, layouts).findings(), *_names(model, layouts, names)]
    return sorted(set(findings))


def _finding(place: m.Position, message: str) -> Finding:
    return Finding(place.file, place.line, message)


def _key(number: int, descriptor: int) -> str:
    return f"(0x{number:02X},0x{descriptor:02X})"


def _fields(model: m.Model, number: int, descriptor: int, role: str) -> list[m.Field]:
    of = model.set(number)
    return [f for f in model.fields_in(of) if (f.descriptor, f.role) == (descriptor, role)] if of else []


def _family(layouts: Node) -> dict[int, list[int]]:
    """The sets that each set of the facts applies to: itself, and those that repeat it."""
    sets: dict[int, list[int]] = {}
    for node in layouts.get("vendor_sets") or ():
        origin = node.scalar("repeats", node["set"].value)
        sets.setdefault(origin, []).append(node["set"].value)
    return sets


# --------------------------------------------------------------------------- names


def _names(model: m.Model, layouts: Node, names: Node) -> Iterator[Finding]:
    """Each name leads to one field, the one with its descriptor."""
    family = _family(layouts)
    for key, entry in names.items():
        first, second, role = (x.strip() for x in key.split(","))
        for name in entry if isinstance(entry.value, list) else [entry]:
            wanted = f"{name.value}_response" if role == m.RESPONSE else name.value
            for number in family.get(int(first, 16), [int(first, 16)]):
                of = model.set(number)
                called = [f for f in model.fields_in(of) if wanted in (f.name, *f.also)] if of else []
                if [(f.descriptor, f.role) for f in called] != [(int(second, 16), role)]:
                    leads = ", ".join(f.full_name for f in called) or "no field"
                    yield _finding(name.position, f"{_key(number, int(second, 16))}: '{wanted}' leads to {leads}")


# --------------------------------------------------------------------------- layouts


@dataclass
class _Layouts:
    model: m.Model
    root: Node
    above: bool = False  # of the layout at hand: is 0 itself out of range?
    functions: bool = False  # does it begin with a function selector?

    def findings(self) -> Iterator[Finding]:
        family = _family(self.root)
        for node in self.root.get("vendor_sets") or ():
            if self.model.set(node["set"].value) is None:
                yield _finding(node.position, f"there is no set 0x{node['set'].value:02X}")
        for symbol in (self.root.get("new_units") or Node({}, self.root.position)).value:
            if symbol not in [u.symbol for u in self.model.protocol.units]:
                yield _finding(self.root["new_units"].position, f"there is no unit {symbol}")
        for of in self.root["sets"]:
            known = {(n["descriptor"].value, n["role"].value): n for n in of["layouts"]}
            for number in family.get(of["set"].value, [of["set"].value]):
                for node in of["layouts"]:
                    yield from self.layout(number, node, known)
        yield from self.named()

    def layout(self, number: int, node: Node, known: dict[tuple[int, str], Node]) -> Iterator[Finding]:
        descriptor, role = node["descriptor"].value, node["role"].value
        fields = _fields(self.model, number, descriptor, role)
        if not fields:
            yield _finding(node.position, f"{_key(number, descriptor)}: 0 fields have the role {role}")
            return
        asked = known[node["of"].value, m.COMMAND] if node["parameters"].value == "as_command" else node
        compared = [(f, [*self.about(f, node), *self.parameters(f, asked)]) for f in fields]
        f, messages = min(compared, key=lambda x: len(x[1]))  # of several layouts the one that comes nearest
        erratum = self.erratum(f)
        if erratum is not None and not messages:
            messages = [f"no difference, but the erratum '{erratum}' tells of one"]
        elif erratum is not None:
            messages = []
        for message in messages:
            yield _finding(node.position, f"{_key(number, descriptor)} {f.name_in(number)}: {message}")

    def erratum(self, f: m.Field) -> str | None:
        """The erratum that says that the other source has a wrong layout."""
        source = self.root["source"].value
        sections = {s.section for s in f.sources if s.manual == source}
        wrong = (e for e in self.model.errata if e.manual == source and e.severity == "wire")
        return next((e.id for e in wrong if e.section in sections), None)

    def about(self, f: m.Field, node: Node) -> Iterator[str]:
        """What differs besides the parameters."""
        answers = {r.descriptor for r in self.model.responses(f)}
        wanted = {node["response"].value} if "response" in node else set()
        if f.role == m.COMMAND and answers != wanted:
            yield f"responses {_hex(answers)}, not {_hex(wanted)}"
        if "of" in node and self.owner(f) != node["of"].value:
            yield f"answers 0x{self.owner(f):02X}, not 0x{node['of'].value:02X}"
        # `apply without acknowledge` is not known to the other source
        functions = {x.letter for x in f.functions} - {"A"}
        if functions != set(node.scalar("functions", "")):
            yield f"functions {''.join(sorted(functions))}, not {''.join(sorted(node.scalar('functions', '')))}"
        if bool(f.deprecated) != node.scalar("deprecated", False):
            yield f"deprecated: {bool(f.deprecated)}"
        if "uncertain" in node and not self.uncertain(f):
            yield "nothing of it is uncertain"

    def parameters(self, f: m.Field, node: Node) -> Iterator[str]:
        """What differs in the parameters; `node` is that of the command where a response repeats them."""
        self.above = any("greater than 0" in fact.value for fact in node.get("facts") or ())
        self.functions = f.role == m.COMMAND and bool(f.functions)
        yield from self.record(f.counted, list(node["parameters"]))

    def owner(self, f: m.Field) -> int:
        """The descriptor of the command that a response answers."""
        return next((c.descriptor for c in self.model.commands(f) if c.name == f.command), 0)

    def uncertain(self, f: m.Field) -> bool:
        """Is anything about a field, its responses or its types uncertain?"""
        every = (f, *self.model.responses(f))
        return any(_doubts(p) for x in every for p in x.parameters) or any(x.uncertain for x in every)

    def record(self, ours: tuple[m.Parameter, ...], given: list[Node], inside: str = "") -> Iterator[str]:
        ours, given = _without_reserved(ours, given)
        if len(ours) != len(given):
            yield f"{inside or 'it'} has {len(ours)} parameters, not {len(given)}"
            return
        mine, theirs = [p.name for p in ours], [n["name"].value for n in given]
        for p, node in zip(ours, given, strict=True):
            name = f"{inside}.{p.name}" if inside else p.name
            bounds = _given_range(node, self.above)
            for what, own, other in (
                ("type", wire(p, mine), _given_wire(node, theirs)),
                ("for", _letters(p), node.scalar("for", "") if self.functions and not inside else ""),
                ("unit", {*p.units} - {"1"}, {node.scalar("unit")} - {None, "1"}),
                ("frame", p.frame, node.scalar("frame")),
                ("range", _range(p, bounds), bounds),
                ("default", p.default, node.scalar("default")),
                ("reserved", p.reserved, node.scalar("reserved")),
                ("valid", _valid(p, ours), _given_valid(node, given)),
                ("values", _values(p.element), _given_values(node)),
                ("bits", _bits(p.element), _given_bits(node)),
            ):
                if own != other and not _ahead(own, other):
                    yield f"{name}: {what} {shown(own)}, not {shown(other)}"
            if "alternative" in node and not self.has_bits(_given_bits(node["alternative"])):
                yield f"{name}: no type has the bits of {node['alternative']['bitfield'].value}"
            # the facts may name a fitting type of the specification
            if isinstance(p.element, m.Struct) and node.scalar("spec_type") != p.element.name:
                yield from self.record(p.element.parameters, self.members(node), name)

    def members(self, node: Node) -> list[Node]:
        """Those of a structure, from its first occurrence: later ones may have fewer facts."""
        name = node["struct"].value
        everywhere = (p for s in self.root["sets"] for x in s["layouts"] for p in _listed(x))
        return next(list(p["members"]) for p in everywhere if p.scalar("struct") == name)

    def has_bits(self, bits: Spans) -> bool:
        return any(_bits(t) == bits for t in self.model.all_types)

    def named(self) -> Iterator[Finding]:
        """A descriptor that has only a name is listed, or defined after all."""
        family = _family(self.root)
        for number, roles in (self.root.get("named_only") or Node({}, self.root.position)).items():
            for role, entries in roles.items():
                for descriptor in entries.value:
                    for one in family.get(int(number, 16), [int(number, 16)]):
                        of = self.model.set(one)
                        listed: set[tuple[str, int]] = set()
                        if of is not None:
                            known = self.model.family(of.family)
                            named = known.named if known else ()
                            listed = {(x.role, x.descriptor) for x in named}
                            listed |= {(f.role, f.descriptor) for f in self.model.fields_in(of)}
                        if (role, int(descriptor, 16)) not in listed:
                            place = entries.keys[descriptor]
                            yield _finding(place, f"{_key(one, int(descriptor, 16))} is no {role}, not even by name")


def _without_reserved(ours: tuple[m.Parameter, ...], given: list[Node]) -> tuple[tuple[m.Parameter, ...], list[Node]]:
    """Both without bytes that the other source reserves and the specification, which may be ahead, has values in."""
    for at, node in enumerate(given):
        count = node.scalar("count")
        if "reserved" not in node or node.scalar("type") != "u8" or not isinstance(count, int):
            continue
        for end in range(at + 2, len(ours) + 1):
            inside = ours[at:end]
            sizes = [p.size * (p.length or 1) for p in inside if p.kind != "switch" and not isinstance(p.length, str)]
            if len(sizes) == len(inside) and sum(sizes) == count:
                return ours[:at] + ours[end:], given[:at] + given[at + 1 :]
    return ours, given


def _ahead(own: object, other: object) -> bool:
    """Are these bits, and does the specification have those of the other source beside others of a later revision?"""
    if not isinstance(own, frozenset) or not isinstance(other, frozenset):
        return False
    spans = [x for x in other if isinstance(x, tuple)]
    covering = {s for s in spans for t in spans if s != t and s[0] <= t[0] and t[1] <= s[1]}  # it grows with its bits
    return bool(spans) and own > other - covering


def _listed(layout: Node) -> list[Node]:
    parameters = layout["parameters"]
    return [] if parameters.value == "as_command" else list(parameters)


def _hex(numbers: set[int]) -> str:
    return ", ".join(f"0x{n:02X}" for n in sorted(numbers)) or "none"


def _doubts(p: m.Parameter) -> bool:
    t = p.element
    if p.uncertain or (t is not None and not isinstance(t, m.Scalar) and t.uncertain):
        return True
    match t:
        case m.Struct():
            return any(map(_doubts, t.parameters))
        case m.Enum():
            return any(v.uncertain for v in t.values)
        case m.Bitfield():
            return any(b.uncertain for b in t.bits)
    return False


# --------------------------------------------------------------------------- one parameter


def shown(value: Any) -> str:
    if isinstance(value, (set, frozenset)):
        return ", ".join(map(shown, sorted(value))) or "none"
    if isinstance(value, tuple):
        first, second = value
        if isinstance(first, int):
            return str(first) if first == second else f"{first}-{second}"
        return f"{second} {first}" if isinstance(second, int) else f"{first} {second or ''}".strip()
    return "none" if value in (None, "") else str(value)


def wire(p: m.Parameter, names: list[str]) -> Wire:
    length: int | str | None = p.length
    if isinstance(length, str) and length in names:
        length = f"counted by parameter {names.index(length) + 1}"
    match p.element:
        case m.Vector():
            assert not isinstance(length, str)
            return p.element.scalar.name, len(p.element.elements) * (length or 1)
        case m.Struct():
            return "struct", length
        case m.Bitfield() if p.element.scalar is None:
            return f"{p.element.size} bytes", length
        case m.Enum() | m.Bitfield():
            assert p.element.scalar is not None
            return p.element.scalar.name, length
        case m.Scalar():
            return p.element.name, length
    return "union", None


def _given_wire(node: Node, names: list[str]) -> Wire:
    length = node.scalar("count")
    if isinstance(length, str) and length in names:
        length = f"counted by parameter {names.index(length) + 1}"
    if "struct" in node:
        return "struct", length
    kind = node["type"].value
    vector = re.fullmatch(r"(?:vector(\d)|matrix(3)|quat)([fd])", kind)
    if vector is None:
        return kind, length
    count = int(vector[1]) if vector[1] else 9 if vector[2] else 4
    return {"f": "float", "d": "double"}[vector[3]], count * (length or 1)


def _letters(p: m.Parameter) -> str:
    return m.letters(p.required_for).replace("A", "")


def _range(p: m.Parameter, given: str) -> str:
    """The bounds, apart from those that the type or the room in a field gives.

    Where the length of a vector is limited, the source may give that limit for each element, or none.
    """
    if p.frame == "llh" and not given:  # latitudes and longitudes have limits of their own
        return given
    if p.magnitude[1] is not None and given in ("", f">= {-p.magnitude[1]} <= {p.magnitude[1]}"):
        return given
    low = f"> {p.above}" if p.above is not None else f">= {p.minimum}" if p.minimum is not None else ""
    high = f"< {p.below}" if p.below is not None else f"<= {p.maximum}" if p.maximum is not None else ""
    return f"{low} {high}".strip()


def _given_range(node: Node, above: bool) -> str:
    if "range" not in node:
        return ""
    low, high = node["range"].plain()
    least = "" if low is None else "> 0" if above and low == 0 and high is None else f">= {low}"
    return f"{least} {'' if high is None else f'<= {high}'}".strip()


def _valid(p: m.Parameter, record: tuple[m.Parameter, ...]) -> str:
    places = []
    for path in p.valid:
        flags, _, bit = path.partition(".")
        index = next(i for i, q in enumerate(record, 1) if q.name == flags)
        element = record[index - 1].element
        bits = {b.name: b.first for b in element.bits} if isinstance(element, m.Bitfield) else {}
        places.append(f"parameter {index}" + (f", bit {bits[bit]}" if bit in bits else ""))
    return "; ".join(places)


def _given_valid(node: Node, record: list[Node]) -> str:
    if "valid" not in node:
        return ""
    flags, _, bit = node["valid"].value.partition(".")
    index = next(i for i, n in enumerate(record, 1) if n["name"].value == flags)
    bits = record[index - 1].get("bits")
    place = _span(bits[bit])[0] if bits is not None and bit in bits else None
    return f"parameter {index}" + (f", bit {place}" if place is not None else "")


def _values(t: m.Scalar | m.Type | None) -> frozenset[int]:
    return frozenset(v.value for v in t.values) if isinstance(t, m.Enum) else frozenset()


def _given_values(node: Node) -> frozenset[int]:
    values = node["values"].value.values() if "values" in node else ()
    return frozenset(v["value"].value if isinstance(v.value, dict) else v.value for v in values)


def _bits(t: m.Scalar | m.Type | None) -> Spans:
    return frozenset((b.first, b.last) for b in t.bits) if isinstance(t, m.Bitfield) else frozenset()


def _given_bits(node: Node) -> Spans:
    """Without reserved bits, which specifications do not list."""
    bits = node["bits"].items() if "bits" in node else ()
    return frozenset(_span(entry) for name, entry in bits if name != "reserved")


def _span(entry: Node) -> tuple[int, int]:
    span = entry.scalar("bits", entry.scalar("bit")) if isinstance(entry.value, dict) else entry.value
    first, _, last = str(span).partition("-")
    return int(first), int(last or first)
