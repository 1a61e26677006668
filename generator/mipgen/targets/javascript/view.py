"""What the templates print: layouts of classes in modules (`define.j2`), and their declarations (`declare.j2`)."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts.comments import Comments
from mipgen.lower import calls, validity
from mipgen.targets.json import api as json_document

from . import blocks, names
from .names import SCALARS, camel, class_name, constant, home, member, reference
from .session import Session, session_commands

WIDTH = 120


@dataclass(frozen=True, slots=True)
class Item:
    """A parameter, a value, some bits, or a constructor."""

    key: str  # in the object of the module
    definition: str  # the block of a parameter, the number of a value, the first and the last bit
    declaration: str  # empty if it follows from others
    doc: list[str]


@dataclass(frozen=True, slots=True)
class Type:
    type: m.Type
    name: str
    doc: list[str]
    definition: str  # of a vector; up to the items of any other type
    items: list[Item]
    collection: str  # the class of an object of named numbers, and the type of these; both empty for other types
    number: str
    elements: str  # of a vector, as TypeScript names them


@dataclass(frozen=True, slots=True)
class Field:
    field: m.Field
    name: str
    doc: list[str]
    sets: str
    attributes: list[str]  # that only some classes have
    reading: list[tuple[str, str]]  # members and expressions that read them; then the items have no definitions
    items: list[Item]
    head: str  # the class and its base
    values: str  # the parameter of the constructor; empty if it has none
    constructors: list[Item]


@dataclass(frozen=True)
class Family:
    """A module of a family."""

    family: m.Family
    model: m.Model

    @cached_property
    def module(self) -> str:
        return names.module(self.family.name)

    @cached_property
    def namespace(self) -> str:
        """The name under which other modules import it."""
        return names.namespace(self.family.name)

    @cached_property
    def doc(self) -> list[str]:
        return COMMENTS.family(self.family, self.model)

    @cached_property
    def imported(self) -> list[Family]:
        """The other families whose modules it imports."""
        silencing = (blocks.silenced_by(f, self.model) for f in self.family.fields if f.role == m.COMMAND)
        used = {setting.family for settings in silencing for _, setting in settings} - {self.family.name}
        return [Family(x, self.model) for x in sorted(self.model.families, key=lambda x: x.name) if x.name in used]

    @cached_property
    def types(self) -> list[Type]:
        return [type_view(t, self.model) for t in self.family.types]

    @cached_property
    def fields(self) -> list[Field]:
        """Its fields: responses before the commands that name them."""
        ordered = sorted(self.family.fields, key=lambda f: f.role, reverse=True)
        return [field_view(f, self.model) for f in ordered]


@dataclass(frozen=True)
class Package:
    """The whole specification."""

    model: m.Model

    @cached_property
    def families(self) -> list[Family]:
        return [Family(x, self.model) for x in self.model.families]

    @cached_property
    def types(self) -> list[Type]:
        return [type_view(t, self.model) for t in self.model.types]

    @cached_property
    def function_selector(self) -> Type:
        return type_view(self.model.protocol.function_selector, self.model)

    @cached_property
    def acknowledge(self) -> Field:
        return field_view(self.model.protocol.acknowledge, self.model)

    @cached_property
    def ack_code(self) -> tuple[str, str]:
        """The module and the name of the type."""
        return home(self.model.protocol.ack_code), class_name(self.model.protocol.ack_code)

    @cached_property
    def session(self) -> Session | None:
        return session_commands(self.model)

    @cached_property
    def timestamps(self) -> dict[str, m.Field]:
        """The arguments that describe each field that contains the time of its packet -> the field."""
        rows: dict[str, m.Field] = {}
        for t in validity.timestamps(self.model):
            kind = f"{names.namespace(t.field.family)}.{class_name(t.field)}"
            sets = "null" if t.field.everywhere else blocks.numbers(t.sets)
            parts = ", ".join(f"{member(p.name)}: {scale}" for p, scale in t.parts)
            clocks = json.dumps([c.name for c in t.clocks])
            rows[f"{kind}, {sets}, {t.field.min_size}, {clocks}, {{ {parts} }}"] = t.field
        return rows

    @cached_property
    def timed(self) -> list[Family]:
        """The families with such fields."""
        names = {f.family for f in self.timestamps.values()}
        return [x for x in self.families if x.family.name in names]

    @cached_property
    def document(self) -> str:
        """The model as JSON, with the same numbers in JavaScript."""
        return blocks.exact_json(json_document.text(self.model))


# --------------------------------------------------------------------------- types


def type_view(t: m.Type, model: m.Model) -> Type:
    name, items, collection, number, elements = class_name(t), [], "", "", ""
    match t:
        case m.Enum():
            collection, number = "Enumeration", SCALARS[t.scalar.name]
            definition = blocks.opening("enumeration", blocks.scalar(t.scalar))
            for v in t.values:
                value = f"{v.value}{'n' if number == 'bigint' else ''}"
                items.append(_part(v.name, value, f"{name} & {value}", COMMENTS.value(v, t, model)))
        case m.Bitfield():
            collection, number = "Bitfield", SCALARS[t.scalar.name] if t.scalar else "bigint"
            octets = blocks.call("octets", str(t.size))
            definition = blocks.opening("bitfield", blocks.scalar(t.scalar) if t.scalar else octets)
            items = [_part(b.name, f"[{b.first}, {b.last}]", name, COMMENTS.bits(b, t, model)) for b in t.bits]
        case m.Vector():
            definition = blocks.vector(t)
            elements = ", ".join(f"{e}: number" for e in t.elements)
        case m.Struct():
            definition, items = blocks.opening("struct"), _parameters(t, model)
    return Type(t, name, COMMENTS.type(t, model), definition, items, collection, number, elements)


def _part(name: str, definition: str, of: str, doc: list[str]) -> Item:
    key = blocks.object_key(constant(name))
    return Item(key, definition, f"readonly {key}: {of};", doc)


# --------------------------------------------------------------------------- members


def _parameters(record: m.Record, model: m.Model) -> list[Item]:
    where, structure = home(record), isinstance(record, m.Struct)

    def may_be_absent(p: m.Parameter) -> bool:
        return p.name in record.present_with or (structure and p.reserved is not None)  # of a field: `_values`

    return [
        Item(
            blocks.object_key(member(p.name)),
            blocks.block(p, where),
            "" if p.derived else f"{declared(p, where, may_be_absent(p))};",
            COMMENTS.member(p, record, model),
        )
        for p in record.parameters
    ]


def declared(p: m.Parameter, where: str, may_be_absent: bool) -> str:
    """Writes a member with its type in the module `where`."""
    return f"{member(p.name)}{'?' if may_be_absent else ''}: {_type_of(p, where)}"


def _type_of(p: m.Parameter, where: str) -> str:
    if p.element is None:
        cases = dict.fromkeys(declared(alternative, where, True) for alternative in p.alternatives)
        return f"{{ {'; '.join(cases)} }}"
    if p.kind == "text":
        return "string"
    element = SCALARS[p.element.name] if isinstance(p.element, m.Scalar) else reference(p.element, where)
    if not p.several or p.vector:
        return element
    short = isinstance(p.element, m.Scalar) and p.count is not None and p.count <= 4
    return f"[{', '.join([element] * (p.count or 0))}]" if short else f"{element}[]"


# --------------------------------------------------------------------------- fields


def field_view(f: m.Field, model: m.Model) -> Field:
    name, base, where = class_name(f), f.role.capitalize(), home(f)
    responses = {c: _response_type(c, f, model) for c in f.calls} if f.role == m.COMMAND else {}
    union = " | ".join(dict.fromkeys(t for each in responses.values() for t in each.split(" | ")))
    differ = len(set(responses.values())) > 1  # then the type of the response is a parameter of the class
    head = f"{name} extends {base}<{union}>" if responses else f"{name} extends {base}"
    if differ:
        head = f"{name}<R extends Response | undefined = {union}> extends {base}<R>"
    constructors = [
        Item("", "", f"static {camel(c.function.name)}({_arguments(c, where)}): {name}{f'<{t}>' if differ else ''};",
             [c.function.description])
        for c, t in responses.items() if c.function
    ]  # fmt: skip
    attributes = list(blocks.class_attributes(f, model))
    doc, items, values = COMMENTS.field(f, model), _parameters(f, model), _values(f, name)
    return Field(f, name, doc, blocks.sets(f), attributes, blocks.reading(f), items, head, values, constructors)


def _response_type(call: m.Call, f: m.Field, model: m.Model) -> str:
    layouts = calls.possible_layouts(f, call.function, model)
    return " | ".join(dict.fromkeys(reference(layout, home(f)) for layout in layouts)) or "undefined"


def _arguments(call: m.Call, where: str) -> str:
    values = [declared(p, where, False) for p in call.values] + [declared(p, where, True) for p in call.addable]
    return f"values{'' if call.values else '?'}: {{ {'; '.join(values)} }}" if values else ""


def _values(f: m.Field, name: str) -> str:
    members = calls.members(f)
    may_be_omitted = " | ".join(json.dumps(member(p.name)) for p in members if p.reserved is not None)
    return f"values: Values<{name}{f', {may_be_omitted}' if may_be_omitted else ''}>" if members else ""


# --------------------------------------------------------------------------- comments


def _alternative(p: m.Parameter | None, record: m.Record) -> str:
    return declared(p, home(record), False) if p else "{}"


COMMENTS = Comments(names, _alternative)


def comment(paragraphs: Iterable[str], indent: int = 0) -> str:
    """Writes an indented comment of these paragraphs, and a line end; nothing if they are empty.

    >>> comment(["Short."], 4)
    '    /** Short. */\\n'
    """
    text = "\n\n".join(filter(None, paragraphs)).replace("*/", "*\u200b/")
    if not text:
        return ""
    margin = " " * indent
    lines = [line for long in text.split("\n") for line in _wrapped(long, WIDTH - indent - 3)]
    if len(lines) == 1 and indent + len(lines[0]) + 7 <= WIDTH:
        return f"{margin}/** {lines[0]} */\n"
    return "\n".join([f"{margin}/**", *(f"{margin} * {line}".rstrip() for line in lines), f"{margin} */", ""])


def _wrapped(text: str, width: int) -> list[str]:
    """Wraps a paragraph, or a list item with a hanging indent."""
    return wrapped(text, width, "  " if text.startswith("- ") else "") or [""]
