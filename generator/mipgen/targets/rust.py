"""The Rust target: a `no_std` crate with one module per descriptor set."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .. import model as m
from ..naming import Escape, Identifier, pascal, upper
from ..render import File, language

TITLE = "Rust, no_std"

WIDTH = 100
LANGUAGE = language("rust")
KEYWORDS = frozenset(LANGUAGE["keywords"])

Record = m.Field | m.Struct

module = Escape(KEYWORDS, digit_prefix="mip_")
member = Escape(KEYWORDS | frozenset(LANGUAGE["members"]))
method = Escape(KEYWORDS | frozenset(LANGUAGE["bit_methods"]))
_type = Escape(KEYWORDS | frozenset(LANGUAGE["types"]), digit_prefix="Mip")
_variant = Escape(KEYWORDS, digit_prefix="Mip")
_constant = Escape(frozenset(LANGUAGE["constants"]))


def type_name(words: str) -> str:
    """
    >>> type_name("pps_source"), type_name("3dm"), type_name("result"), type_name("self")
    ('PpsSource', 'Mip3dm', 'Result_', 'Self_')
    """
    return _type(pascal(words))


def variant(words: str) -> str:
    """
    >>> variant("none"), variant("self")
    ('None', 'Self_')
    """
    return _variant(pascal(words))


def constant(words: str) -> str:
    """
    >>> constant("receiver_1"), constant("values"), constant("5_hz")
    ('RECEIVER_1', 'VALUES_', '_5_HZ')
    """
    return _constant(upper(words))


def constructor(function: m.Function) -> str:
    name: str = LANGUAGE["constructors"].get(function.name, function.name)
    return member(name)


# --------------------------------------------------------------------------- files


def files(model: m.Model) -> Iterable[File]:
    yield File("Cargo.toml", "Cargo.toml.j2")
    yield File("README.md", "README.md.j2", {"samples": _samples(model)})
    for name in ("lib", "types", "protocol", "devices", "registry", "dynamic/mod", "dynamic/types", "dynamic/protocol"):
        yield File(f"src/{name}.rs", f"{name}.rs.j2")
    for s in model.sets:
        yield File(f"src/{module(s.name)}.rs", "set.rs.j2", {"set": s})
        if s.own_fields:
            yield File(f"src/dynamic/{module(s.name)}.rs", "dynamic/set.rs.j2", {"set": s})


def _samples(model: m.Model) -> dict[str, Any]:
    """Fields that the README can show with: whatever the specification has."""
    names = Names(model)
    commands = [f for f in model.fields if f.role == m.COMMAND]
    settings = []
    for f in commands:
        if f.functions and f.functions[0].value == 1 and len(f.responses) == 1:
            write, *_ = f.functions
            read = next(x for x in f.functions if x.responds)
            calls = [(x, [_sample(a) for a in names.arguments(f, x)]) for x in (write, read)]
            if all(value for _, values in calls for value in values):
                settings.append((f, [f"{constructor(x)}({', '.join(v or '' for v in values)})" for x, values in calls]))
    settings.sort(key=lambda setting: not _is_one_choice(setting[0]))  # that reads best
    return {
        "bare": next((f for f in commands if not f.parameters), None),
        "setting": settings[0] if settings else None,
        "data": next((f for f in model.fields if f.role == m.DATA), None),
    }


def _is_one_choice(f: m.Field) -> bool:
    return len(f.parameters) == 2 and isinstance(f.parameters[1].element, m.Enum)


def _sample(x: Member) -> str | None:
    """An argument that one would give."""
    element = x.parameter.element
    if isinstance(element, m.Enum):
        return f"{path(element, '').removeprefix('crate::')}::{constant(element.values[-1].name)}"
    if isinstance(element, m.Scalar) and x.parameter.length is None:
        return {"bool": "true", "float": "1.0"}.get(element.kind, "1")
    return None


# --------------------------------------------------------------------------- members of records


@dataclass(frozen=True, slots=True)
class Member:
    """A parameter that a Rust type keeps. Counters and constants are not kept."""

    name: str
    type: str
    group: m.GroupOp | None  # what it comes and goes with; None if it is always there
    parameter: m.Parameter

    @property
    def optional(self) -> bool:
        return self.group is not None

    @property
    def whole_type(self) -> str:
        return f"Option<{self.type}>" if self.optional else self.type


@dataclass(frozen=True, slots=True)
class Constructor:
    name: str
    description: str
    arguments: tuple[str, ...]
    values: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Accessor:
    """Reads a raw value as the type that gives it its meaning."""

    name: str
    type: str
    description: str
    member: Member
    tag: Member | None  # what decides, if it is not the device
    pattern: str  # values of the tag


def is_kept(p: m.Parameter) -> bool:
    return p.constant is None and p.counts is None


def home(thing: m.Type | Record) -> str:
    """The module that a type stands in."""
    if isinstance(thing, m.Field):
        return module(thing.set_name)
    owner = None if isinstance(thing, m.Vector) else thing.owner
    return module(owner) if owner else "types"


def path(thing: m.Type | Record, here: str) -> str:
    """What a type is called inside the module `here`."""
    name, where = type_name(thing.name), home(thing)
    return name if where == here else f"types::{name}" if where == "types" else f"crate::{where}::{name}"


class Names:
    """What the types of a model are called and made of."""

    def __init__(self, model: m.Model) -> None:
        self.model = model
        self.unions: list[tuple[str, str, m.SwitchOp, Record]] = []
        for record in self.records():
            for p in record.parameters:
                if isinstance(p.operation, m.SwitchOp) and self.find_union(home(record), p.operation) is None:
                    name = type_name(f"{record.name}_{p.name}")
                    self.unions.append((home(record), name, p.operation, record))

    def records(self) -> Iterator[Record]:
        yield from (t for t in self.model.types if isinstance(t, m.Struct))
        yield self.model.protocol.acknowledge
        for s in self.model.sets:
            yield from (t for t in s.types if isinstance(t, m.Struct))
            yield from s.own_fields

    def find_union(self, here: str, op: m.SwitchOp) -> str | None:
        """Unions of a module that have the same alternatives are one type."""
        found = (n for h, n, o, _ in self.unions if h == here and (o.tag_type, o.cases) == (op.tag_type, op.cases))
        return next(found, None)

    def unions_of(self, record: Record) -> list[tuple[str, m.SwitchOp]]:
        """Those that are defined beside this record."""
        return [(name, op) for _, name, op, r in self.unions if r is record]

    def rust(self, op: m.Operation, here: str) -> str:
        """The type of what an operation reads."""
        match op:
            case m.ScalarOp() | m.CounterOp() | m.ConstantOp():
                named = op.type if isinstance(op, m.ScalarOp) else None
                return path(named, here) if named else scalar(op.scalar)
            case m.BitsOp():
                return path(op.type, here)
            case m.TextOp():
                return f"crate::Text<{op.count}>" if op.count is not None else f"crate::VarText<{op.capacity}>"
            case m.ArrayOp() if op.vector is not None:
                return path(op.vector, here)
            case m.ArrayOp():
                item = self.rust(op.item, here)
                return f"[{item}; {op.count}]" if op.count is not None else f"crate::List<{item}, {op.capacity}>"
            case m.StructOp():
                return path(op.struct, here)
            case m.SwitchOp():
                found = self.find_union(here, op)
                assert found is not None
                return found
        raise AssertionError(op)

    def members(self, record: Record) -> list[Member]:
        groups = [op for op in record.operations if isinstance(op, m.GroupOp)]
        found = []
        for p in record.parameters:
            if is_kept(p):
                group = next((g for g in groups if p.operation in g.body), None)
                found.append(Member(member(p.name), self.rust(p.operation, home(record)), group, p))
        return found

    # ------------------------------------------------------------------ constructors

    def constructors(self, record: Record) -> list[Constructor]:
        if isinstance(record, m.Struct):
            return [self._constructor(record, "new", "Puts the values together.", None)]
        if record.role != m.COMMAND:
            return []
        if not record.functions:
            return [self._constructor(record, "new", "The command with its parameters.", None)]
        return [self._constructor(record, constructor(f), f.description, f) for f in record.functions]

    def required(self, record: Record, function: m.Function | None) -> list[Member]:
        """What must be there: all that is not in a group, and the groups that the function needs."""
        count = dict(record.required).get(function.value, 0) if function and isinstance(record, m.Field) else 0
        return [x for x in self.members(record) if x.group is None or x.group.last <= count]

    def arguments(self, record: Record, function: m.Function | None) -> list[Member]:
        """What the caller gives: no reserved values, and no tag whose union is given."""
        needed = [x for x in self.required(record, function) if not x.parameter.selector]
        tags = {x.parameter.tag for x in needed}
        return [x for x in needed if x.parameter.reserved is None and x.parameter.name not in tags]

    def _constructor(self, record: Record, name: str, description: str, function: m.Function | None) -> Constructor:
        needed = self.required(record, function)
        given = self.arguments(record, function)
        by_tag = {x.parameter.tag: x for x in given}
        values = []
        for x in self.members(record):
            if x not in needed:
                value = "None"
            elif x.parameter.selector:
                assert function is not None
                value = f"types::{type_name(self.model.protocol.function_selector.name)}::{constant(function.name)}"
            elif x.parameter.reserved is not None:
                value = reserved_value(x)
            elif x.parameter.name in by_tag:
                value = f"{by_tag[x.parameter.name].name}.tag()"
            else:
                value = x.name if _argument(x) == x.type else f"{x.name}.into()"
            if x.optional and x in needed:
                value = f"Some({value})"
            values.append(x.name if value == x.name else f"{x.name}: {value}")
        return Constructor(name, description, tuple(f"{x.name}: {_argument(x)}" for x in given), tuple(values))

    def accessors(self, record: Record) -> list[Accessor]:
        """Methods that read a raw value as what it means by a sibling or by the device."""
        here, members = home(record), {x.parameter.name: x for x in self.members(record)}
        found: list[Accessor] = []
        for x in members.values():
            reading = x.parameter.reading
            if reading is None:
                continue
            keys: dict[str, tuple[m.Enum | m.Bitfield, list[str]]] = {}
            for key, t in reading.types:
                if inner(t) == x.type:
                    keys.setdefault(t.name, (t, []))[1].append(key)
            tag = members.get(reading.by) if reading.by != "device" else None
            for t, labels in keys.values():
                pattern = ""
                if tag is not None:
                    pattern = " | ".join(f"{tag.type}::{constant(v)}" for v in labels)
                    pattern = f"Some({pattern})" if tag.optional else pattern
                    what = f"when `{tag.parameter.name}` is {' or '.join(labels)}"
                else:
                    what = f"on the {' and the '.join(self._devices(labels))}"
                name, meaning = f"{x.parameter.name}_as_{t.name}", f"The meaning of `{x.parameter.name}` {what}."
                found.append(Accessor(name, path(t, here), meaning, x, tag, pattern))
        return found

    def _devices(self, ids: list[str]) -> list[str]:
        titles = {d.id: d.title for d in self.model.devices}
        return [titles.get(i, i) for i in ids]


def _argument(x: Member) -> str:
    """The type of a constructor's argument: what is easy to give."""
    if x.type == scalar(m.SCALARS["bool"]):
        return "bool"
    if x.type.startswith("crate::List<") or (isinstance(x.parameter.element, m.Vector) and x.parameter.length is None):
        return f"impl Into<{x.type}>"
    return x.type


