"""C99: one header and one source for each descriptor set, on a small core."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from .. import codec
from .. import model as m
from ..naming import Escape, Identifier, upper
from ..render import ROOT, File, language
from ..replies import replies

TITLE = "C99, library mip"
WIDTH = 100

_RUNTIME = ROOT / "templates/c/runtime"
_LANGUAGE = language("c")
_SCALARS: dict[str, tuple[str, int]] = {k: (v[0], v[1]) for k, v in _LANGUAGE["scalars"].items()}
_KEYWORDS = frozenset(_LANGUAGE["keywords"])
_member = Escape(_KEYWORDS | frozenset(_LANGUAGE["members"]), digit_prefix="n")
_module = Escape(frozenset(_LANGUAGE["modules"]), digit_prefix="")

Record = m.Field | m.Struct


def files(model: m.Model) -> Iterator[File]:
    scalars = [(name, *of) for name, of in _SCALARS.items()]
    yield File("include/mip/core.h", "core.h.j2", {"scalars": scalars, "max_field_data": m.MAX_FIELD_DATA})
    for name in ("types", "protocol"):
        yield File(f"include/mip/{name}.h", f"{name}.h.j2")
        yield File(f"src/{name}.c", f"{name}.c.j2")
    for s in model.sets:
        yield File(f"include/mip/{module(s.name)}.h", "set.h.j2", {"set": s})
        if has_code(s):
            yield File(f"src/{module(s.name)}.c", "set.c.j2", {"set": s})
    yield File("src/registry.c", "registry.c.j2")
    yield File("src/reflection.c", "reflection.c.j2")
    yield File("include/mip/devices.h", "devices.h.j2")
    yield File("src/devices.c", "devices.c.j2")
    taste = model.taste("taste.c")
    if taste:
        yield File("taste.c", "verbatim.j2", {"text": taste})
    shown = {"taste": taste.partition("*/\n")[2].rstrip(), "client": model.taste("client.c").rstrip()}
    yield File("README.md", "README.md.j2", shown)
    yield File("CMakeLists.txt", "CMakeLists.txt.j2", {"sources": _sources(model)})


def _sources(model: m.Model) -> list[str]:
    """The names of all sources: those that are made, and those that are copied."""
    copied = [path.stem for path in (_RUNTIME / "src").glob("*.c")]
    made = ["devices", "protocol", "reflection", "registry", "types"]
    return sorted([*copied, *made, *(module(s.name) for s in model.sets if has_code(s))])


def has_code(s: m.Set) -> bool:
    """Sets that only repeat others' fields need no source."""
    return bool(s.own_fields) or any(isinstance(t, m.Struct) for t in s.types)


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Everything is in one scope in C, but for the members of structures."""
    for name in (*(f"mip_{n}" for n in _LANGUAGE["runtime"]), *(f"MIP_{n}" for n in _LANGUAGE["constants"])):
        yield Identifier("C", name, f"{name} of the core", None)
    for t in (*model.types, model.protocol.function_selector):
        yield from _type_identifiers(t)
    yield from _field_identifiers(model.protocol.acknowledge)
    for s in model.sets:
        yield Identifier("include/mip", module(s.name), f"set {s.name}", s.position)
        yield Identifier("C", f"{macro(f'mip_{s.name}')}_SET", f"set {s.name}", s.position)
        for t in s.types:
            yield from _type_identifiers(t)
        for f in s.fields:
            yield from _field_identifiers(f)
    for d in model.devices:
        yield Identifier("C", f"mip_device_{d.name}", f"device {d.id}", d.position)


def _type_identifiers(t: m.Type) -> Iterator[Identifier]:
    name, place = type_name(t), getattr(t, "position", None)
    yield Identifier("C", name, t.name, place)
    if isinstance(t, m.Enum):
        for v in t.values:
            yield Identifier("C", constant(t, v), f"{t.name}.{v.name}", place)
    elif isinstance(t, m.Bitfield):
        for b in t.bits:
            if t.scalar:
                yield Identifier("C", constant(t, b), f"{t.name}.{b.name}", place)
            for accessor in ("get", "set") if has_accessor(t, b) else ():
                yield Identifier("C", f"{name}_{accessor}_{b.name}", f"{t.name}.{b.name}", place)
    elif isinstance(t, m.Struct):
        for function in ("read", "write"):
            yield Identifier("C", f"{name}_{function}", t.name, place)
        yield from _member_identifiers(t)


def _field_identifiers(f: m.Field) -> Iterator[Identifier]:
    name = field_name(f)
    yield Identifier("C", name, f.full_name, f.position)
    for end in ("DESCRIPTOR", "NAME", *(macro(f"with_{p.name}") for p, _ in presence(f))):
        yield Identifier("C", f"{macro(name)}_{end}", f.full_name, f.position)
    for end in ("codec", "decode", "encode", *(c.name for c in constructors(f))):
        yield Identifier("C", f"{name}_{end}", f.full_name, f.position)
    yield from _member_identifiers(f)


def _member_identifiers(record: Record) -> Iterator[Identifier]:
    scope = f"struct {record_name(record)}"
    for p in stored(record):
        yield Identifier(scope, _member(p.name), p.name, p.position)
        if p.length == "rest":
            yield Identifier(scope, f"{_member(p.name)}_count", p.name, p.position)
        if p.element is None:
            yield Identifier("C", union_name(record, p), p.name, p.position)
            for member in union_members(p):
                yield Identifier(f"union {union_name(record, p)}", _member(member.name), member.name, p.position)


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {
        "module": module,
        "macro": macro,
        "member": _member,
        "hex": lambda n: f"0x{n:02X}",
        "version_number": version_number,
        "type": type_name,
        "spelled": spelled,
        "field": field_name,
        "record": record_name,
        "constant": constant,
        "literal": literal,
        "mask": mask,
        "has_accessor": has_accessor,
        "bits_type": bits_type,
        "stored": stored,
        "optional": lambda record: isinstance(record, m.Field) and record.optional,
        "functions": lambda record: isinstance(record, m.Field) and record.functions,
        "declare": declare,
        "inside": inside,
        "union": union_name,
        "union_members": union_members,
        "item_size": lambda op: codec.size_of(op.item) if isinstance(op, m.ArrayOp) else 1,
        "presence": presence,
        "required": required_table,
        "constructors": constructors,
        "assignment": assignment,
        "silent": silent,
        "asked": lambda f: asked(f, model),
        "milliseconds": lambda seconds: round(seconds * 1000) if seconds else 0,
        "in_order": lambda s: list(_in_order(s)),
        "repeated": lambda s: list(repeated(s, model)),
        "comment": comment,
        "paragraphs": paragraphs,
        "type_paragraphs": lambda t: [t.description, *cites(t)],
        "meaning": meaning,
        "bits_meaning": bits_meaning,
        "case_meaning": case_meaning,
        "repeated_paragraphs": repeated_paragraphs,
        "function": function,
        "string": string,
        "text": str,
        "bare": bare,
        "fill": fill,
        "assign": assign,
        "declared": declared,
        "table": table,
        "define": define,
        "entries": entries,
        "links": links,
        "all_types": lambda of: [*of.types, *(t for s in of.sets for t in s.types)],
        "names": names_of,
        "spec_name": lambda t: f"{t.owner}.{t.name}" if t.owner else t.name,
        "reflected": reflected,
        "reflection": reflection,
        "readings": readings,
        "device_fields": lambda d: device_fields(d, model),
        "set_number": lambda name: next(s.number for s in model.sets if s.name == name),
        "decimal": lambda x: repr(float(x)) if isinstance(x, float) else str(x),
    }


# --------------------------------------------------------------------------- names


def module(name: str) -> str:
    return _module(name)


def macro(name: str) -> str:
    return upper(name)


def version_number(version: str) -> int:
    """
    >>> version_number("1.2.3")
    10203
    """
    major, minor, patch = (int(part) for part in re.split(r"[.+-]", version)[:3])
    return 10000 * major + 100 * minor + patch


def type_name(t: m.Type) -> str:
    """The name of a type, after its set; a set's name is not said twice."""
    owner = getattr(t, "owner", None)
    return f"mip_{owner}_{t.name.removeprefix(f'{owner}_')}" if owner else f"mip_{t.name}"


