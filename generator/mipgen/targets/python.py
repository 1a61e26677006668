"""Python: a package of dataclasses on the standard library alone."""

from __future__ import annotations

import re
import struct
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .. import model as m
from ..naming import Escape, Identifier, pascal, upper
from ..render import File, language
from ..replies import replies

TITLE = "Python >= 3.10, package mip_protocol"
WIDTH = 100

_LANGUAGE = language("python")
_SCALARS: dict[str, tuple[str, str]] = {k: (v[0], v[1]) for k, v in _LANGUAGE["scalars"].items()}
_KEYWORDS = frozenset(str(k) for k in _LANGUAGE["keywords"])
_member = Escape(_KEYWORDS | frozenset(_LANGUAGE["members"]), digit_prefix="n")
_property = Escape(_KEYWORDS | frozenset(_LANGUAGE["bits"]), digit_prefix="n")
_module = Escape(_KEYWORDS | frozenset(_LANGUAGE["modules"]), digit_prefix="mip_")
_class = Escape(_KEYWORDS | frozenset(str(k) for k in _LANGUAGE["classes"]), digit_prefix="Mip")
_constant = Escape(frozenset(), digit_prefix="N")


def files(model: m.Model) -> Iterator[File]:
    package = "mip_protocol"
    yield File("pyproject.toml", "pyproject.toml.j2")
    taste = model.taste("taste.py")
    if taste:
        yield File("taste.py", "verbatim.j2", {"text": taste})
    shown = {"taste": taste.partition('"""\n\n')[2].rstrip(), "client": model.taste("client.py").rstrip()}
    yield File("README.md", "README.md.j2", shown)
    yield File(f"{package}/__init__.py", "init.py.j2")
    yield File(f"{package}/types.py", "types.py.j2")
    yield File(f"{package}/protocol.py", "protocol.py.j2")
    for s in model.sets:
        yield File(f"{package}/{module(s.name)}.py", "set.py.j2", {"set": s})
    yield File(f"{package}/registry.py", "registry.py.j2")
    yield File(f"{package}/reflection.py", "reflection.py.j2")
    yield File(f"{package}/devices.py", "devices.py.j2")


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for s in model.sets:
        yield Identifier("mip_protocol", module(s.name), f"set {s.name}", s.position)
        yield from _classes(s.name, [*s.types, *s.fields])
    yield from _classes("types", model.types)
    for d in model.devices:
        yield Identifier("mip_protocol.devices", upper(d.name), f"device {d.id}", d.position)


def _classes(scope: str, things: Sequence[m.Type | m.Field]) -> Iterator[Identifier]:
    for t in things:
        place = getattr(t, "position", None)
        yield Identifier(f"module {scope}", class_name(t), f"{scope}.{t.name}", place)
        inner = f"class {scope}.{class_name(t)}"
        if isinstance(t, m.Enum):
            for v in t.values:
                yield Identifier(inner, constant(v.name), v.name, place)
        elif isinstance(t, m.Bitfield):
            for b in t.bits:
                yield Identifier(inner, constant(b.name), b.name, place)
        elif isinstance(t, (m.Field, m.Struct)):
            for p in stored(t):
                yield Identifier(inner, _member(p.name), p.name, p.position)
            for f in t.functions if isinstance(t, m.Field) else ():
                yield Identifier(inner, _member(f.name), f"function {f.name}", place)


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {
        "module": module,
        "class": class_name,
        "constant": constant,
        "member": _member,
        "property": _property,
        "upper": upper,
        "stored": stored,
        "plan": plan,
        "begun": begun,
        "hint": hint,
        "default": default,
        "keyword_only": keyword_only,
        "docstring": docstring,
        "call": call,
        "with_imports": lambda body, s=None: with_imports(body, s, model),
        "response_classes": response_classes,
        "commands_of": lambda f, s: [c for c in s.fields if f.name in c.responses],
        "constructor": constructor,
        "required_map": required_map,
        "group_names": group_names,
        "reflected": reflected,
        "readings": lambda f: [p for p in f.parameters if p.reading],
        "reading_items": reading_items,
        "silent": silent,
        "asked": lambda f, s: asked(f, model) if s else [],
        "constant_bytes": lambda op: "".join(f"\\x{b:02x}" for b in op.value.to_bytes(op.size, "big")),
        "device_modules": device_modules,
        "device_fields": lambda d: device_fields(d, model),
        "device_functions": lambda d: device_functions(d, model),
        "device_rates": lambda d: device_rates(d, model),
        "value": value,
        "sequence": sequence,
        "reference": reference,
        "origin": origin,
        "tree": Tree,
        "qualified": qualified,
        "by_descriptor": by_descriptor,
        "arguments": arguments,
        "declared": declared,
    }