def reserved_value(x: Member) -> str:
    value = str(x.parameter.reserved)
    return f"[{value}; {x.parameter.length}]" if isinstance(x.parameter.length, int) else value


def inner(t: m.Enum | m.Bitfield) -> str:
    """What a newtype wraps."""
    return f"[u8; {t.size}]" if isinstance(t, m.Bitfield) and t.scalar is None else scalar(t.scalar)


def scalar(of: m.Scalar | None) -> str:
    assert of is not None
    return str(LANGUAGE["scalars"][of.name])


def bits_type(bits: m.Bits, here: str) -> str:
    """The type of some bits: a flag, an enumeration, or the smallest number that holds them."""
    if bits.enum is not None:
        return path(bits.enum, here)
    return "bool" if bits.width == 1 else next(f"u{n}" for n in (8, 16, 32, 64) if n >= bits.width)


def is_plain(op: m.Operation) -> bool:
    """Does the type alone know how to read and write itself?"""
    return not (op.kind == "switch" or (isinstance(op, (m.ArrayOp, m.TextOp)) and op.count is None))


def is_long(op: m.Operation) -> bool:
    """Is it an array that has no Default in Rust?"""
    return isinstance(op, m.ArrayOp) and op.vector is None and (op.count or 0) > 32


def default_of(x: Member) -> str:
    """The default of a member, as an expression."""
    default = "core::default::Default::default()"
    if x.optional:
        return "None"
    if x.parameter.reserved:
        return reserved_value(x)
    op = x.parameter.operation
    return f"[{default}; {op.count}]" if is_long(op) and isinstance(op, m.ArrayOp) else default