def field_name(f: m.Field) -> str:
    return f"mip_{f.set_name}_{f.name}"


def record_name(record: Record) -> str:
    return field_name(record) if isinstance(record, m.Field) else type_name(record)


def union_name(record: Record, p: m.Parameter) -> str:
    return f"{record_name(record)}_{p.name}"


def constant(t: m.Enum | m.Bitfield, value: m.EnumValue | m.Bits) -> str:
    return macro(f"{type_name(t)}_{value.name}")


def spelled(e: m.Scalar | m.Type) -> str:
    """The C type of one item; of a vector, that of its elements."""
    match e:
        case m.Scalar():
            return _SCALARS[e.name][0]
        case m.Vector():
            return _SCALARS[e.scalar.name][0]
        case m.Enum() | m.Bitfield(scalar=m.Scalar()):
            return type_name(e)
        case _:
            return f"struct {type_name(e)}"


# --------------------------------------------------------------------------- numbers


def literal(value: int, size: int) -> str:
    """
    >>> literal(3, 1), literal(0xFFFF0000, 4), literal(1, 8)
    ('3', 'UINT32_C(0xFFFF0000)', 'UINT64_C(1)')
    """
    text = str(value) if value < 0x8000 else f"0x{value:X}"
    return f"UINT64_C({text})" if size == 8 else f"UINT32_C({text})" if value > 0x7FFF and size == 4 else text