# --------------------------------------------------------------------------- names


def module(name: str) -> str:
    return _module(name)


def constant(name: str) -> str:
    return _constant(upper(name))


def class_name(t: m.Type | m.Field) -> str:
    return _class(pascal(t.name))


def reference(t: m.Type) -> str:
    """A type as its set's module calls it: those of spec/types stand in a module of their own."""
    shared = isinstance(t, m.Vector) or t.owner is None
    return f"types.{class_name(t)}" if shared and t.name != "function_selector" else class_name(t)


def qualified(t: m.Type) -> str:
    """A type as any module calls it: `types.AckCode`."""
    owner = getattr(t, "owner", None)
    return f"{module(owner) if owner else 'types'}.{class_name(t)}"


def origin(f: m.Field) -> str:
    """The class that a repeated field has its values from: `gnss_1.Dop`."""
    assert f.definition is not None
    return f"{module(f.definition.partition('.')[0])}.{class_name(f)}"


# --------------------------------------------------------------------------- values


def stored(record: m.Field | m.Struct) -> list[m.Parameter]:
    """The parameters that an object holds: constants and counters follow from the rest."""
    return [p for p in record.parameters if p.constant is None and p.counts is None]


def item_type(p: m.Parameter) -> str:
    e = p.element
    match e:
        case m.Scalar():
            return "str" if e.kind == "char" and p.length is not None else _SCALARS[e.name][1]
        case None:
            kinds = [annotation(c.parameter) for c in p.cases if c.parameter is not None]
            return " | ".join([*dict.fromkeys(kinds), "None"])
        case _:
            return reference(e)


def annotation(p: m.Parameter) -> str:
    """The type of a parameter's value, where it is there."""
    one = item_type(p)
    if p.length is None or one == "str":
        return one
    if isinstance(p.length, int) and p.length <= 4 and isinstance(p.element, (m.Scalar, m.Vector)):
        return f"tuple[{', '.join([one] * p.length)}]"
    return f"tuple[{one}, ...]"


def absent(record: m.Field | m.Struct, p: m.Parameter) -> bool:
    """May it be absent?"""
    if not isinstance(record, m.Field):
        return False
    if record.functions:  # an unknown function requires nothing
        return not p.selector
    return p.optional


def hint(p: m.Parameter, record: m.Field | m.Struct) -> str:
    one = annotation(p)
    return f"{one} | None" if absent(record, p) and "None" not in one.split(" | ") else one


def declared(name: str, kind: str, value: str | None, indent: int) -> str:
    """`name: kind = value`, wrapped as the formatter wraps a long union."""
    tail = f" = {value}" if value is not None else ""
    flat = f"{name}: {kind}{tail}"
    if len(flat) + indent <= WIDTH:
        return flat
    pad = " " * indent
    inner = kind if len(kind) + indent + 4 <= WIDTH else kind.replace(" | ", f"\n{pad}    | ")
    return f"{name}: (\n{pad}    {inner}\n{pad}){tail}"


def default(p: m.Parameter, record: m.Field | m.Struct) -> str | None:
    """What a value is when the caller does not give it, as Python."""
    if absent(record, p) or p.element is None:
        return "None"
    if p.reserved is not None:
        return sent(p)
    return None


def sent(p: m.Parameter) -> str:
    """The value of a reserved parameter."""
    one = str(p.reserved)
    return one if p.length is None else f"({one},) * {p.length}"


def keyword_only(p: m.Parameter, record: m.Field | m.Struct) -> bool:
    """A default before values without one: only by name."""
    parameters = stored(record)
    rest = parameters[parameters.index(p) + 1 :]
    return default(p, record) is not None and any(default(q, record) is None for q in rest)


def arguments(record: m.Field | m.Struct) -> list[str]:
    """What a decoder hands to the constructor: by place, then by name."""
    names = [(_member(p.name), keyword_only(p, record)) for p in stored(record)]
    return [n for n, by_name in names if not by_name] + [f"{n}={n}" for n, by_name in names if by_name]