def declaration(x: Member) -> str:
    """The line of a member in its structure."""
    line = f"    pub {x.name}: {x.whole_type},"
    return line if len(line) <= WIDTH else f"    pub {x.name}:\n        {x.whole_type},"


def defaults(members: Iterable[Member]) -> list[str]:
    return [f"{x.name}: {default_of(x)}" for x in members]


def byte_constants(constants: Iterable[tuple[int, m.ConstantOp]]) -> list[str]:
    """Offsets and bytes."""
    return [f"({at}, &[{', '.join(str(b) for b in op.value.to_bytes(op.size, 'big'))}])" for at, op in constants]


def derives_default(members: Iterable[Member]) -> bool:
    return not any(not x.optional and (x.parameter.reserved or is_long(x.parameter.operation)) for x in members)


def variants(f: m.Field) -> list[tuple[str, str]]:
    """The variants of what a command with several responses is answered with: name and type."""
    return [(variant(r.removeprefix(f"{f.name}_").removesuffix("_response") or r), type_name(r)) for r in f.responses]


# --------------------------------------------------------------------------- text


def doc(text: str, indent: int = 0, marker: str = "///") -> str:
    """Paragraphs and lists as documentation comments.

    >>> print(doc("One.\\n\\n- two\\n- three", 4))
        /// One.
        ///
        /// - two
        /// - three
    """
    margin = " " * indent
    out: list[str] = []
    for paragraph in _paragraphs(text):
        hanging = "  " if paragraph.startswith("- ") else ""
        if out and not (hanging and out[-1].startswith(("- ", "  "))):
            out.append("")
        if paragraph.startswith("|"):
            out += paragraph.split("\n")
        else:
            wrapper = textwrap.TextWrapper(WIDTH - indent - len(marker) - 1, subsequent_indent=hanging)
            wrapper.break_long_words = wrapper.break_on_hyphens = False
            out += wrapper.wrap(paragraph)
    return "\n".join(f"{margin}{marker} {line}".rstrip() for line in out)