def mask(t: m.Bitfield, b: m.Bits) -> str:
    """Wide enough that its complement clears nothing else."""
    text = f"0x{b.mask:0{2 * t.size}X}"
    return f"UINT{8 * t.size}_C({text})" if t.size > 2 else f"{text}U"


def bits_type(b: m.Bits) -> str:
    """The type of a number inside a bitfield."""
    if b.width == 1:
        return "bool"
    return type_name(b.enum) if b.enum else f"uint{next(n for n in (8, 16, 32, 64) if b.width <= n)}_t"


def has_accessor(t: m.Bitfield, b: m.Bits) -> bool:
    """Flags of a number are constants; numbers inside a bitfield, and bits of bytes, need functions."""
    return t.scalar is None or (b.width > 1 and not b.alias)


# --------------------------------------------------------------------------- members


def stored(record: Record) -> list[m.Parameter]:
    """The parameters that have a member: no constants, and no unions without alternatives."""
    return [p for p in record.parameters if p.constant is None and (p.element is not None or union_members(p))]


def union_members(p: m.Parameter) -> list[m.Parameter]:
    """The alternatives of a union that hold something."""
    return [c.parameter for c in p.cases if c.parameter is not None]


def dimensions(op: m.Operation) -> str:
    """The brackets behind a member's name."""
    if isinstance(op, m.TextOp):
        return f"[{op.capacity + 1}]"
    if isinstance(op, m.ArrayOp):
        return f"[{max(1, op.capacity)}]{dimensions(op.item)}"
    return ""


def inside(p: m.Parameter) -> str:
    """What comes before an alternative's name: one that fills the field stands beside its count."""
    return f"{_member(p.name)}." if p.length == "rest" else ""


def declare(p: m.Parameter, record: Record) -> str:
    """A member: `float bias[3]`."""
    if p.element is None:
        return f"union {union_name(record, p)} {_member(p.name)}"
    return f"{spelled(p.element)} {_member(p.name)}{dimensions(p.operation)}"


def presence(f: m.Field) -> list[tuple[m.Parameter, int]]:
    """The parameters that no function requires, and the number of parameters when they are the last ones."""
    last = {i.member: g.last for g in f.operations if isinstance(g, m.GroupOp) for i in g.body}  # type: ignore[union-attr]
    return [(p, last[p.name]) for p in stored(f) if p.optional and not p.counts]


