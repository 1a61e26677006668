"""What the template of mip.ksy prints: its types with their attributes, its enumerations, and its documentation."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.facts import describe

from . import expressions, names
from .names import SCALARS, member, type_name, value

#: Topics in the documentation of a parameter, besides its description.
TOPICS = (
    "deprecated", "unit", "frame", "range", "positive", "default", "valid", "reserved", "variant", "note", "uncertain",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Item:
    """An attribute or an instance of a type, or a value of an enumeration."""

    name: str
    lines: list[str]  # in YAML
    doc: str = ""
    number: str = ""  # of a value


@dataclass(frozen=True, slots=True)
class Type:
    name: str
    lines: list[str]
    doc: str
    attributes: list[Item]
    instances: list[Item]
    unions: list[tuple[str, list[Item]]]  # the types that are nested in it


@dataclass(frozen=True, slots=True)
class Layouts:
    """The layouts of a descriptor that has several."""

    home: str
    types: list[str]
    choice: expressions.Layouts


@dataclass(frozen=True)
class Ksy:
    model: m.Model

    @property
    def sync(self) -> str:
        return f"0x{bytes(self.model.protocol.sync).hex()}"

    @cached_property
    def kinds(self) -> list[tuple[int, str, tuple[m.Field, ...]]]:
        """Every descriptor that can be decoded: its number (set, descriptor), its name in that set, its layouts."""
        layouts: dict[tuple[int, int], list[m.Field]] = {}
        for f in self.fields:
            for o in f.occurrences:
                layouts.setdefault((o.set, f.descriptor), []).append(f)
        return [(s << 8 | d, names.kind_name(_first(x), s), tuple(x)) for (s, d), x in sorted(layouts.items())]

    @cached_property
    def fields(self) -> list[m.Field]:
        return [self.model.protocol.acknowledge, *self.model.fields]

    @cached_property
    def homes(self) -> list[tuple[str, str]]:
        """The kind of each descriptor, and the type of its data."""
        return [(name, type_of_data(fields)) for _, name, fields in self.kinds]

    @cached_property
    def several(self) -> list[Layouts]:
        several = {type_of_data(fields): fields for _, _, fields in self.kinds if len(fields) > 1}
        return [
            Layouts(name, [*map(type_name, fields)], expressions.layouts(fields)) for name, fields in several.items()
        ]

    @cached_property
    def kind(self) -> str:
        return expressions.kind(self.model)

    @cached_property
    def types(self) -> list[Type]:
        kinds = (m.Vector, m.Bitfield, m.Struct)
        types = [t for kind in kinds for t in self.model.all_types if isinstance(t, kind)]
        return [type_view(t, self.model) for t in (*types, *self.fields)]

    @cached_property
    def enums(self) -> list[tuple[str, list[Item]]]:
        """The kinds of fields, then the enumerations of the specification."""
        kinds = [
            Item(
                name, [f"-orig-id: {f[0].name_in(number // 256)}", f"-role: {f[0].role}"], f[0].title, f"{number:#06x}"
            )
            for number, name, f in self.kinds
        ]
        enums = [self.model.protocol.function_selector, *(t for t in self.model.all_types if isinstance(t, m.Enum))]
        return [("kind", kinds), *((type_name(t), [self._value(v) for v in t.values]) for t in enums)]

    def _value(self, v: m.EnumValue) -> Item:
        return Item(value(v.name), _original(v.name, value(v.name)), _doc(v, self.model), str(v.value))

    @cached_property
    def readings(self) -> dict[str, list[str]]:
        """The parameters whose values have different names by device, or by the value of another parameter."""
        places: dict[str, list[str]] = {"device": [], "parameter": []}
        records: list[m.Record] = [*m.structs(self.model.all_types), *self.fields]
        for record in records:
            for p in record.parameters:
                variants = [v for v in p.variants if v.type is not None or v.unknown]
                where = f"`{type_name(record)}.{member(p.name)}`"
                if p.by_device or any(v.by_device for v in variants):
                    places["device"].append(where)
                if any(not v.by_device for v in variants):
                    places["parameter"].append(where)
        return places


def _first(fields: Sequence[m.Field]) -> m.Field:
    """Returns the layout that names a descriptor: the first in the specification; `fields` are in another order."""
    return min(fields, key=lambda f: f.position or ())


def type_of_data(fields: Sequence[m.Field]) -> str:
    """Returns the type of a descriptor's data."""
    return type_name(_first(fields)) + ("_layouts" if len(fields) > 1 else "")


# --------------------------------------------------------------------------- types


def type_view(t: m.Type | m.Field, model: m.Model) -> Type:
    name, doc = type_name(t), _sentences(t.description, describe.caveats(t, model), model)
    match t:
        case m.Vector():
            elements = [Item(member(e), [f"type: {SCALARS[t.scalar.name]}"]) for e in t.elements]
            return Type(name, ["-kind: vector"], doc, elements, [], [])
        case m.Bitfield():
            lines = ["-kind: bits"] if t.scalar else ["-kind: bytes", "meta:", "  bit-endian: le"]
            number = Item(expressions.NUMBER, [f'value: "{expressions.bits_as_number(t)}"'], "All bits as a number.")
            aliases = [
                Item(member(b.name), [f'value: "{expressions.alias(b, t)}"'], _doc(b, model)) for b in t.bits if b.alias
            ]
            bits = [_bits(s, model) for s in expressions.segments(t)]
            return Type(name, lines, doc, bits, [number, *aliases] if t.scalar else aliases, [])
        case m.Field():
            return _record(t, [f"-orig-id: {t.full_name}"], f"{t.title}. {doc}", model)
    assert isinstance(t, m.Struct)
    return _record(t, [], doc, model)