def _paragraphs(text: str) -> Iterator[str]:
    for block in text.split("\n\n"):
        lines = [line.strip() for line in block.strip().split("\n") if line.strip()]
        if lines and lines[0].startswith("|"):
            yield "\n".join(lines)
        elif lines and lines[0].startswith("- "):
            items: list[str] = []
            for line in lines:
                if line.startswith("- "):
                    items.append(line)
                else:
                    items[-1] += f" {line}"
            yield from items
        elif lines:
            yield " ".join(lines)


def prose(text: str) -> str:
    """Text of the specification as Markdown: what looks like markup is none, except for code.

    >>> prose("a[1] < `b[2]`")
    'a\\\\[1\\\\] \\\\< `b[2]`'
    """
    parts = " ".join(text.split()).split("`")
    for i in range(0, len(parts), 2):
        for character in "[]<>*|":
            parts[i] = parts[i].replace(character, f"\\{character}")
    return "`".join(parts)


def tidy(text: str) -> str:
    """Blank lines where they belong: none at the ends of a block and behind comments and attributes.

    >>> tidy("a {\\n\\n\\n    b\\n\\n}\\n")
    'a {\\n    b\\n}'
    """
    text = re.sub(r"[ \t]+\n", "\n", text)
    text = re.sub(r"\n{3,}", "\n\n", text)
    text = re.sub(r"([{(]|^ *///.*|^ *#!?\[.*\])\n\n+", r"\1\n", text, flags=re.MULTILINE)
    return re.sub(r"\n\n+( *[})])", r"\n\1", text).strip("\n")