def required_table(f: m.Field) -> str:
    """How many parameters each function requires, by its value."""
    counts = dict(f.required)
    return ", ".join(str(counts.get(i, 0)) for i in range(max(counts, default=0) + 1))


# --------------------------------------------------------------------------- constructors


class Constructor:
    """One function of a command, or the whole of a command without functions."""

    def __init__(self, f: m.Field, function: m.Function | None) -> None:
        letter = function.letter if function else ""
        self.name = function.name if function else "make"
        self.function = function
        self.description = function.description if function else f"{f.title}."
        members = [p for p in stored(f) if not p.selector]
        wanted = [p for p in members if (letter in (p.functions or "") if letter else not p.optional)]
        self.asked = [p for p in wanted if p.reserved is None]
        self.assigned = [p for p in members if p in self.asked or (p.reserved and (p in wanted or p.optional))]
        self.arguments = [argument(p, f) for p in self.asked]


def constructors(f: m.Field) -> list[Constructor]:
    if f.role != m.COMMAND:
        return []
    if f.functions:
        return [Constructor(f, function) for function in f.functions]
    return [Constructor(f, None)] if any(p.reserved is None for p in stored(f)) else []


def argument(p: m.Parameter, f: m.Field) -> str:
    name, op = _member(p.name), p.operation
    if p.element is None:
        return f"const union {union_name(f, p)} *{name}"
    one = spelled(p.element)
    count = f"uint8_t {name}_count, " if p.length == "rest" else ""
    if isinstance(op, m.TextOp):
        return f"{count}const char *{name}"
    if isinstance(op, m.ArrayOp):
        first = f"[{op.count}]" if op.count is not None else "[]"
        return f"{count}const {one} {name}{first}{dimensions(op.item)}"
    return f"const {one} *{name}" if one.startswith("struct ") else f"{one} {name}"


def assignment(p: m.Parameter) -> list[str]:
    """How a constructor gives a member its value."""
    name, op = _member(p.name), p.operation
    if p.reserved is not None:
        if p.length is None:
            return [f"v.{name} = {p.reserved};"]
        return [f"v.{name}[{i}] = {p.reserved};" for i in range(op.capacity)]  # type: ignore[union-attr]
    if p.element is None:
        return [f"if ({name} != NULL) {{", f"    v.{name} = *{name};", "}"]
    if isinstance(op, (m.ArrayOp, m.TextOp)):
        if op.count is not None:
            size = f"sizeof(v.{name})"
            text = isinstance(op, m.TextOp)
            return [f"mip_copy_text(v.{name}, {size}, {name});" if text else f"memcpy(v.{name}, {name}, {size});"]
        count = _member(op.counter) if op.counter else f"{name}_count"
        size = f"sizeof(v.{name}) - 1" if isinstance(op, m.TextOp) else f"sizeof(v.{name})"
        number = [f"v.{count} = {count};"] if not op.counter else []
        call = [f"v.{name}", size, name, f"{count} * sizeof({name}[0])"]
        return [*number, function("    mip_copy(", call, ");").lstrip()]
    return [f"v.{name} = {'*' if spelled(p.element).startswith('struct ') else ''}{name};"]


def silent(f: m.Field) -> str:
    """When a command is not answered, as a condition on the structure `v`."""
    tests = [f"v->function == {macro('mip_function_selector')}_{macro(x.name)}" for x in f.functions if not x.reply]
    if f.silent_when:
        tests.append(" && ".join(f"v->{_member(c.parameter)} == {c.value}" for c in f.silent_when))
    if len(tests) > 1:
        tests = [f"({t})" if "&&" in t else t for t in tests]
    return " || ".join(tests)


def asked(f: m.Field, model: m.Model) -> list[tuple[str, m.Field]]:
    """The responses of a command, each with the condition on the structure `v` under which it is sent."""
    found = []
    for reply in replies(f, model):
        functions = [f"v->function == {macro('mip_function_selector')}_{macro(x.name)}" for x in reply.functions]
        tests = [" || ".join(functions)] if functions else []
        tests += [f"v->{_member(c.parameter)} == {c.value}" for c in reply.when]
        if len(tests) > 1:
            tests = [f"({t})" if "||" in t else t for t in tests]
        found.append((" && ".join(tests), reply.response))
    return found


