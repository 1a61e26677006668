"""Examples and errata: the packets in the manuals, and their mistakes."""

from __future__ import annotations

import math
import re
import struct
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

from mipgen import model as m
from mipgen.facts import literals
from mipgen.lower import codec
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, elsewhere, nearest

from . import meaning
from .vocabulary import texts_of_node

#: Bytes as in the manual; None for an unspecified byte.
Octets = tuple[int | None, ...]

_CODE = re.compile(r"`([^`]+)`")

#: The role of a packet by the role of its fields.
ROLES: dict[m.Role, Literal["command", "reply", "data"]] = {m.COMMAND: "command", m.RESPONSE: "reply", m.DATA: "data"}

#: The keys of errata: mistakes that lead to wrong bytes, or to a wrong unit, name or value.
SEVERITIES: tuple[Literal["wire", "meaning"], ...] = ("wire", "meaning")


def examples(roots: Iterable[Node], model: m.Model, problems: Problems) -> tuple[m.Example, ...]:
    examples: dict[str, m.Example] = {}
    for root in roots:
        for node in _examples(root["examples"]):
            name = node["id"].value
            if name in examples:
                where = elsewhere(examples[name])
                problems.add(node["id"].position, f"two examples are called '{name}', {where}; rename one")
                continue
            example = _Example(node, model, problems).resolve()
            if example is not None:
                examples[name] = example
    return tuple(examples.values())


def _examples(by_manual: Node) -> Iterator[Node]:
    """Yields each example, with its manual and section."""
    for manual, sections in by_manual.items():
        for section, nodes in sections.items():
            yield from _cited(nodes, manual=_key(by_manual, manual), section=_key(sections, section))


def _errata(by_manual: Node) -> Iterator[Node]:
    """Yields each erratum, with its manual."""
    for manual, nodes in by_manual.items():
        yield from _cited(nodes, manual=_key(by_manual, manual))


def _cited(nodes: Node, **cited: Node) -> Iterator[Node]:
    return (Node({**cited, **node.value}, node.position, node.keys) for node in nodes)


def _key(mapping: Node, key: str) -> Node:
    return Node(key, mapping.keys[key])


class Wrong(Exception):
    """An example, or a step of a guide, that cannot be resolved: the position and the reason."""

    def __init__(self, place: m.Position, message: str) -> None:
        super().__init__(message)
        self.place = place