def imports(body: str) -> str:
    """The `use` lines that a module needs."""
    macros = [name for name in ("bitfield", "open_enum", "vector") if re.search(rf"^{name}! ", body, re.MULTILINE)]
    values = [name for name in ("record", "union") if re.search(rf"^{name}! ", body, re.MULTILINE)]
    code = "".join(line for line in body.splitlines(keepends=True) if not line.lstrip().startswith("//"))
    lines = []
    for where, found in (("dynamic::macros", values), ("macros", macros)):
        if found:
            lines.append(f"use crate::{where}::{found[0] if len(found) == 1 else '{' + ', '.join(found) + '}'};")
    if re.search(r"(?<![:\w])types::", code):
        lines.append("use crate::types;")
    core = [name for name in LANGUAGE["imports"] if re.search(rf"(?<![:\w]){name}\b", code)]
    if core:
        lines.append(f"use crate::{core[0] if len(core) == 1 else '{' + ', '.join(core) + '}'};")
    return "".join(f"{line}\n" for line in lines) + ("\n" if lines else "")


def quoted(text: str) -> str:
    """A string literal.

    >>> print(quoted('say "µ"'))
    "say \\"µ\\""
    """
    escaped = " ".join(text.split()).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def fit(items: Sequence[str], head: str, tail: str, indent: int, pad: str = "") -> str:
    """A list in brackets, on one line if it fits, else one item per line, as rustfmt has it.

    >>> fit(["a: u8", "b: u8"], "pub fn new(", ") -> Self {", 4)
    'pub fn new(a: u8, b: u8) -> Self {'
    """
    line = f"{head}{pad}{', '.join(items)}{pad}{tail}"
    if indent + len(line) <= WIDTH and "\n" not in line:
        return line
    margin = " " * indent
    if head.endswith("[") and all(len(item) <= 10 for item in items):
        inside = f"{margin}    "
        filled = textwrap.fill(f"{', '.join(items)},", WIDTH, initial_indent=inside, subsequent_indent=inside)
        return f"{head}\n{filled}\n{margin}{tail}"
    return f"{head}\n" + "".join(f"{margin}    {item},\n" for item in items) + f"{margin}{tail}"


def link(head: str, name: str) -> str:
    """An empty implementation of a trait."""
    line = f"impl {head} for {name} {{}}"
    # What rustfmt measures ends with the opening brace.
    return line if len(line) <= WIDTH + 1 else f"impl {head}\n    for {name}\n{{\n}}"


def number(value: float | int) -> str:
    """A floating-point literal.

    >>> number(250), number(0.5)
    ('250.0', '0.5')
    """
    return repr(float(value))


def bounds(p: m.Parameter) -> str:
    low, high = p.minimum, p.maximum
    if low is None and high is None:
        return ""
    return f"at most {high}" if low is None else f"at least {low}" if high is None else f"{low} to {high}"


def literal(name: str, values: Sequence[str], indent: int) -> str:
    """A structure as an item of an array."""
    return fit(values, f"{name} {{", "},", indent, " ").removesuffix(",")