def constructor(f: m.Function, field: m.Field) -> dict[str, Any]:
    """The parameters of the constructor for one function: required, then optional ones."""
    letter = "W" if f.letter == "A" else f.letter
    required = [p for p in stored(field) if not p.selector and letter in (p.functions or "")]
    settable = [p for p in stored(field) if letter == "W" and p.optional]
    asked = [p for p in required if p.reserved is None]
    given = [f"{_member(p.name)}: {annotation(p)}" for p in asked]
    given += [f"{_member(p.name)}: {annotation(p)} | None = None" for p in settable if p.reserved is None]
    passed = [f"FunctionSelector.{constant(f.name)}"]
    for p in required:
        passed.append(f"{_member(p.name)}={_member(p.name) if p.reserved is None else sent(p)}")
    for i, p in enumerate(settable):
        later = [q for q in settable[i:] if q.reserved is None]  # a reserved value goes with what follows it
        if later:
            own = _member(p.name)
            sending = own if p.reserved is None else f"{sent(p)} if {_member(later[0].name)} is not None else None"
            passed.append(f"{own}={sending}")
    return {"parameters": given, "arguments": passed}


def required_map(field: m.Field) -> str:
    return "{" + ", ".join(f"{value}: {count}" for value, count in field.required) + "}"


def group_names(field: m.Field) -> str:
    """The groups as codec.present takes them: number of the last parameter, names, is it a union?"""
    known = {p.name for p in stored(field)}
    rows = []
    for op in field.operations:
        if isinstance(op, m.GroupOp):
            inner = [i for i in op.body if not isinstance(i, m.GroupOp)]
            union = any(isinstance(i, m.SwitchOp) for i in inner)
            rows.append(f"({op.last}, {_tuple([_member(i.member) for i in inner if i.member in known])}, {union})")
    head = f"_{upper(field.name)}_GROUPS = ("
    return Tree(head, rows, ",)" if len(rows) == 1 else ")").lay(0)


def _tuple(names: Sequence[str]) -> str:
    inner = ", ".join(f'"{n}"' for n in names)
    return f"({inner},)" if len(names) == 1 else f"({inner})"


def sequence(items: Sequence[str], indent: int = 0) -> str:
    """A tuple."""
    return call("(", items, indent, ",)" if len(items) == 1 else ")")


def value(v: object) -> str:
    """A plain value as Python writes it."""
    if isinstance(v, str):
        return '"' + v.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
    return repr(v)


# --------------------------------------------------------------------------- steps


@dataclass(frozen=True, slots=True)
class Item:
    """One value inside a block: which of its numbers it is made of, and what it becomes."""

    member: str
    first: int
    count: int
    kind: str  # plain, bool, typed, the same with _array; bits, counter, constant
    type: str  # of an enumeration or bitfield
    counted: str = ""  # the array that a counter counts
    capacity: int = 0  # how many elements that array holds at most
    value: int = 0  # of a constant


@dataclass(frozen=True, slots=True)
class Block:
    """A run of numbers with a fixed layout: one codec.Block."""

    name: str
    layout: str
    size: int
    items: tuple[Item, ...]
    kind: str = "block"


@dataclass(frozen=True, slots=True)
class Step:
    """Anything else. `body` of a group, `cases` of a switch: (value, label, steps, check)."""

    kind: str  # struct, text, numbers, structures, vectors, group, switch
    op: Any
    member: str
    type: str = ""
    letter: str = ""
    size: int = 0
    width: int = 0
    body: tuple[Any, ...] = ()
    cases: tuple[tuple[int, str, tuple[Any, ...], str], ...] = ()