@dataclass
class _Example:
    node: Node
    model: m.Model
    problems: Problems
    role: Literal["command", "reply", "data"] | None = None  # that of its fields, once one is known

    def resolve(self) -> m.Example | None:
        node = self.node
        manuals = {x.id: x for x in self.model.protocol.manuals}
        manual, section = meaning.resolve_citation(node, manuals, self.problems.add)
        printed = node.scalar("string")
        try:
            table = self.octets("table")
            packet = self.packet(table)
            fields = self.fields(packet)
        except Wrong as wrong:
            self.problems.add(wrong.place, str(wrong))
            return None
        return m.Example(
            id=node["id"].value,
            manual=manual,
            section=section,
            title=node["title"].value,
            role="field" if "bytes" in node else self.role or ("data" if packet[2] >= 0x80 else "command"),
            string=printed,
            table=table,
            packet=packet,
            fields=fields,
            note=" ".join(texts_of_node(node, "notes")),
            device=self.device(manual),
            synthetic=printed is None and table is None,
            position=node["id"].position,
        )

    def device(self, manual: str) -> m.Device | None:
        """Returns the device that the example names, else the manual's only device."""
        named = self.node.get("device")
        if named is None:
            devices = [d for d in self.model.devices if d.manual == manual]
            return devices[0] if len(devices) == 1 else None
        device = self.model.device(named.value)
        if device is None:
            near = nearest(named.value, [d.id for d in self.model.devices])
            self.problems.add(named.position, f"unknown device '{named.value}'{near}")
        return device

    # ----------------------------------------------------------------------- bytes

    def octets(self, key: str) -> Octets | None:
        """Returns the bytes at a key; None for an unspecified byte."""
        text = self.node.scalar(key)
        if text is None:
            return None
        digits = "".join(text.split())
        if len(digits) % 2 or not digits:
            what = "is empty" if not digits else f"has an odd number of digits, {len(digits)}"
            raise Wrong(self.node[key].position, f"'{key}' {what}; give two digits for each byte")
        pairs = [digits[i : i + 2] for i in range(0, len(digits), 2)]
        return tuple(None if "?" in p else int(p, 16) for p in pairs)

    def packet(self, table: Octets | None) -> bytes:
        """Returns the correct bytes: given, from the manual, or computed from the fields."""
        keys = [k for k in ("packet", "bytes", "string", "table") if k in self.node]
        # A string with half a byte cannot be right; `checks.printed_bytes` requires an erratum for it.
        keys = [k for k in keys if k != "string" or _digits(self.node[k].value) % 2 == 0]
        if not keys and "string" in self.node and "set" not in self.node:
            raise Wrong(
                self.node["string"].position,
                "'string' has half a byte; if the manual shows it this way, give the correct bytes in 'packet'",
            )
        if not keys:
            return self.computed()
        place = self.node[keys[0]].position
        octets = table if keys[0] == "table" else self.octets(keys[0])
        assert octets is not None
        if "bytes" in self.node:
            field = _as_field(_complete(octets, place), place)
            return built(self.model, self.number("an example of one field"), [field], place)
        if octets[-2:] == (None, None):
            head = _complete(octets[:-2], place)
            packet = head + codec.checksum(head)
        else:
            packet = _complete(octets, place)
        if "set" in self.node and packet[2:3] != bytes([self.node["set"].value]):
            raise Wrong(self.node["set"].position, f"the packet is of the set 0x{packet[2:3].hex().upper()}")
        return packet

    def number(self, what: str) -> int:
        """Returns the descriptor set that an example without a packet must name."""
        if "set" not in self.node:
            raise Wrong(self.node["id"].position, f"{what} needs 'set', the number of its descriptor set")
        number: int = self.node["set"].value
        return number

    def computed(self) -> bytes:
        number = self.number("an example without bytes")
        if not self.node.scalar("fields"):
            raise Wrong(self.node["id"].position, "an example without bytes needs 'fields' with all values")
        parts = []
        for entry in self.node["fields"]:
            name, values = self.entry(entry)
            if name is None:
                parts.append(self.raw(values))
                continue
            field = field_named(self.model, name, entry.position)
            stated = stated_values(field, values)
            try:
                data = codec.encode(field, with_counters(field, stated))
            except codec.CodecError as error:
                raise Wrong(values.position, f"'{name}' cannot be encoded: {error}") from error
            parts.append((field.descriptor, data))
        return built(self.model, number, parts, self.node.keys["fields"])

    # ----------------------------------------------------------------------- fields

    def entry(self, node: Node) -> tuple[str | None, Node]:
        """Returns the name of a field of the example and its stated values; the name is None for raw bytes."""
        if isinstance(node.value, str):
            return node.value, Node({}, node.position)
        if not node.value:
            raise Wrong(
                node.position, "this entry is empty; write a field's name, its name and values, or raw and its bytes"
            )
        name, values = next(node.items())
        if name == "raw":
            return None, values
        return name, values if values.value is not None else Node({}, values.position)

    def raw(self, node: Node) -> tuple[int, bytes]:
        try:
            data = bytes.fromhex(node.value)
        except (TypeError, ValueError):
            raise Wrong(node.position, "raw must be bytes in hexadecimal, in quotes") from None
        return _as_field(data, node.position)

    def fields(self, packet: bytes) -> tuple[m.ExampleField, ...]:
        whole = next((self.node[k].position for k in ("packet", "bytes", "string", "table") if k in self.node), None)
        place = whole or self.node["id"].position
        try:
            split = codec.split(self.model, packet)
        except codec.CodecError as error:
            printed = (
                "" if "packet" in self.node else "; if the manual shows it this way, give the correct bytes in 'packet'"
            )
            raise Wrong(place, f"this is not a packet: {error}{printed}") from error
        stated = list(self.node.get("fields") or ())
        if stated and len(stated) != len(split):
            contained, listed = (f"{n} field{'s' if n != 1 else ''}" for n in (len(split), len(stated)))
            raise Wrong(self.node.keys["fields"], f"{listed} listed, but the packet contains {contained}")
        fields = []
        for i, (descriptor, data) in enumerate(split):
            field = codec.choose(self.model.candidates(packet[2], descriptor), data)
            says = self.stated(stated[i], field, packet[2], descriptor, data) if stated else None
            if field is None:
                fields.append(m.ExampleField(None, descriptor, data, None, 0, None))
                continue
            self.check_role(field, stated[i].position if stated else place)
            values, trailing = self.decoded(field, data, stated[i].position if stated else place)
            if says:
                self.compare(field, values, says, stated[i])
            fields.append(m.ExampleField(field.name_in(packet[2]), descriptor, data, values, trailing, says))
        return tuple(fields)

    def decoded(self, field: m.Field, data: bytes, place: m.Position) -> tuple[codec.Values, int]:
        try:
            values, trailing = codec.decode(field, data)
            again = codec.encode(field, values) + data[len(data) - trailing :]
        except codec.CodecError as error:
            raise Wrong(place, f"'{field.full_name}' does not decode: {error}") from error
        if again != data:
            raise Wrong(place, f"'{field.full_name}' does not encode to its own bytes, but to {again.hex(' ')}")
        return values, trailing

    def check_role(self, field: m.Field, place: m.Position) -> None:
        role = ROLES[field.role]
        if self.role not in (None, role):
            message = (
                f"'{field.full_name}' occurs in packets of the role {role}, but the field before it in those of "
                f"the role {self.role}"
            )
            raise Wrong(place, message)
        self.role = role

    def stated(
        self, node: Node, field: m.Field | None, number: int, descriptor: int, data: bytes
    ) -> codec.Values | None:
        name, values = self.entry(node)
        if name is None:
            if self.raw(values) != (descriptor, data):
                holds = bytes((len(data) + 2, descriptor)) + data
                raise Wrong(values.position, f"the packet contains {holds.hex(' ').upper()} here")
            return None
        named = field_named(self.model, name, node.position)
        if field is None or name not in (field.name_in(number), field.full_name):
            content = f"'{field.name_in(number)}'" if field else f"the unknown descriptor 0x{descriptor:02X}"
            raise Wrong(node.position, f"'{name}' is listed, but the packet contains {content}")
        return stated_values(named, values)

    def compare(self, field: m.Field, values: codec.Values, stated: codec.Values, node: Node) -> None:
        for name, value in stated.items():
            if values.get(name) != value:
                actual, wanted = readable(values.get(name)), readable(value)
                message = f"{field.full_name}.{name} is {actual} in the bytes, but {wanted} is stated"
                raise Wrong(node.value_at([*node.value, name] if isinstance(node.value, dict) else []), message)