def wrap(text: str, indent: int) -> str:
    """Words on as few lines as they need."""
    margin = " " * indent
    return textwrap.fill(text, WIDTH, initial_indent=margin, subsequent_indent=margin, break_long_words=False)


def arm(body: str, pattern: str, indent: int) -> str:
    """One arm of a match."""
    margin = " " * indent
    line = f"{margin}{pattern} => {body},"
    return line if len(line) <= WIDTH else f"{margin}{pattern} => {{\n{margin}    {body}\n{margin}}}"


def assign(value: str, name: str, indent: int, keyword: str = "let") -> str:
    """A new variable or constant."""
    margin = " " * indent
    line = f"{margin}{keyword} {name} = {value};"
    return line if len(line) <= WIDTH - value.endswith("?") else f"{margin}{keyword} {name} =\n{margin}    {value};"


def if_let(value: str, pattern: str, indent: int) -> str:
    """The head of a condition that takes a value apart."""
    margin = " " * indent
    line = f"{margin}if let {pattern} = {value}"
    if len(line) > WIDTH:
        line = f"{margin}if let {pattern} =\n{margin}    {value}"
        return f"{line}\n{margin}{{"
    return f"{line} {{" if len(line) <= WIDTH - 2 else f"{line}\n{margin}{{"


def listing(items: Sequence[str], name: str) -> str:
    """The members of a record, in a macro."""
    return fit(items, f"{name} {{", "}", 4, " " if items else "")


def option(value: object | None) -> str:
    return "None" if value is None else f"Some({value})"


