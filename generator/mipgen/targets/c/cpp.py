"""C++17 on top of C: the types, layouts and commands in its headers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.emit.naming import Escape, Identifier
from mipgen.lower.memory import members

from . import calls, names, runtime
from .members import constructors, takes_enum

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


def qualified(thing: m.Type | m.Field) -> str:
    """Returns the name of a thing with its namespaces."""
    if isinstance(thing, m.Field):
        inside = thing.family if thing.set else None  # the acknowledge belongs to no set
    else:
        inside = getattr(thing, "owner", None)
    return f"mip::{namespace(inside)}::{bare(thing)}" if inside else f"mip::{bare(thing)}"


def in_bytes(t: m.Type) -> bool:
    """True for a bitfield that is an array of bytes instead of a number."""
    return isinstance(t, m.Bitfield) and t.scalar is None


def named(e: m.Scalar | m.Type | None) -> bool:
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
    return [a for p in members(f) if (a := _accessor(p, f))]


def _accessor(p: m.Parameter, f: m.Field) -> Accessor | None:
    name = names.member(p.name)
    at = f"c_type::{name}"
    count = f"c_type::{names.member(p.counter)}" if p.counter else f"{at}_count"
    if p.element is None:
        return None
    if p.optional and p.length is None:
        there = f"present >= MIP_{names.macro(names.field_name(f)).removeprefix('MIP_')}_WITH_{names.macro(p.name)}"
        one = f"::{qualified(p.element)}" if named(p.element) else names.c_type(p.element)  # type: ignore[arg-type]
        value = f"static_cast<{one}>({at})"
        kind = f"std::optional<{one}>"
        return Accessor(word(p.name), kind, f"{there} ? {kind}({value}) : std::nullopt", "If it is present.")
    if p.length is None and named(p.element):
        assert isinstance(p.element, (m.Enum, m.Bitfield))
        return Accessor(word(p.name), f"::{qualified(p.element)}", f"static_cast<::{qualified(p.element)}>({at})", "")
    if p.kind == "text" and isinstance(p.length, int):
        return Accessor(
            word(p.name), "std::string_view", f"::mip::text({at})", "May contain leading or trailing spaces."
        )
    if p.kind == "text":
        return Accessor(word(p.name), "std::string_view", f"{{{at}, {count}}}", "")
    if p.kind == "array" and (p.counter or p.fills):
        return Accessor(word(p.name), f"span<{_element(p)}>", f"{{{at}, {count}}}", "")
    return None


def _element(p: m.Parameter) -> str:
    """Returns the element type of a variable-length array."""
    assert p.element is not None
    one = names.c_type(p.element)
    return f"const {one.replace('struct ', '::')}{_dimensions(p.item)}"


def _dimensions(p: m.Parameter) -> str:
    return f"[{max(1, p.capacity)}]{_dimensions(p.item)}" if p.several else ""


# --------------------------------------------------------------------------- commands


@dataclass(frozen=True, slots=True)
class Command:
    """A structure with the parameters that one call of a command needs."""

    name: str
    field: m.Field
    response: m.Field | None
    doc: str
    members: tuple[str, ...]
    call: str  # the C function
    arguments: tuple[str, ...]  # of the C function
    fill: str  # the function that fills the C structure
    filled: tuple[str, ...]  # the arguments of `fill`
    plain: bool  # are the members all that `fill` needs?
    fixed: tuple[str, ...] | None  # for a command with constant data: its function selector, if it has one


def commands(f: m.Field, model: m.Model) -> list[Command]:
    return [_command(f, c) for c in calls.calls(f, model) if not c.whole]


def whole_response(f: m.Field, model: m.Model) -> m.Field | None:
    """Returns the response to a command that is passed as a C structure; None if there are several."""
    responses = model.responses(f)
    return responses[0] if len(responses) == 1 else None


def _command(f: m.Field, c: calls.Call) -> Command:
    asked = c.way.asked if c.way else ()
    arrays = {p.counter: p for p in asked if p.counter}
    shown = [p for p in c.given if p.name not in arrays]
    plain = c.given == asked
    function = c.way.function if c.way else None
    what = f"{f.title}: {function.name}." if function else f"{f.title}."
    return Command(
        name=command_name(f, c),
        field=f,
        response=c.response,
        doc=f"{what} See {c.name}.",
        members=tuple(_declared(p, f) for p in shown),
        call=c.name,
        arguments=tuple(a for p in c.given for a in _passed(p, arrays)),
        fill=f"{names.field_name(f)}_{c.way.name}" if c.way else "",
        filled=tuple(a for p in asked for a in _passed(p, arrays)),
        plain=plain,
        fixed=_fixed(c),
    )


def _fixed(c: calls.Call) -> tuple[str, ...] | None:
    """Returns the function selector of a command without other data; empty if there is no data, None if there is
    more."""
    if c.data is None or c.given or (c.way and (c.way.asked or c.way.assigned or not c.way.function)):
        return None
    return (f"MIP_FUNCTION_SELECTOR_{names.macro(c.way.function.name)}",) if c.way and c.way.function else ()


def command_name(f: m.Field, c: calls.Call) -> str:
    """Returns the name of a call: `write_message_format`, `ping`; `for_...` for one of several responses."""
    function = c.way.function.name if c.way and c.way.function else ""
    several = c.response is not None and "_call_for_" in c.name
    name = f"for_{c.response.name}" if several and c.response else f.name
    return word(f"{function}_{name}" if function else name)


def _declared(p: m.Parameter, f: m.Field) -> str:
    """Declares a member."""
    name = _member(p.name)
    if p.element is None:
        return f"::{names.union_name(p, f)} {name}"
    one = names.c_type(p.element).replace("struct ", "::")
    if p.kind == "text":
        return f"{'std::string_view' if p.counter or p.fills else 'const char *'} {name}"
    if p.kind == "array" and (p.counter or p.fills):
        return f"span<{_element(p)}> {name}"
    if p.several:
        return f"{one} {name}{_dimensions(p)}"
    if named(p.element):
        return f"::{qualified(p.element)} {name}"  # type: ignore[arg-type]
    return f"{'bool' if one == 'mip_bool' else one} {name}"


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
    if named(p.element):
        return [f"number({name})"]
    return [f"&{name}" if names.is_struct(p.element) else name]


# --------------------------------------------------------------------------- names


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Yields every name that the C++ headers define in a namespace."""
    used = {*names.LANGUAGE["cpp_used"], *names.LANGUAGE["scalars"].values()} - _KEYWORDS
    place = model.protocol.position
    yield Identifier("namespace mip", "mip", "the package", place, word=False)
    for name in sorted(used | runtime.in_namespace() | {name for name in runtime.names() if name.islower()}):
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
            if not constructors(f) and members(f):
                yield Identifier(scope, bare(f), f.full_name, f.position)


def _of_type(t: m.Type, scope: str) -> Iterator[Identifier]:
    if isinstance(t, m.Vector):
        return
    place = getattr(t, "position", None)
    name = bare(t)
    yield Identifier(scope, name, t.name, place)
    if in_bytes(t):
        yield Identifier(scope, f"{name}_bits", t.name, place)
    inside = f"enum class {scope.removeprefix('namespace ')}::{name}"
    parts = t.values if isinstance(t, m.Enum) else t.bits if isinstance(t, m.Bitfield) else ()
    for part in parts:
        yield Identifier(inside, word(part.name), f"{t.name}.{part.name}", part.position)