# --------------------------------------------------------------------------- order


def _in_order(s: m.Set) -> Iterator[m.Field]:
    """Each command with the responses that it owns behind it."""
    for f in s.own_fields:
        if f.role != m.RESPONSE:
            yield f
            yield from (r for r in s.own_fields if r.role == m.RESPONSE and r.command == f.name)


def repeated(s: m.Set, model: m.Model) -> Iterator[tuple[m.Field, m.Field]]:
    """The fields that repeat another set's, with what they repeat."""
    for f in s.fields:
        if f.definition:
            original = model.field(f.definition)
            assert original is not None
            yield f, original


# --------------------------------------------------------------------------- text


def comment(text: str | Sequence[str], indent: int = 0, opening: str = "/**") -> str:
    """A comment of paragraphs, on one line if it fits."""
    pad = " " * indent
    parts = [text] if isinstance(text, str) else [t for t in text if t]
    parts = [" ".join(t.split()).replace("*/", "* /").replace("/*", "/ *") for t in parts]
    if len(parts) == 1 and len(pad) + len(parts[0]) + len(opening) + 4 <= WIDTH:
        return f"{opening} {parts[0]} */"
    lines = [f"{opening}"]
    for i, part in enumerate(parts):
        item = part.startswith("- ")
        if i and not (item and parts[i - 1].startswith("- ")):
            lines.append(f"{pad} *")
        lines += textwrap.wrap(
            part, WIDTH, initial_indent=f"{pad} * ", subsequent_indent=f"{pad} * " + "  " * item,
            break_long_words=False, break_on_hyphens=False,
        )  # fmt: skip
    return "\n".join([*lines, f"{pad} */"])


def cites(thing: Any) -> list[str]:
    sources = getattr(thing, "sources", ())
    return [f"- {s.manual}: {s.section}" for s in sources]


def _list(words: Sequence[str], last: str = "and") -> str:
    """
    >>> _list(["a", "b", "c"])
    'a, b and c'
    """
    return " ".join([", ".join(words[:-1]), last, words[-1]]) if len(words) > 1 else "".join(words)


def paragraphs(f: m.Field) -> list[str]:
    """The description of a field."""
    place = f"(0x{f.set:02X},0x{f.descriptor:02X})" if f.set else f"0x{f.descriptor:02X}"
    facts = [
        f"Deprecated: {f.deprecated}." if f.deprecated else "",
        "For advanced use." if f.advanced else "",
        f"Functions: {_list([x.name for x in f.functions])}." if f.functions else "",
        f"Answered by {_list([f'mip_{f.set_name}_{r}' for r in f.responses], 'or')}." if f.responses else "",
        f"Sent if {_conditions(f.when)}." if f.when else "",
        f"Not acknowledged if {_conditions(f.silent_when)}." if f.silent_when else "",
        f"The device may take {f.timeout:g} s to answer." if f.timeout else "",
        f"Sent at {f.max_rate:g} Hz at most." if f.max_rate else "",
        f"Supported by {_list(f.devices)}." if f.devices else "",
    ]
    text = [f.description, *f.notes, " ".join(x for x in facts if x)]
    return [f"{f.title}: {f.role} {place}.", *text, *cites(f)]


def _conditions(conditions: Sequence[m.Condition]) -> str:
    return _list([f"{c.parameter} is {c.label}" for c in conditions])


def repeated_paragraphs(f: m.Field, original: m.Field) -> list[str]:
    place = f"(0x{f.set:02X},0x{f.descriptor:02X})"
    return [f"{f.title}: {f.role} {place}.", f"The same field as {field_name(original)}.", *cites(f)]


def bits_meaning(b: m.Bits) -> str:
    place = f"Bit {b.first}" if b.width == 1 else f"Bits {b.first} to {b.last}"
    return f"{place}: {b.description}" if b.description else f"{place}."