# --------------------------------------------------------------------------- what templates may use


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    names = Names(model)
    functions = {f.value: f for f in model.protocol.functions}

    def required_arms(f: m.Field) -> list[tuple[str, int]]:
        """How many parameters the functions need, as patterns; those that need none are left out."""
        counts = sorted({count for _, count in f.required if count}, reverse=True)
        found = []
        for count in counts:
            names_of = [f"F::{constant(functions[value].name)}" for value, needs in f.required if needs == count]
            found.append((" | ".join(names_of), count))
        return found

    def condition(op: m.GroupOp, f: m.Field) -> str:
        """When a group must be there."""
        return f"required >= {op.last}" if any(count >= op.last for _, count in f.required) else "false"

    def selected(f: m.Field, what: str) -> list[str]:
        """The function selectors that are answered by a response, or not even acknowledged."""
        selector = type_name(model.protocol.function_selector.name)
        chosen = [x for x in f.functions if (x.responds if what == "responds" else not x.reply)]
        return [f"types::{selector}::{constant(x.name)}" for x in chosen]

    def condition_value(c: m.Condition, f: m.Field) -> str:
        """The value of a condition, as what a member is compared with."""
        x = next(x for x in names.members(f) if x.parameter.name == c.parameter)
        element = x.parameter.element
        value = str(c.value)
        if isinstance(element, m.Enum):
            known = element.by_name(c.label)
            value = f"{x.type}::{constant(known.name)}" if known else f"{x.type}({c.value})"
        elif x.type == scalar(m.SCALARS["bool"]):
            value = f"{x.type}({c.value})"
        return f"Some({value})" if x.optional else value

    def conversions(model: m.Model) -> list[tuple[m.Enum | m.Bitfield, m.Enum | m.Bitfield, list[m.Device]]]:
        """Types that devices read as other types: from, to, and by which devices."""
        known = {t.name: t for t in (*model.types, *(t for s in model.sets for t in s.types))}
        found: dict[tuple[str, str], tuple[Any, Any, list[m.Device]]] = {}
        for d in model.devices:
            for name, to in d.readings:
                raw = known.get(name)
                if isinstance(raw, (m.Enum, m.Bitfield)) and inner(raw) == inner(to):
                    found.setdefault((name, to.name), (raw, to, []))[2].append(d)
        return list(found.values())

    def commands_of(f: m.Field) -> list[m.Field]:
        """The commands that a response answers."""
        of = model.set(f.set)
        return [c for c in of.fields if f.name in c.responses] if of and f.role == m.RESPONSE else []

    def sets_of(f: m.Field) -> list[int]:
        """The sets that have the field, its own first."""
        return [f.set, *(x.set for x in model.fields if x.definition == f.full_name)]

    def set_range(f: m.Field) -> tuple[int, int]:
        """The sets whose packets can hold the field, if it is not repeated."""
        if f.set_name == model.protocol.acknowledge.set_name:
            return 0x01, 0x7F
        return (0x80, 0xFF) if f.set == 0xFF else (f.set, f.set)

    def set_pattern(f: m.Field) -> str:
        """The sets of a field as a pattern, where they are more than its own."""
        first, last = set_range(f)
        if first != last:
            return f"0x{first:02X}..=0x{last:02X}"
        numbers = sets_of(f)
        return " | ".join(f"0x{n:02X}" for n in numbers) if len(numbers) > 1 else ""

    def linked(f: m.Field) -> list[str]:
        """The responses of a command, or the commands of a response."""
        return [f"{f.set_name}.{name}" for name in (f.responses or [c.name for c in commands_of(f)])]

    def ports(d: m.Device) -> list[str]:
        return [
            literal(
                "Port",
                [
                    f"name: {quoted(p.name)}",
                    f"id: {option(f'0x{p.id:02X}' if p.id is not None else None)}",
                    f"baud_rates: {fit([str(b) for b in p.baud_rates], '&[', ']', 12)}",
                    f"protocols: {fit([quoted(x) for x in p.protocols], '&[', ']', 12)}",
                ],
                8,
            )
            for p in d.ports
        ]

    def limits(d: m.Device) -> list[str]:
        return [
            literal(
                "Limit",
                [
                    f"name: {quoted(x.name)}",
                    f"value: {number(x.value)}",
                    f"unit: {option(quoted(x.unit) if x.unit else None)}",
                    f"description: {quoted(x.description)}",
                ],
                8,
            )
            for x in d.limits
        ]

    def base_rates(d: m.Device) -> list[str]:
        sets = {s.name: s.number for s in model.sets}
        rates = [(f"0x{sets[name]:02X}", number(rate)) for name, rate in d.base_rates]
        return [literal("BaseRate", [f"set: {number}", f"hertz: {rate}"], 8) for number, rate in rates]

    def readings(d: m.Device) -> list[str]:
        return [literal("Reading", [f"of: {quoted(of)}", f"read_as: {quoted(t.name)}"], 8) for of, t in d.readings]

    def ack_codes(d: m.Device) -> list[str]:
        names_of = {v.value: v.name for v in model.protocol.ack_code.values}
        return [f"{type_name(model.protocol.ack_code.name)}::{constant(names_of[c])}" for c in d.ack_codes]

    def layouts(f: m.Field) -> int:
        """How many layouts the descriptor has."""
        return len(model.candidates(f.set, f.descriptor))

    def original(f: m.Field) -> m.Field:
        found = model.field(f.definition) if f.definition else f
        assert found is not None
        return found

    def structs(types: Iterable[m.Type]) -> list[m.Struct]:
        return [t for t in types if isinstance(t, m.Struct)]

    def supported(d: m.Device) -> list[tuple[m.Field, str]]:
        """The fields of a device, each with the letters of the functions that it takes there."""
        letters = dict(d.functions)
        found = []
        for name in d.fields:
            f = model.field(name)
            assert f is not None
            found.append((f, letters.get(name, "".join(x.letter for x in f.functions))))
        return found

    def group_members(op: m.GroupOp, record: Record) -> list[Member]:
        return [x for x in names.members(record) if x.group is op]

    def tag_of(op: m.SwitchOp, record: Record) -> Member:
        return next(x for x in names.members(record) if x.parameter.name == op.tag)

    def default_case(op: m.SwitchOp) -> m.Case | None:
        return next((c for c in op.cases if c.tag.value == 0), None)

    def qualified(name: str, where: str) -> str:
        return f"types::{name}" if where == "types" else f"crate::{where}::{name}"

    def functions_by(f: m.Field, letters: str) -> list[str]:
        return [constant(x.name) for x in f.functions if x.letter in letters]

    offered: list[Callable[..., Any]] = [
        ack_codes, arm, assign, base_rates, bits_type, bounds, byte_constants, commands_of, condition, condition_value,
        constant, conversions, declaration, default_case, defaults, derives_default, doc, fit, functions_by,
        group_members, home, if_let, imports, inner, is_long, is_plain, layouts, limits, link, linked, listing,
        names.accessors, names.constructors, names.members, names.rust, names.unions_of, original, path, ports, prose,
        qualified, quoted, readings, required_arms, scalar, selected, set_pattern, set_range, structs, supported,
        tag_of, tidy, type_name, variant, variants, wrap,
    ]  # fmt: skip
    plain: dict[str, Callable[..., Any]] = {
        "module": module,
        "method": method,
        "member": member,
        "hex": lambda n: f"0x{n:02X}",
        "some": lambda name: f"Some({name})",
        "reference": lambda name: f"&{name}",
        "replies": lambda f: model.replies(f),
        "condition_text": lambda c: f"`{c.parameter}` is {c.label}",
    }
    return plain | {f.__name__: f for f in offered}