class _Plan:
    """Joins neighbouring numbers into blocks and numbers these."""

    def __init__(self, name: str, capacities: Mapping[str, int]) -> None:
        self.name = name
        self.capacities = capacities
        self.blocks: list[Block] = []

    def steps(self, operations: Sequence[m.Operation], member: str | None = None) -> tuple[Any, ...]:
        """`member`: where a union's alternative goes, whatever its own name is."""
        found: list[Any] = []
        run: list[m.Operation] = []
        for op in [*operations, None]:
            if op is not None and _fixed(op):
                run.append(op)
                if not isinstance(op, m.ConstantOp):
                    continue
                op = None  # a wrong constant is the first thing to say about a record
            if run:
                found.append(self.block(run, member))
                run = []
            if op is not None:
                found.append(self.step(op, member))
        return tuple(found)

    def block(self, ops: Sequence[m.Operation], member: str | None) -> Block:
        block = _block(ops, f"_{upper(self.name)}_{len(self.blocks)}", member, self.capacities)
        self.blocks.append(block)
        return block

    def step(self, op: m.Operation, member: str | None) -> Step:
        if isinstance(op, m.GroupOp):
            return Step("group", op, "", body=self.steps(op.body))
        name = member or _member(op.member)
        match op:
            case m.StructOp():
                return Step("struct", op, name, reference(op.struct))
            case m.TextOp():
                return Step("text", op, name, size=1)
            case m.SwitchOp():
                cases = tuple(
                    (c.tag.value, c.tag.name, self.steps([c.operation], name) if c.operation else (), _check(c))
                    for c in op.cases
                )
                return Step("switch", op, name, cases=cases)
            case m.ArrayOp(item=m.StructOp(struct=struct)):
                return Step("structures", op, name, reference(struct), size=struct.max_size)
            case m.ArrayOp(item=m.ArrayOp(item=m.ScalarOp(scalar=scalar), count=width)):
                return Step("vectors", op, name, "", _SCALARS[scalar.name][0], scalar.size * (width or 0), width or 0)
            case m.ArrayOp(item=m.ScalarOp() as item):
                kind = "codec.truth" if item.scalar.kind == "bool" else _type(item.type)
                return Step("numbers", op, name, kind, _SCALARS[item.scalar.name][0], item.size)
        raise AssertionError(op)


def plan(record: m.Field | m.Struct) -> dict[str, Any]:
    arrays = [p.operation for p in record.parameters if isinstance(p.operation, (m.ArrayOp, m.TextOp))]
    found = _Plan(record.name, {op.member: op.capacity for op in arrays})
    return {"steps": found.steps(record.operations), "blocks": found.blocks}


def begun(group: Step) -> list[str]:
    """The values of a group that a decoder may have read when the rest of the group is cut off."""
    found = []
    for step in group.body[:-1]:
        items = step.items if isinstance(step, Block) else (step,)
        found += [i.member for i in items if i.kind not in ("counter", "constant")]
    return found


def _check(case: m.Case) -> str:
    """The class that a union's member must be of, where one tells."""
    e = case.parameter.element if case.parameter else None
    return reference(e) if isinstance(e, m.Struct) else ""


def _fixed(op: m.Operation) -> bool:
    if isinstance(op, m.ArrayOp):
        return op.count is not None and isinstance(op.item, m.ScalarOp)
    return isinstance(op, (m.ScalarOp, m.ConstantOp, m.CounterOp, m.BitsOp))


def _block(ops: Sequence[m.Operation], name: str, member: str | None, capacities: Mapping[str, int]) -> Block:
    layout, items, at, size = "", [], 0, 0
    for op in ops:
        assert isinstance(op, (m.ScalarOp, m.ConstantOp, m.CounterOp, m.BitsOp, m.ArrayOp))
        called = member or _member(op.member)
        match op:
            case m.BitsOp():
                item, letters = Item(called, at, op.size, "bits", reference(op.type)), "B" * op.size
            case m.ConstantOp():
                item, letters = Item(called, at, 1, "constant", "", value=op.value), _letter(op.scalar)
            case m.CounterOp():
                item = Item(called, at, 1, "counter", "", _member(op.array), capacities[op.array])
                letters = _letter(op.scalar)
            case m.ScalarOp():
                item, letters = Item(called, at, 1, _how(op), _type(op.type)), _letter(op.scalar)
            case m.ArrayOp(item=m.ScalarOp() as inner, count=int(count)):
                item = Item(called, at, count, f"{_how(inner)}_array", _type(inner.type))
                letters = _letter(inner.scalar) * count
            case _:
                raise AssertionError(op)
        items.append(item)
        layout += letters
        at += len(letters)
        size += sum(struct.calcsize(">" + c) for c in letters)
    return Block(name, layout, size, tuple(items))


def _letter(scalar: m.Scalar) -> str:
    return _SCALARS[scalar.name][0]


def _how(op: m.ScalarOp) -> str:
    return "typed" if op.type else "bool" if op.scalar.kind == "bool" else "plain"


def _type(t: m.Type | None) -> str:
    return reference(t) if t else ""


# --------------------------------------------------------------------------- text