def _bits(s: expressions.Segment, model: m.Model) -> Item:
    lines = [f"type: b{s.width}"]
    if s.bits:
        lines += [*_original(s.bits.name, s.name), *([f"enum: {type_name(s.bits.enum)}"] if s.bits.enum else ())]
    return Item(s.name, lines, _doc(s.bits, model) if s.bits else "")


def _record(t: m.Record, lines: list[str], doc: str, model: m.Model) -> Type:
    conditions = {}
    if isinstance(t, m.Field):
        conditions = {p.name: expressions.presence_condition(g, t) for g in t.groups for p in g.parameters}
    attributes = [_attribute(p, _lines(p, t), conditions.get(p.name, ""), about(p, t, model)) for p in t.parameters]
    rests = [Item(r.name, [f"value: (_io.size - _io.pos) / {r.each}"]) for r in expressions.rests(t)]
    peeks = [Item(p.name, [f"pos: {p.at}", *_type_of(p.tag), f"if: _io.size >= {p.end}"]) for p in expressions.peeks(t)]
    unions = [(names.cases(member(p.name)), _alternatives(p.union, t, model)) for p in t.parameters if p.union]
    return Type(type_name(t), lines, doc, attributes, [*rests, *peeks], unions)


def _alternatives(union: m.Union, record: m.Record, model: m.Model) -> list[Item]:
    # In C++, the class of a parent must be complete before it is named, which the type of a union here is not.
    tag = f"_parent.{member(union.tag)} == {type_name(union.type)}"
    return [
        _attribute(p, [*_lines(p, record), *(["parent: false"] if p.struct else [])], f"{tag}::{value(c.tag.name)}",
                   about(p, record, model))
        for c in union.cases if (p := c.parameter)
    ]  # fmt: skip


def _attribute(p: m.Parameter, lines: list[str], condition: str, doc: str) -> Item:
    name = member(p.name)
    return Item(name, [*_original(p.name, name), *lines, *([f"if: {condition}"] if condition else ())], doc)


def _original(words: str, name: str) -> list[str]:
    return [f"-orig-id: {yaml_line(words)}"] if words != name else []


def _lines(p: m.Parameter, record: m.Record) -> list[str]:
    """Writes what is read for a parameter."""
    match p.kind:
        case "constant":
            return [*_type_of(p), f"valid: {p.constant}"]
        case "counter":
            return [*_type_of(p), "valid:", f"  expr: {expressions.count_condition(p, record)}"]
        case "text":
            size = member(p.counter) if p.count is None and p.counter else p.count
            return ["type: str", "size-eos: true" if size is None else f"size: {size}"]
        case "array" if not p.vector:
            rest = f"{member(p.name)}_count" if p.fills else member(p.counter or "")
            return [*_type_of(p.item), "repeat: expr", f"repeat-expr: {rest if p.count is None else p.count}"]
        case "switch":
            return [f"type: {names.cases(member(p.name))}"]
    return _type_of(p)


def _type_of(p: m.Parameter) -> list[str]:
    t = p.struct or p.vector or p.named
    if isinstance(t, m.Enum):
        return [f"type: {SCALARS[p.scalar.name]}", f"enum: {type_name(t)}"]
    return [f"type: {type_name(t) if t else SCALARS[p.scalar.name]}"]


# --------------------------------------------------------------------------- texts

_PLAIN = re.compile(r"[A-Za-z][\w ,.;()/+-]*(?<! )")
_WORDS = {"true", "false", "null", "yes", "no", "on", "off"}  # these are not text in YAML 1.1


def yaml_line(words: str) -> str:
    """Writes a text on one line of YAML.

    >>> yaml_line("Speed, in m/s."), yaml_line("Of: all"), yaml_line('a "b"')
    ('Speed, in m/s.', '"Of: all"', '"a \\\\"b\\\\""')
    """
    plain = _PLAIN.fullmatch(words) and words.lower() not in _WORDS
    return words if plain else json.dumps(words, ensure_ascii=False)


def _sentences(words: str, facts: list[describe.Fact], model: m.Model) -> str:
    return " ".join(filter(None, (say(describe.prose(words, model)), *(say(f.sentence) for f in facts))))


def _doc(part: m.EnumValue | m.Bits, model: m.Model) -> str:
    return _sentences(part.description, describe.uncertain(part, model), model)


def say(words: describe.Text) -> str:
    return describe.say(words, _reference)


def _reference(ref: describe.Ref) -> str:
    """Returns the name in the file of a thing to which a text refers."""
    match ref.thing:
        case m.Field() | m.Enum() | m.Bitfield() | m.Struct():
            return f"`{type_name(ref.thing)}`"
        case m.EnumValue():
            return f"`{value(ref.thing.name)}`"
        case m.Bits():
            return f"`{'.'.join(map(member, ref.words.split('.')))}`"
        case m.Parameter():
            return f"`{member(ref.thing.name)}`"
        case _:
            return ref.words


def about(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    """Composes the documentation of a parameter, or of a union's alternative; empty if there is none."""
    return _sentences(p.description, describe.topics(describe.parameter(p, record, model), *TOPICS), model)
