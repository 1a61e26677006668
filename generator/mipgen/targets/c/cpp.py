"""C++17 on top of C: the types, layouts and commands in its headers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeGuard

from mipgen import model as m
from mipgen.emit.naming import Escape, Identifier
from mipgen.lower.memory import stored

from . import calls, names, runtime
from .members import constructors, dimensions, selector, takes_enum

_KEYWORDS = frozenset(names.LANGUAGE["keywords"])

namespace = Escape(_KEYWORDS, digit_prefix="mip_")
word = Escape(_KEYWORDS, digit_prefix="n")
#: Members of structures that also have functions.
_member = Escape(_KEYWORDS | frozenset(names.LANGUAGE["cpp_members"]), digit_prefix="n")


def bare(thing: m.Type | m.Field) -> str:
    """Returns the name of a thing inside its namespace, which is that of its family."""
    if isinstance(thing, m.Field):
        return word(thing.name)
    owner = getattr(thing, "owner", None)
    return word(thing.name.removeprefix(f"{owner}_") if owner else thing.name)


def scope(thing: m.Type | m.Field) -> str:
    """Returns the namespace of a thing."""
    if isinstance(thing, m.Field):
        inside = thing.family if thing.set else None  # the acknowledge belongs to no set
    else:
        inside = getattr(thing, "owner", None)
    return f"mip::{namespace(inside)}" if inside else "mip"


def qualified(thing: m.Type | m.Field) -> str:
    """Returns the name of a thing with its namespaces."""
    return f"{scope(thing)}::{bare(thing)}"


def is_enum_class(e: m.Scalar | m.Type | None) -> TypeGuard[m.Enum | m.Bitfield]:
    """True for a type that is an `enum class` in C++."""
    return isinstance(e, m.Enum) or (isinstance(e, m.Bitfield) and e.scalar is not None)


# --------------------------------------------------------------------------- layouts


@dataclass(frozen=True, slots=True)
class Accessor:
    """A function that replaces a member of the C structure."""

    name: str
    type: str
    value: str
    doc: str


def accessors(f: m.Field) -> list[Accessor]:
    """Returns the functions of a data field or a response, which have better types than the members in C."""
    if f.role == m.COMMAND:
        return []
    return [a for p in stored(f) if (a := _accessor(p, f))]


def _accessor(p: m.Parameter, f: m.Field) -> Accessor | None:
    if p.element is None:
        return None
    at, doc = f"c_type::{names.member(p.name)}", ""
    items = f"{{{at}, {f'c_type::{names.member(p.counter)}' if p.counter else f'{at}_count'}}}"
    kind = f"::{qualified(p.element)}" if is_enum_class(p.element) else names.c_type(p.element)
    value = f"static_cast<{kind}>({at})"
    if p.optional and p.length is None:
        is_present = f"present >= {names.macro(f'{names.field_name(f)}_with_{p.name}')}"
        kind, doc = f"std::optional<{kind}>", "If it is present."
        value = f"{is_present} ? {kind}({value}) : std::nullopt"
    elif p.kind == "text" and isinstance(p.length, int):
        kind, value, doc = "std::string_view", f"::mip::text({at})", "May contain leading or trailing spaces."
    elif p.kind == "text":
        kind, value = "std::string_view", items
    elif p.kind == "array" and (p.counter or p.fills):
        kind, value = f"span<{_element(p)}>", items
    elif p.length is not None or not is_enum_class(p.element):
        return None
    return Accessor(word(p.name), kind, value, doc)


def _element(p: m.Parameter) -> str:
    """Returns the element type of a variable-length array."""
    assert p.element is not None
    return f"const {names.c_type(p.element, structure='::')}{dimensions(p.item)}"


# --------------------------------------------------------------------------- commands


@dataclass(frozen=True, slots=True)
class Command:
    """A structure with the parameters that one call of a command needs."""

    name: str
    doc: list[str]
    base: str  # its base class, which defines everything, if the command's data is constant
    members: list[str]
    response: str
    receives: str  # the argument of `call` for the response
    call: str  # the call of the C function
    fill: str  # the call that fills the C structure


def commands(f: m.Field, model: m.Model) -> list[Command]:
    return [_command(f, c) for c in calls.calls(f, model) if not c.whole]


def _command(f: m.Field, c: calls.Call) -> Command:
    parameters, c_name = c.way.parameters if c.way else (), names.field_name(f)
    arrays = {p.counter: p for p in parameters if p.counter}
    function = c.way.function if c.way else None
    answer = only_response(c.response) if c.response else "void"
    passed = ["device_", *(a for p in c.parameters for a in _passed(p, arrays)), *(["to_"] if c.response else [])]
    fixed = {x.parameter: x.value for x in c.fixed.when} if c.fixed else {}
    values = ([calls.literal(p, fixed[p.name])] if p.name in fixed else _passed(p, arrays) for p in parameters)
    filled = ["to_", *(a for value in values for a in value)]
    what = f"{f.title}: {function.name}." if function else f"{f.title}."
    return Command(
        name=command_name(f, c),
        doc=[f"{what} See {c.name}."],
        base="" if (data := _fixed(c)) is None else f"fixed_command<{', '.join([f'::{c_name}', answer, *data])}>",
        members=[_declared(p, f) for p in c.parameters if p.name not in arrays],
        response=answer,
        receives=", response *to_" if c.response else "",
        call=f"::{c.name}({', '.join(passed)})",
        fill=f"::{c_name}_{c.way.name}({', '.join(filled)})" if c.way else "&(*to_ = {})",
    )


def only_response(*responses: m.Field) -> str:
    """Returns the only response to a command, or void."""
    return f"::{qualified(responses[0])}" if len(responses) == 1 else "void"


def _fixed(c: calls.Call) -> tuple[str, ...] | None:
    """Returns the function selector of a command without other data; empty if there is no data, None if there is
    more."""
    if c.data is None or c.parameters or (c.way and (c.way.assigned or not c.way.function)):
        return None
    return (selector(c.way.function),) if c.way and c.way.function else ()


def command_name(f: m.Field, c: calls.Call) -> str:
    """Returns the name of a call: `write_message_format`, `ping`; `for_...` for one of several responses."""
    function = c.way.function.name if c.way and c.way.function else ""
    name = f"for_{c.response.name}" if c.fixed and c.response else f.name
    return word(f"{function}_{name}" if function else name)


def _declared(p: m.Parameter, f: m.Field) -> str:
    """Declares a member."""
    name = _member(p.name)
    if p.element is None:
        return f"::{names.union_name(p, f)} {name}"
    element = names.c_type(p.element, structure="::")
    if p.kind == "text":
        return f"{'std::string_view' if p.counter or p.fills else 'const char *'} {name}"
    if p.kind == "array" and (p.counter or p.fills):
        return f"span<{_element(p)}> {name}"
    if p.several:
        return f"{element} {name}{dimensions(p)}"
    if is_enum_class(p.element):
        return f"::{qualified(p.element)} {name}"
    return f"{'bool' if element == 'mip_bool' else element} {name}"


def _passed(p: m.Parameter, arrays: dict[str, m.Parameter]) -> list[str]:
    """Writes the C arguments for a parameter."""
    name = _member(p.name)
    if p.name in arrays:
        return [f"detail::count({_member(arrays[p.name].name)})"]
    if p.element is None:
        return [f"&{name}"]
    if p.kind in ("array", "text") and (p.counter or p.fills):
        return [*([f"detail::count({name})"] if p.fills else []), f"{name}.data()"]
    if p.several or p.kind == "text":
        return [name]
    if takes_enum(p):
        return [f"static_cast<enum {names.type_name(p.element)}>({name})"]  # type: ignore[arg-type]
    if is_enum_class(p.element):
        return [f"::mip::number({name})"]
    return [f"&{name}" if names.is_struct(p.element) else name]


# --------------------------------------------------------------------------- names


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Yields every name that the C++ headers define in a namespace."""
    used = {*names.LANGUAGE["cpp_used"], *names.LANGUAGE["scalars"].values()} - _KEYWORDS
    place = model.protocol.position
    yield Identifier("namespace mip", "mip", "the package", place, word=False)
    for name in sorted(used | runtime.in_namespace() | {name for name in runtime.runtime_names() if name.islower()}):
        yield Identifier("namespace mip", name, f"{name} of the core", None)
    for t in (*model.types, model.protocol.function_selector):
        yield from _of_type(t, "namespace mip")
    acknowledge = model.protocol.acknowledge
    yield Identifier("namespace mip", bare(acknowledge), "the acknowledge", acknowledge.position)
    for s in model.sets:
        yield Identifier("namespace mip", f"{namespace(s.name)}_set", f"set {s.name}", s.position)
    for x in model.families:
        yield Identifier("namespace mip", namespace(x.name), f"set {x.name}", x.position)
        scope = f"namespace mip::{namespace(x.name)}"
        yield Identifier(scope, "mip", "the package", place, word=False)
        for name in sorted(used):
            yield Identifier(scope, name, f"{name}, which the headers use", None)
        for t in x.types:
            yield from _of_type(t, scope)
        for f in x.fields:
            if f.role != m.COMMAND:
                yield Identifier(scope, bare(f), f.full_name, f.position)
                continue
            for c in commands(f, model):
                yield Identifier(scope, c.name, f.full_name, f.position)
            if not constructors(f) and stored(f):
                yield Identifier(scope, bare(f), f.full_name, f.position)


def _of_type(t: m.Type, scope: str) -> Iterator[Identifier]:
    if isinstance(t, m.Vector):
        return
    place = getattr(t, "position", None)
    name = bare(t)
    yield Identifier(scope, name, t.name, place)
    if names.in_bytes(t):
        yield Identifier(scope, f"{name}_bits", t.name, place)
    inside = f"enum class {scope.removeprefix('namespace ')}::{name}"
    parts = t.values if isinstance(t, m.Enum) else t.bits if isinstance(t, m.Bitfield) else ()
    for part in parts:
        yield Identifier(inside, word(part.name), f"{t.name}.{part.name}", part.position)