def docstring(text: str, indent: int, before: int = 0) -> str:
    """A paragraph, wrapped and indented, for a place inside a docstring.

    The first line follows `before` characters, and so do the closing quotes the last one.
    """
    pad = " " * indent
    hang = pad + "  " if text.startswith("- ") else pad
    clean = text.replace("\\", "\\\\").replace('"""', "'''")
    if clean.endswith('"'):
        clean += " "
    wrapped = textwrap.wrap(
        " " * before + pad + clean,
        WIDTH - before,
        subsequent_indent=hang,
        break_long_words=False,
        break_on_hyphens=False,
    )
    first = wrapped[0].strip() if wrapped else ""
    lines = [first, *wrapped[1:]]
    return "\n".join(lines) if len(lines) == 1 or not before else "\n".join(lines) + f"\n{pad}"


@dataclass(frozen=True, slots=True)
class Tree:
    """A call or a literal, to be laid out: head, items, tail."""

    head: str
    items: Sequence[str | Tree]
    tail: str = ")"

    def flat(self) -> str:
        inner = ", ".join(i if isinstance(i, str) else i.flat() for i in self.items)
        comma = "," if self.tail == ",)" else ""
        return f"{self.head}{inner}{comma}{self.tail.lstrip(',')}"

    def lay(self, indent: int, behind: int = 0) -> str:
        """As the formatter has it: on one line, or the items on one line, or on one each."""
        flat = self.flat()
        if len(flat) + indent + behind <= WIDTH or not self.items:
            return flat
        pad = " " * indent
        tail = self.tail.lstrip(",")
        joined = ", ".join(i if isinstance(i, str) else i.flat() for i in self.items)
        if len(joined) + indent + 4 <= WIDTH and re.search(r"\w\($", self.head):  # only where it is a call
            return f"{self.head}\n{pad}    {joined}\n{pad}{tail}"
        inner = "".join(f"{pad}    {_item(i, indent + 4)},\n" for i in self.items)
        return f"{self.head}\n{inner}{pad}{tail}"


def _item(item: str | Tree, indent: int) -> str:
    if isinstance(item, Tree):
        return item.lay(indent, 1)
    fits = len(item) + indent + 1 <= WIDTH
    return item if fits else item.replace(" | ", f"\n{' ' * indent}| ")


def call(head: str, arguments: Sequence[str], indent: int, tail: str = ")") -> str:
    return Tree(head, arguments, tail).lay(indent)


# --------------------------------------------------------------------------- modules


#: Names that generated modules may use, by where they come from.
_HOMES = {
    "dataclasses": ["dataclass", "field"],
    "enum": ["IntFlag"],
    "typing": ["TypeAlias"],
    ".": ["codec", "types"],
    ".errors": ["EncodeError", "Truncated"],
    ".field": ["Command", "Data", "Field", "Response", "Structure"],
    ".protocol": ["FunctionSelector"],
}


def with_imports(body: str, s: m.Set | None, model: m.Model) -> str:
    """Puts the imports that a module's body needs before it."""
    code = re.sub(r'"""[\s\S]*?"""|#.*', "", body)
    used = set(re.findall(r"(?<![\w.])[A-Za-z_]\w*", code))
    homes = {k: list(v) for k, v in _HOMES.items()}
    if s is not None:
        homes["."] += [origin(f).partition(".")[0] for f in s.fields if f.definition]
    lines = []
    for local in (False, True):
        for home in sorted(h for h in homes if h.startswith(".") == local):
            names = sorted(set(homes[home]) & used, key=_import_order)
            if names:
                flat = f"from {home} import {', '.join(names)}"
                listed = f"from {home} import (\n" + "".join(f"    {n},\n" for n in names) + ")"
                lines.append(flat if len(flat) <= WIDTH else listed)
        lines.append("")
    whole = re.sub(r"\n{3,}", "\n\n", "\n".join(["from __future__ import annotations", "", *lines]).rstrip())
    gap = "\n\n\n" if re.match(r"\n*(class|def|@)", body) else "\n\n"
    whole += gap + body.lstrip("\n")
    return re.sub(r"\n{4,}", "\n\n\n", whole)


def _import_order(name: str) -> tuple[int, str]:
    """Constants, classes, functions: as ruff sorts them."""
    return (0 if name.isupper() and len(name) > 1 else 1 if name[0].isupper() else 2, name)


def response_classes(field: m.Field, s: m.Set) -> list[str]:
    known = {f.name: f for f in s.fields if f.role == m.RESPONSE}
    return [class_name(known[name]) for name in field.responses]


def by_descriptor(s: m.Set) -> list[tuple[int, list[m.Field]]]:
    found: dict[int, list[m.Field]] = {}
    for f in s.fields:
        found.setdefault(f.descriptor, []).append(f)
    return sorted(found.items())


