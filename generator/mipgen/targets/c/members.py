"""Members of structures, and arguments of the functions that fill them."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import calls, extent
from mipgen.lower.memory import members

from .names import argument_name, c_type, is_enum, is_struct, macro, member, type_name, union_name


def declaration(p: m.Parameter, record: m.Record) -> str:
    """Declares a member: `float bias[3]`."""
    if p.element is None:
        return f"union {union_name(p, record)} {member(p.name)}"
    return f"{c_type(p.element)} {member(p.name)}{_dimensions(p)}"


def _dimensions(p: m.Parameter) -> str:
    """Writes the brackets after a member's name."""
    if p.kind == "text":
        return f"[{p.capacity + 1}]"
    return f"[{max(1, p.capacity)}]{_dimensions(p.item)}" if p.several else ""


def home(alternative: m.Parameter) -> str:
    """Writes the prefix of a union's alternative; one that fills the field shares a structure with its count."""
    return f"{member(alternative.name)}." if alternative.fills else ""


def last_present(f: m.Field) -> list[tuple[m.Parameter, int]]:
    """Returns the optional parameters, each with the value of `present` when it is the last one present."""
    return [(p, f.present_with[p.name]) for p in members(f) if p.optional and not p.counts]


# --------------------------------------------------------------------------- constructors


@dataclass(frozen=True, slots=True)
class Constructor:
    """A function that fills the structure of a command: one for each of its functions, or just one."""

    name: str
    function: m.Function | None
    description: str
    arguments: str
    asked: tuple[m.Parameter, ...]  # what the caller passes
    assigned: tuple[m.Parameter, ...]  # these, and reserved values that are not zero


def constructors(f: m.Field) -> list[Constructor]:
    if f.role != m.COMMAND or not (f.functions or any(p.reserved is None for p in members(f))):
        return []
    return [_constructor(f, way) for way in calls.constructors(f)]


def _constructor(f: m.Field, way: m.Call) -> Constructor:
    asked = tuple(p for p in members(f) if p in way.given)
    return Constructor(
        name=way.function.name if way.function else "make",
        function=way.function,
        description=way.function.description if way.function else f"{f.title}.",
        arguments=", ".join(argument(p, f) for p in asked),
        asked=asked,
        assigned=tuple(p for p in members(f) if p in asked or p.reserved),
    )


def argument(p: m.Parameter, f: m.Field) -> str:
    """Declares the arguments for a parameter: one, or a count and the elements."""
    name = argument_name(p.name)
    if p.element is None:
        return f"const union {union_name(p, f)} *{name}"
    one = c_type(p.element)
    count = f"uint8_t {name}_count, " if p.fills else ""
    if p.kind == "text":
        return f"{count}const char *{name}"
    if p.kind == "array":
        first = "" if p.count is None else p.count
        return f"{count}const {one} {name}[{first}]{_dimensions(p.item)}"
    if takes_enum(p):
        assert isinstance(p.element, m.Enum)
        return f"enum {type_name(p.element)} {name}"
    return f"const {one} *{name}" if is_struct(p.element) else f"{one} {name}"


def takes_enum(p: m.Parameter) -> bool:
    """Is its argument an enumeration, so that the compiler detects values of another one?

    Not if it has several bytes on the wire: a C compiler may store an enumeration with small values in a single byte.
    """
    return p.length is None and isinstance(p.element, m.Enum) and is_enum(p.element) and p.element.scalar.size == 1


#: A test of a command: an offset in its field, which begins with length and descriptor, and the value at that offset.
Test = tuple[int, str]
DATA = 2


def holding(f: m.Field, c: m.Condition) -> list[Test]:
    """Returns the tests of a command's bytes for a condition; for a Boolean, everything but 0 is true."""
    p = next(q for q in f.parameters if q.name == c.parameter)
    before = [extent.size(q) for q in f.parameters[: f.parameters.index(p)]]
    assert all(least == most for least, most in before), f"{f.full_name}.{p.name}: no fixed place"
    at = DATA + sum(size for size, _ in before)
    if c.boolean and c.value:
        return [(at, "MIP_NOT_ZERO")]
    return [(at + i, str(byte)) for i, byte in enumerate(c.value.to_bytes(p.size, "big"))]


@dataclass(frozen=True)
class Reply:
    """A row in a command's table of responses: see `mip_response` in client.h."""

    layout: m.Field | None
    descriptor: int
    at: int
    value: str
    more: bool


def replies(f: m.Field, model: m.Model) -> list[Reply]:
    """Returns the replies to a command: rows with one layout of a response and one test of the command. If there are
    fewer layouts than tests, or the reverse, the last one is repeated."""
    ways: list[tuple[list[Test], tuple[m.Field, ...]]] = [([_function(x)], ()) for x in f.functions if not x.reply]
    if f.silent_when:
        ways.append(([test for c in f.silent_when for test in holding(f, c)], ()))
    for reply in model.replies(f):
        tests = [test for c in reply.when for test in holding(f, c)]
        ways += [([_function(x), *tests], reply.layouts) for x in reply.functions] or [(tests, reply.layouts)]
    rows = []
    for tests, layouts in ways:
        tests = tests or [(0, "MIP_NOT_ZERO")]
        count = max(len(tests), len(layouts))
        for i in range(count):
            layout = layouts[min(i, len(layouts) - 1)] if layouts else None
            at, value = tests[min(i, len(tests) - 1)]
            one_of_several = layout if layout and len(model.layouts(layout)) > 1 else None
            rows.append(Reply(one_of_several, layout.descriptor if layout else 0, at, value, i + 1 < count))
    return rows


def _function(x: m.Function) -> Test:
    return DATA, f"{macro('mip_function_selector')}_{macro(x.name)}"


# --------------------------------------------------------------------------- bits


def bits_type(b: m.Bits) -> str:
    """Returns the type of a number inside a bitfield."""
    return f"uint{next(n for n in (8, 16, 32, 64) if b.width <= n)}_t"


def has_accessor(b: m.Bits, t: m.Bitfield) -> bool:
    """True for a number inside a bitfield, which has get and set functions; flags and bits in bytes are constants."""
    return t.scalar is not None and b.width > 1 and not b.alias