def case_meaning(member: m.Parameter, p: m.Parameter) -> str:
    """The description of an alternative of the union `p`."""
    tag = next(c.tag.name for c in p.cases if c.parameter is member)
    text = meaning(member, None)
    return f"If {_member(p.tag or '')} is {tag}" + (f": {text}" if text else ".")


def meaning(p: m.Parameter, record: Record | None) -> str:
    """The description of a member, in one paragraph."""
    parts = [p.description]
    if p.counts and not p.description:
        parts.append(f"Elements of {_member(p.counts)}.")
    if isinstance(p.element, m.Vector):
        parts.append(f"Elements: {', '.join(p.element.elements)}.")
    if p.units:
        parts.append(f"Unit{'s' if len(p.units) > 1 else ''}: {', '.join(p.units)}.")
    if p.frame:
        parts.append(f"Frame: {p.frame}.")
    if p.minimum is not None and p.maximum is not None:
        parts.append(f"Range: {p.minimum} to {p.maximum}.")
    elif p.minimum is not None or p.maximum is not None:
        parts.append(f"At least {p.minimum}." if p.minimum is not None else f"At most {p.maximum}.")
    if p.default is not None:
        parts.append(f"Default: {_plain(p.default)}.")
    if p.valid and record:
        parts.append(_valid(p.valid, record))
    if p.reading:
        parts += _readings(p.reading)
    if p.reserved:
        parts.append(f"Send {p.reserved}.")
    if isinstance(record, m.Field) and record.functions and not p.selector:
        wanted = [x.name for x in record.functions if x.letter in (p.functions or "")]
        if len(wanted) < len(record.functions):
            parts.append(f"For {_list(wanted)}." if wanted else "Optional.")
    elif p.optional:
        parts.append("May be absent.")
    if p.deprecated:
        parts.append("Deprecated.")
    return " ".join(t for t in (*parts, *p.remarks) if t)