def reflected(record: m.Field | m.Struct, path: str) -> str:
    """A row of reflection.PARAMETERS."""
    rows = [_reflected(p) for p in record.parameters]
    return Tree(f"{path}: (", rows, ",)" if len(rows) == 1 else ")").lay(4, 1)


def _reflected(p: m.Parameter) -> Tree:
    e, op = p.element, p.operation
    parts: list[str | Tree] = [f'"{p.name}"', f'"{_member(p.name)}"', f'"{op.kind}"']
    scalar = e if isinstance(e, m.Scalar) else getattr(e, "scalar", None)
    if scalar:
        parts.append(f'scalar="{scalar.name}"')
    if isinstance(e, m.Bitfield) and e.scalar is None:
        parts.append('scalar="bits"')
        parts.append(f"size={e.size}")
    if isinstance(e, m.Vector):
        parts.append(f"elements={_tuple(e.elements)}")
    if p.length is not None:
        parts.append(f"length={value(p.length)}")
    if p.constant is not None:
        parts.append(f"constant={p.constant}")
    if p.counts:
        parts.append(f'counts="{_member(p.counts)}"')
    if isinstance(e, (m.Enum, m.Bitfield, m.Struct)):
        parts.append("type=protocol.FunctionSelector" if p.selector else f"type={qualified(e)}")
    if p.tag:
        parts.append(f'tag="{_member(p.tag)}"')
        parts.append(Tree("cases={", [_case(c) for c in p.cases], "}"))
    if p.units:
        parts.append(f"units={_tuple(p.units)}")
    return Tree("Parameter(", parts)


def _case(c: m.Case) -> str | Tree:
    if c.parameter is None:
        return f"{c.tag.value}: None"
    inner = _reflected(c.parameter)
    return Tree(f"{c.tag.value}: {inner.head}", inner.items, inner.tail)


def reading_items(p: m.Parameter, f: m.Field) -> list[str]:
    """What decides -> the type, as items of a dict."""
    assert p.reading is not None
    if p.reading.by == "device":
        return [f"{value(key)}: {reference(t)}" for key, t in p.reading.types]
    sibling = next(q for q in f.parameters if q.name == p.reading.by)
    assert isinstance(sibling.element, m.Enum)
    numbers = {v.name: v.value for v in sibling.element.values}
    return [f"{numbers[key]}: {reference(t)}" for key, t in p.reading.types]


def silent(f: m.Field) -> str:
    """When the device does not acknowledge, as a condition on the values."""
    tests = [f"self.function == {x.value}" for x in f.functions if not x.reply]
    if f.silent_when:
        tests.append(" and ".join(f"self.{_member(c.parameter)} == {c.value}" for c in f.silent_when))
    return " or ".join(tests)


def asked(f: m.Field, model: m.Model) -> list[tuple[str, str]]:
    """The responses of a command, each with the condition under which it is sent; none if there are no conditions."""
    found = []
    for reply in replies(f, model):
        functions = [f"self.function == {x.value}" for x in reply.functions]
        tests = [" or ".join(functions)] if functions else []
        tests += [f"self.{_member(c.parameter)} == {c.value}" for c in reply.when]
        if len(tests) > 1:
            tests = [f"({t})" if " or " in t else t for t in tests]
        found.append((" and ".join(tests) or "True", class_name(reply.response)))
    return found if any(condition != "True" for condition, _ in found) else []


# --------------------------------------------------------------------------- devices


def device_modules(model: m.Model) -> list[str]:
    """The modules whose types the device profiles name."""
    return sorted({qualified(t).partition(".")[0] for d in model.devices for _, t in d.readings})


def device_fields(d: m.Device, model: m.Model) -> list[tuple[int, int, str]]:
    found = [(f.set, f.descriptor, name) for name in d.fields if (f := model.field(name))]
    return sorted(found)


def device_functions(d: m.Device, model: m.Model) -> str:
    pairs = [(model.field(name), letters) for name, letters in d.functions]
    items = [f"(0x{f.set:02X}, 0x{f.descriptor:02X}): {value(letters)}" for f, letters in pairs if f]
    return call("{", items, 4, "}")


def device_rates(d: m.Device, model: m.Model) -> str:
    numbers = {s.name: s.number for s in model.sets}
    return call("{", [f"0x{numbers[name]:02X}: {rate}" for name, rate in d.base_rates], 4, "}")