# --------------------------------------------------------------------------- identifiers


def identifiers(model: m.Model) -> Iterable[Identifier]:
    names = Names(model)
    for fixed in LANGUAGE["modules"]:
        yield Identifier("the crate", fixed, f"the module {fixed}", None)
    for s in model.sets:
        yield Identifier("the crate", module(s.name), s.name, s.position)
    everything = (*model.types, model.protocol.function_selector, *(t for s in model.sets for t in s.types))
    for t in everything:
        position = None if isinstance(t, m.Vector) else t.position
        yield Identifier(home(t), type_name(t.name), t.name, position)
        yield from _inside(names, t)
    for s in model.sets:
        for f in s.fields:
            yield Identifier(module(s.name), type_name(f.name), f.full_name, f.position)
            yield Identifier("registry", type_name(f"{s.name}_{f.name}"), f.full_name, f.position)
            if len(f.responses) > 1:
                several = f"the responses of {f.full_name}"
                yield Identifier(module(s.name), type_name(f"{f.name}_responses"), several, f.position)
                for name, kind in variants(f):
                    yield Identifier(several, name, kind, f.position)
        for f in s.own_fields:
            yield from _record(names, f, f.full_name)
    for here, name, op, record in names.unions:
        yield Identifier(here, name, f"the union {op.member} of {record.name}", record.position)
        yield Identifier(f"{here}::{name}", "Other", "an unknown tag", record.position)
        for case in op.cases:
            yield Identifier(f"{here}::{name}", variant(case.tag.name), case.tag.name, record.position)
    for d in model.devices:
        yield Identifier("devices", constant(d.name), d.name, d.position)


def _inside(names: Names, t: m.Type) -> Iterator[Identifier]:
    where = f"{home(t)}::{type_name(t.name)}"
    match t:
        case m.Enum():
            for v in t.values:
                yield Identifier(where, constant(v.name), v.name, t.position)
        case m.Bitfield():
            for b in t.bits:
                for name in (constant(b.name), method(b.name), f"set_{b.name}", f"with_{b.name}"):
                    yield Identifier(where, name, b.name, t.position)
        case m.Vector():
            for e in t.elements:
                yield Identifier(where, member(e), e, None)
        case m.Struct():
            yield from _record(names, t, t.name)


def _record(names: Names, record: Record, what: str) -> Iterator[Identifier]:
    for x in names.members(record):
        yield Identifier(what, x.name, x.parameter.name, x.parameter.position)
    for c in names.constructors(record):
        yield Identifier(f"the methods of {what}", c.name, c.name, record.position)
    for a in names.accessors(record):
        yield Identifier(f"the methods of {what}", a.name, a.name, record.position)
