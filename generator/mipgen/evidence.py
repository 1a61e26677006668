"""Examples and errata: what the manuals print, and where they are wrong."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from . import codec
from . import model as m
from .loader import Node
from .problems import Problems, nearest


def examples(roots: Iterable[Node], model: m.Model, problems: Problems) -> tuple[m.Example, ...]:
    found: dict[str, m.Example] = {}
    for root in roots:
        for node in root["examples"]:
            name = node["id"].value
            if name in found:
                problems.add(node["id"].position, f"the example '{name}' stands twice; choose another id")
                continue
            example = _Example(node, model, problems).resolve()
            if example is not None:
                found[name] = example
    return tuple(sorted(found.values(), key=lambda e: e.id))


@dataclass
class _Example:
    node: Node
    model: m.Model
    problems: Problems

    def resolve(self) -> m.Example | None:
        node = self.node
        manuals = [x.id for x in self.model.protocol.manuals]
        manual = node["manual"].value
        if manual not in manuals:
            self.problem("manual", f"unknown manual '{manual}'{nearest(manual, manuals)}")
        printed = node.scalar("string")
        string = self.bytes("string") if printed is not None and _digits(printed) % 2 == 0 else None
        table = self.bytes("table")
        try:
            packet = self.packet(string, table)
            fields = self.fields(packet)
        except codec.CodecError as error:
            self.problem("id", f"the example '{node['id'].value}' is not right: {error}")
            return None
        except ValueError as error:
            self.problem("fields", str(error))
            return None
        return m.Example(
            id=node["id"].value, manual=manual, section=node["section"].value, title=node["title"].value,
            role=node["role"].value, string=printed, table=table,
            packet=packet, fields=fields, note=node.scalar("note", ""),
            synthetic=printed is None and table is None, position=node.position,
        )  # fmt: skip

    def problem(self, key: str, message: str) -> None:
        entry = self.node.get(key)
        self.problems.add(entry.position if entry else self.node.position, message)

    def bytes(self, key: str) -> tuple[int | None, ...] | None:
        text = self.node.scalar(key)
        if text is None:
            return None
        digits = "".join(text.split())
        if len(digits) % 2:
            raise_at = f"'{key}' has an odd number of digits"
            self.problem(key, raise_at)
            return None
        pairs = [digits[i : i + 2] for i in range(0, len(digits), 2)]
        return tuple(None if "?" in p else int(p, 16) for p in pairs)

    def packet(self, string: tuple[int | None, ...] | None, table: tuple[int | None, ...] | None) -> bytes:
        """The right bytes: given, printed, or computed from the fields."""
        given = self.bytes("packet") or self.bytes("bytes") or string or table
        if given is None:
            return self.computed()
        if self.node["role"].value == "field":
            if "set" not in self.node:
                raise ValueError("an example of one field needs 'set'")
            return codec.build(self.model, self.node["set"].value, [_as_field(given)])
        if None in given[:-2]:
            raise ValueError("the right bytes are open; give 'packet' with all bytes but the checksum")
        if None in given:
            head = bytes(x or 0 for x in given[:-2])
            return head + codec.checksum(head)
        return bytes(x or 0 for x in given)

    def computed(self) -> bytes:
        if "set" not in self.node or "fields" not in self.node:
            raise ValueError("an example without bytes needs 'set' and 'fields' with all values")
        parts = []
        for entry in self.node["fields"]:
            name, values, _ = self.entry(entry)
            if name is None:
                parts.append(_as_field(tuple(bytes.fromhex(values))))
                continue
            field = self.named(name)
            stated = codec.canonical_record(field.operations, _without_constants(field, values), name)
            parts.append((field.descriptor, codec.encode(field, _with_counters(field.operations, stated))))
        return codec.build(self.model, self.node["set"].value, parts)

    def entry(self, node: Node) -> tuple[str | None, Any, Node]:
        """The name of a field of the example and its stated values; name None: raw bytes."""
        if isinstance(node.value, str):
            return node.value, {}, node
        name, values = next(iter(node.items()))
        if name == "raw":
            return None, str(values.value), values
        return name, values.plain() or {}, values

    def named(self, name: str) -> m.Field:
        field = self.model.field(name)
        if field is None:
            known = [f.full_name for f in self.model.fields] + [self.model.protocol.acknowledge.full_name]
            raise ValueError(f"unknown field '{name}'{nearest(name, known)}")
        return field

    def fields(self, packet: bytes) -> tuple[m.ExampleField, ...]:
        split = codec.split(self.model, packet)
        stated = list(self.node.get("fields") or ())
        if stated and len(stated) != len(split):
            raise ValueError(f"{len(stated)} fields are listed, but the packet holds {len(split)}")
        found = []
        for i, (descriptor, data) in enumerate(split):
            field = codec.choose(self.model.candidates(packet[2], descriptor), data)
            says = self.stated(stated[i], field, descriptor, data) if stated else None
            if field is None:
                found.append(m.ExampleField(None, descriptor, data, None, 0, None))
                continue
            values, trailing = codec.decode(field, data)
            if codec.encode(field, values) + data[len(data) - trailing :] != data:
                raise codec.CodecError("bytes", f"{field.full_name} does not encode to its own bytes")
            self.compare(field, values, says or {})
            found.append(m.ExampleField(field.full_name, descriptor, data, values, trailing, says))
        return tuple(found)

    def stated(self, node: Node, field: m.Field | None, descriptor: int, data: bytes) -> dict[str, object] | None:
        name, values, place = self.entry(node)
        if name is None:
            if _as_field(tuple(bytes.fromhex(values))) != (descriptor, data):
                raise ValueError(f"raw: the packet holds {len(data) + 2:02X} {descriptor:02X} {data.hex(' ').upper()}")
            return None
        named = self.named(name)
        if field is None or field.full_name != named.full_name:
            holds = field.full_name if field else f"the unknown descriptor 0x{descriptor:02X}"
            raise ValueError(f"'{name}' is listed, but the packet holds {holds}")
        return codec.canonical_record(named.operations, _without_constants(named, values), name)

    def compare(self, field: m.Field, values: dict[str, Any], stated: dict[str, Any]) -> None:
        for name, value in stated.items():
            if values.get(name) != value:
                raise ValueError(f"{field.full_name}.{name} is {values.get(name)!r} in the bytes, but {value!r} is stated")


def _digits(text: str) -> int:
    return len("".join(text.split()))


def _as_field(raw: tuple[int | None, ...] | tuple[int, ...]) -> tuple[int, bytes]:
    data = bytes(x or 0 for x in raw)
    if len(data) < 2 or data[0] != len(data):
        raise ValueError(f"{data.hex(' ')} is no field: its first byte must be its length, {len(data)}")
    return data[1], data[2:]


def _without_constants(field: m.Field, values: dict[str, Any]) -> dict[str, Any]:
    """Constants may be stated, to read well; they are no values."""
    constants = {p.name: p.constant for p in field.parameters if p.constant is not None}
    for name, value in values.items():
        if name in constants and value != constants[name]:
            raise ValueError(f"{field.full_name}.{name} is always {constants[name]}, not {value}")
    return {k: v for k, v in values.items() if k not in constants}


def _with_counters(operations: tuple[m.Operation, ...], values: dict[str, Any]) -> dict[str, Any]:
    """Adds counters that the author left out."""
    found = dict(values)
    for op in operations:
        for inner in op.body if isinstance(op, m.GroupOp) else (op,):
            if isinstance(inner, m.CounterOp) and inner.array in values:
                found.setdefault(inner.member, len(values[inner.array]))
    return found


# --------------------------------------------------------------------------- errata


def errata(roots: Iterable[Node], manuals: set[str], problems: Problems) -> tuple[m.Erratum, ...]:
    found: dict[str, m.Erratum] = {}
    for root in roots:
        for node in root["errata"]:
            name, manual = node["id"].value, node["manual"].value
            if manual not in manuals:
                problems.add(node["manual"].position, f"unknown manual '{manual}'{nearest(manual, manuals)}")
            if name in found:
                problems.add(node["id"].position, f"the erratum '{name}' stands twice; choose another id")
            found[name] = m.Erratum(
                name, manual, node["section"].value, node["severity"].value, node["printed"].value,
                node["right"].value, node["reason"].value, _claims(node), node.position,
            )  # fmt: skip
    return tuple(sorted(found.values(), key=lambda e: e.id))


def _claims(node: Node) -> tuple[m.Claim, ...]:
    found = []
    for entry in node.get("claims") or ():
        for kind, subject in entry.items():
            found.append(m.Claim(kind, subject.value, subject.position))  # type: ignore[arg-type]
    return tuple(found)