def _plain(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return ", ".join(map(_plain, value)) if isinstance(value, (list, tuple)) else str(value)


def _valid(paths: Sequence[str], record: Record) -> str:
    """The bits that vouch for a value, or for each of its elements."""
    found: dict[str, list[str]] = {}
    for path in dict.fromkeys(paths):
        flags, _, bit = path.partition(".")
        e = next(p.element for p in record.parameters if p.name == flags)
        known = [b for b in e.bits if b.name == bit] if isinstance(e, m.Bitfield) and e.scalar else []
        name = constant(e, known[0]) if known and isinstance(e, m.Bitfield) else bit
        found.setdefault(_member(flags), []).append(name)
    bits = _list([f"{_list(names)} in {flags}" for flags, names in found.items()])
    return f"Valid if {bits} is set." if len(dict.fromkeys(paths)) == 1 else f"Each valid by its bit: {bits}."


def _readings(reading: m.Reading) -> list[str]:
    if reading.by == "device":
        return [f"On the {key}: {type_name(t)}." for key, t in reading.types]
    return [f"If {_member(reading.by)} is {key}: {type_name(t)}." for key, t in reading.types]


def function(head: str, arguments: Sequence[str], tail: str) -> str:
    """A function's head, or a call: on one line, or broken where it hurts least."""
    arguments = arguments or ["void"]
    pad = len(head) - len(head.lstrip()) + 4
    kind, _, name = head.rpartition(" ")
    tries = [
        f"{head}{', '.join(arguments)}{tail}",
        f"{head}{fill(arguments, len(head), len(tail))}{tail}",
        f"{head}\n{' ' * pad}{fill(arguments, pad, len(tail))}{tail}",
    ]
    if (kind.strip() and arguments == ["void"]) or not _fits(tries[-1]):
        tries[1:] = [
            f"{kind}\n{name}{fill(arguments, len(name), len(tail))}{tail}",
            f"{kind}\n{name}\n{' ' * pad}{fill(arguments, pad, len(tail))}{tail}",
        ]
    return next((t for t in tries if _fits(t)), tries[-1])


def _fits(text: str) -> bool:
    return all(len(line) <= WIDTH for line in text.splitlines())


def assign(left: str, right: str) -> str:
    """An assignment inside a function, on two lines if it must."""
    flat = f"{left} = {right};"
    return flat if len(flat) + 4 <= WIDTH else f"{left} =\n        {right};"


def declared(left: str, right: str) -> str:
    return f"{left} {right}" if len(f"{left} {right}") <= WIDTH else f"{left}\n    {right}"


def table(name: str, values: str) -> str:
    flat = f"{name}[] = {{{values}}};"
    return flat if len(flat) <= WIDTH else f"{name}[] = {{\n    {values}}};"


def define(name: str, text: str) -> str:
    flat = f"#define {name} {text}"
    return flat if len(flat) <= WIDTH else f"#define {name} \\\n    {text}"


def fill(items: Sequence[str], indent: int, more: int = 0) -> str:
    """Items with commas between them, on as many lines as they need; long strings are taken apart."""
    lines = [""]
    for i, item in enumerate(items):
        last = i == len(items) - 1
        text, room = (item, WIDTH - indent - more) if last else (f"{item},", WIDTH - indent)
        if item.startswith('"') and len(text) > room:
            lines += [*_pieces(text, room), ""]
        elif lines[-1] and len(lines[-1]) + 1 + len(text) > room:
            lines.append(text)
        else:
            lines[-1] = f"{lines[-1]} {text}".lstrip()
    return ("\n" + " " * indent).join(line for line in lines if line)


def _pieces(text: str, width: int) -> list[str]:
    """A long string as several that the compiler joins."""
    end = text.rindex('"')
    pieces = textwrap.wrap(text[1:end], width - 4, break_long_words=False, break_on_hyphens=False)
    return [*(f'"{piece} "' for piece in pieces[:-1]), f'"{pieces[-1]}{text[end:]}']


def string(text: str | None) -> str:
    """
    >>> string('a "b" °')
    '"a \\\\"b\\\\" \\\\302\\\\260"'
    """
    if text is None:
        return "NULL"
    out = ""
    for byte in " ".join(text.split()).encode("utf-8"):
        out += {0x22: '\\"', 0x5C: "\\\\"}.get(byte, chr(byte) if 0x20 <= byte < 0x7F else f"\\{byte:03o}")
    return f'"{out.replace("??", "?" + chr(92) + "?")}"'


# --------------------------------------------------------------------------- registry


def entries(model: m.Model) -> list[m.Field]:
    """All fields as the registry holds them: by set, descriptor, and the order of the specification."""
    return sorted((model.protocol.acknowledge, *model.fields), key=lambda f: (f.set, f.descriptor))


def links(model: m.Model) -> list[tuple[int, list[int]]]:
    """For each entry, where its links begin, and the entries of its responses or commands."""
    order = entries(model)
    index = {f.full_name: i for i, f in enumerate(order)}
    found, first = [], 0
    for f in order:
        linked = [index[f"{f.set_name}.{name}"] for name in f.responses]
        linked += [i for i, other in enumerate(order) if other.set == f.set and f.name in other.responses]
        found.append((first, linked))
        first += len(linked)
    return found


# --------------------------------------------------------------------------- reflection


def bare(thing: m.Type | m.Field) -> str:
    """A name without the prefix of the library, for what stays inside of a source."""
    return (field_name(thing) if isinstance(thing, m.Field) else type_name(thing)).removeprefix("mip_")


def names_of(t: m.Type) -> str:
    """The table that names the values or bits of a type."""
    return f"names_{bare(t)}"


def _groups(record: Record) -> dict[str, int]:
    """The number of parameters that are there when this one is; fields have them alone."""
    if not isinstance(record, m.Field):
        return {}
    return {i.member: g.last for g in record.operations if isinstance(g, m.GroupOp) for i in g.body}  # type: ignore[union-attr]


_KINDS = {
    m.ScalarOp: "NUMBER",
    m.ConstantOp: "CONSTANT",
    m.CounterOp: "COUNTER",
    m.TextOp: "TEXT",
    m.BitsOp: "BITS",
    m.StructOp: "STRUCT",
    m.SwitchOp: "UNION",
}


def reflected(p: m.Parameter, record: Record, union: m.Parameter | None = None) -> list[str]:
    """The members of struct mip_parameter; `union`: of an alternative, the union that holds it."""
    item, elements = p.operation, 1
    while isinstance(item, m.ArrayOp):
        if isinstance(p.element, m.Vector) and isinstance(item.item, m.ScalarOp):
            elements = item.count or 1
        item = item.item
    name, full = (inside(p) if union else "") + _member(p.name), bare(record)
    home = f"union {union_name(record, union)}" if union else f"struct {record_name(record)}"
    numbers = {q.name: i for i, q in enumerate(record.parameters)}
    by = p.tag or p.counts or (p.length if isinstance(p.length, str) else None)
    e, op = p.element, p.operation
    scalar = upper(item.scalar.name) if isinstance(item, (m.ScalarOp, m.ConstantOp, m.CounterOp)) else "U8"
    length = {int: "FIXED", str: "REST" if p.length == "rest" else "COUNTED"}.get(type(p.length), "ONE")
    return [
        string(p.name),
        string(", ".join(p.units)),
        f"MIP_KIND_{_KINDS[type(item)]}",
        f"MIP_SCALAR_{scalar}",
        f"MIP_LENGTH_{length}",
        str(op.capacity if isinstance(op, (m.ArrayOp, m.TextOp)) and p.length is not None else 1),
        str(elements),
        str(numbers.get(by or "", 0)),
        str(0 if union else _groups(record).get(p.name, 0)),
        literal(p.constant or 0, item.scalar.size if isinstance(item, m.ConstantOp) else 1),
        f"{'ONE' if p.length is None else 'MANY'}({home}, {name})" if union or p in stored(record) else "0, 0",
        f"offsetof({home}, {name}_count)" if p.length == "rest" else "0",
        f"&{names_of(e)}" if isinstance(e, (m.Enum, m.Bitfield)) else "NULL",
        f"readings_{full}_{p.name}" if p.reading and not union else "NULL",
        f"&record_{bare(e)}" if isinstance(e, m.Struct) else "NULL",
        f"cases_{full}_{p.name}" if p.cases else "NULL",
        str(len(p.reading.types) if p.reading and not union else len(p.cases)),
    ]


def reflection(f: m.Field) -> list[str]:
    """The members of struct mip_reflection."""
    name = field_name(f)
    required = f"required_{bare(f)}"
    return [
        f"&{name}_codec",
        f"&record_{bare(f)}",
        "true" if f.functions else "false",
        "true" if f.optional else "false",
        required if f.functions else "NULL",
        f"sizeof({required})" if f.functions else "0",
        f"offsetof(struct {name}, present)" if f.optional else "0",
    ]


def readings(p: m.Parameter, record: Record) -> list[tuple[str | None, int, int, m.Type]]:
    """Device, or index and value of the parameter that decides; and the type."""
    assert p.reading is not None
    if p.reading.by == "device":
        return [(key, 0, 0, t) for key, t in p.reading.types]
    index = next(i for i, q in enumerate(record.parameters) if q.name == p.reading.by)
    sibling = record.parameters[index].element
    assert isinstance(sibling, m.Enum)
    values = {v.name: v.value for v in sibling.values}
    return [(None, index, values[key], t) for key, t in p.reading.types]


# --------------------------------------------------------------------------- devices


def device_fields(d: m.Device, model: m.Model) -> list[tuple[int, int, str, str]]:
    """Set, descriptor, function letters and name of what a device supports."""
    letters = dict(d.functions)
    found = []
    for name in d.fields:
        f = model.field(name)
        assert f is not None
        usual = "".join(x.letter for x in f.functions)
        found.append((f.set, f.descriptor, letters.get(name, usual), name))
    return sorted(found)