def readable(value: object) -> str:
    """Writes a value for readers: floats, which are the text of their bits, also as numbers.

    >>> readable("0x41accccd"), readable("0x7fc00000"), readable([1, {"x": "0x41ac0000"}]), readable("text")
    ("21.6 ('0x41accccd')", "'0x7fc00000'", "[1, {'x': 21.5 ('0x41ac0000')}]", "'text'")
    """
    if isinstance(value, list):
        return f"[{', '.join(map(readable, value))}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{name!r}: {readable(inner)}' for name, inner in value.items())}}}"
    if isinstance(value, str) and re.fullmatch("0x([0-9a-f]{8}|[0-9a-f]{16})", value):
        raw = bytes.fromhex(value[2:])
        if math.isfinite(struct.unpack(">f" if len(raw) == 4 else ">d", raw)[0]):
            return f"{literals.decimal(value)} ({value!r})"
    return repr(value)


def built(model: m.Model, number: int, parts: list[tuple[int, bytes]], place: m.Position) -> bytes:
    try:
        return codec.build(model, number, parts)
    except codec.CodecError as error:
        raise Wrong(place, f"the fields do not make a packet: {error}") from error


def field_named(model: m.Model, name: str, place: m.Position) -> m.Field:
    """Finds the field with this name; raises Wrong."""
    field = model.field(name)
    if field is None:
        names = [f.full_name for f in model.fields] + [model.protocol.acknowledge.full_name]
        raise Wrong(place, f"unknown field '{name}'{nearest(name, names)}")
    return field


def stated_values(field: m.Field, node: Node) -> codec.Values:
    """Converts the stated values to the form of the conformance protocol."""
    values = node.plain()
    if isinstance(values, dict):
        # Constants may be stated for readability, but they are not values.
        for p in field.parameters:
            if p.constant is not None and values.pop(p.name, p.constant) != p.constant:
                raise Wrong(node.value_at([p.name]), f"{field.full_name}.{p.name} is always {p.constant}")
    try:
        return codec.canonical_record(field.parameters, values, field.full_name)
    except ValueError as error:
        raise Wrong(node.position, str(error)) from error


def _digits(text: str) -> int:
    return len("".join(text.split()))


def _complete(octets: Octets, place: m.Position) -> bytes:
    """Returns the bytes if all are specified; else raises Wrong."""
    if None in octets:
        raise Wrong(place, "the manual does not specify all bytes; add 'packet' with all bytes except the checksum")
    return bytes(x or 0 for x in octets)


def _as_field(data: bytes, place: m.Position) -> tuple[int, bytes]:
    if len(data) < 2 or data[0] != len(data):
        raise Wrong(place, f"{data.hex(' ')} is not a field: its first byte must be its length, {len(data)}")
    return data[1], data[2:]


def with_counters(field: m.Field, values: codec.Values) -> codec.Values:
    """Adds counters that the author omitted."""
    counters = codec.counters(field.parameters, values)
    return values | {name: count for name, count in counters.items() if name not in values}


# --------------------------------------------------------------------------- errata


def errata(roots: Iterable[Node], manuals: Mapping[str, m.Manual], problems: Problems) -> tuple[m.Erratum, ...]:
    errata: dict[str, m.Erratum] = {}
    for severity, node in ((key, n) for root in roots for key in SEVERITIES if key in root for n in _errata(root[key])):
        name = node["id"].value
        manual, section = meaning.resolve_citation(node, manuals, problems.add)
        if name in errata:
            where = elsewhere(errata[name])
            problems.add(node["id"].position, f"two errata are called '{name}', {where}; rename one")
        errata[name] = m.Erratum(
            id=name,
            manual=manual,
            section=section,
            severity=severity,
            printed=node["printed"].value,
            right=node["right"].value,
            reason=node["reason"].value,
            claims=_claims(node),
            named=tuple(dict.fromkeys(_CODE.findall(f"{node['right'].value}\n{node['reason'].value}"))),
            position=node["id"].position,
        )
    return tuple(sorted(errata.values(), key=lambda e: e.id))


def _claims(node: Node) -> tuple[m.Claim, ...]:
    claims = []
    for entry in node.get("claims") or ():
        for kind, subject in entry.items():
            claims.append(m.Claim(kind, subject.value, subject.position))  # type: ignore[arg-type]
    return tuple(claims)
