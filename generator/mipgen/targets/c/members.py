"""Members of structures, and arguments of the functions that fill them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import calls, extent
from mipgen.lower.memory import stored

from .literals import hexadecimal
from .names import (
    argument_name,
    c_type,
    constant,
    count_argument,
    field_name,
    is_enum,
    is_struct,
    macro,
    member,
    same_type,
    type_name,
    union_name,
    union_owner,
)


@dataclass(frozen=True, slots=True)
class CFunction:
    """An inline function of a header."""

    name: str
    doc: list[str]
    result: str  # its storage and type
    declarations: list[str]  # of its arguments
    statements: list[str]


def in_order(family: m.Family) -> Iterator[m.Field]:
    """Yields the fields of a family, each command followed by its own responses."""
    for f in family.fields:
        if f.role != m.RESPONSE:
            yield f
            yield from (r for r in family.fields if r.role == m.RESPONSE and r.command == f.name)


def declaration(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    """Declares a member: `float bias[3]`."""
    if p.element is None:
        return f"union {union_name(p, union_owner(p, record, model))} {member(p.name)}"
    return f"{c_type(p.element)} {member(p.name)}{dimensions(p)}"


def dimensions(p: m.Parameter) -> str:
    """Writes the brackets after a member's name."""
    if p.kind == "text":
        return f"[{p.capacity + 1}]"
    return f"[{capacity(p)}]{dimensions(p.item)}" if p.several else ""


def capacity(p: m.Parameter) -> str:
    """Writes the capacity of an array: where the stated range needs less than half of what fits into a field, users
    choose."""
    few = p.counter is not None and p.stated * 2 < p.capacity
    return f"MIP_ROOM({p.stated}, {p.capacity})" if few else str(max(1, p.capacity))


def union_prefix(alternative: m.Parameter) -> str:
    """Writes the prefix of a union's alternative; one that fills the field shares a structure with its count."""
    return f"{member(alternative.name)}." if alternative.fills else ""


def last_present(f: m.Field) -> list[tuple[m.Parameter, int]]:
    """Returns the optional parameters, each with the value of `present` when it is the last one present."""
    return [(p, f.present_with[p.name]) for p in stored(f) if p.optional and not p.counts]


# --------------------------------------------------------------------------- constructors


@dataclass(frozen=True, slots=True)
class Constructor:
    """A function that fills the structure of a command: one for each of its functions, or just one."""

    field: m.Field
    function: m.Function | None
    parameters: tuple[m.Parameter, ...]  # what the caller passes

    @property
    def name(self) -> str:
        return self.function.name if self.function else "make"

    @property
    def assigned(self) -> list[m.Parameter]:
        """What the caller passes, and reserved values that are not zero."""
        return [p for p in stored(self.field) if p in self.parameters or p.reserved]

    @property
    def macro(self) -> tuple[str, str, str] | None:
        """The arguments of MIP_FILL, if there is only the function selector to fill."""
        if self.function is None or self.assigned:
            return None
        return field_name(self.field), self.name, selector(self.function)

    def fill(self) -> CFunction:
        name, what = field_name(self.field), f" for `{self.function.name}`" if self.function else ""
        doc = [f"Fills the structure{what}, and returns it."]
        declarations = [f"struct {name} *command", *(argument(p, self.field) for p in self.parameters)]
        function = [f"command->function = {selector(self.function)};"] if self.function else []
        unions = [p for p in self.parameters if p.union]
        refused = [line for p in unions if self.function for line in _refused(p)]
        doc += [f"A {p.tag} without a name cannot be sent: {REFUSED}." for p in unions if refused]
        assigned = ["memset(command, 0, sizeof(*command));", *function, *map(_assignment, self.assigned), *refused]
        return CFunction(
            f"{name}_{self.name}", doc, f"static inline struct {name} *", declarations, [*assigned, "return command;"]
        )


def constructors(f: m.Field) -> list[Constructor]:
    if f.role != m.COMMAND or not (f.functions or any(p.reserved is None for p in stored(f))):
        return []
    ways = calls.constructors(f)
    return [Constructor(f, way.function, tuple(p for p in stored(f) if p in way.passed)) for way in ways]


#: How a constructor refuses: the function selector stays 0, which no device answers.
REFUSED = "the function stays 0, and sending fails with MIP_ERROR_MISSING"


def _refused(union: m.Parameter) -> list[str]:
    """Refuses a tag that selects no alternative: nobody knows what belongs to it."""
    assert union.union
    tag = f"command->{member(union.union.tag)}"
    unknown = " && ".join(f"{tag} != {constant(union.union.type, c.tag)}" for c in union.cases)
    return [f"if ({unknown}) {{", "command->function = 0;", "}"]


def write_from_response(f: m.Field, model: m.Model) -> CFunction | None:
    """Returns the function that fills a command with the values of its response, to read, change and write them; None
    if the response does not contain them all."""
    way = next((c for c in constructors(f) if c.function and c.function.sets), None)
    responses = model.responses(f)
    if way is None or not way.parameters or len(responses) != 1 or responses[0].command != f.name:
        return None
    available = {p.name: p for p in stored(responses[0])}
    if not all(p.name in available and same_type(p, available[p.name]) for p in way.parameters):
        return None
    name, values = field_name(f), [x for p in way.parameters for x in _values_of(p)]
    declarations = [f"struct {name} *command", f"const struct {field_name(responses[0])} *response"]
    doc = f"Fills the structure for `{way.name}` with the values of a response, and returns it."
    call = f"return {name}_{way.name}({', '.join(('command', *values))});"
    return CFunction(f"{name}_{way.name}_from", [doc], f"static inline struct {name} *", declarations, [call])


def _values_of(p: m.Parameter) -> list[str]:
    """Writes the arguments that a member of a response is."""
    at = f"response->{member(p.name)}"
    if p.fills:
        return [f"{at}_count", at]
    if takes_enum(p):
        assert isinstance(p.element, m.Enum)
        return [f"(enum {type_name(p.element)}){at}"]
    return [f"&{at}" if p.kind in ("switch", "struct", "bits") else at]


def _assignment(p: m.Parameter) -> str:
    """Assigns an argument, or a reserved value, to a member of the structure."""
    at, name = f"command->{member(p.name)}", argument_name(p.name)
    if p.reserved is not None:
        return _reserved(p, "command->")
    match p.kind:
        case "switch":
            return f"if ({name} != NULL) {{\n{at} = *{name};\n}}"
        case "text" if p.count is not None:
            return f"mip_copy_text({at}, sizeof({at}), {name});"
        case "array" if p.count is not None:
            return f"memcpy({at}, {name}, sizeof({at}));"
        case "text" | "array":
            count = count_argument(p)
            counted = "" if p.counter else f"{at}_count = {count};\n"
            room = f"sizeof({at}){' - 1' if p.kind == 'text' else ''}"
            return f"{counted}mip_copy({at}, {room}, {name}, mip_counted({count}, {name}, sizeof({name}[0])));"
        case "struct" | "bits":
            inside = p.struct.parameters if p.struct else ()
            return "\n".join([f"{at} = *{name};", *(_reserved(q, f"{at}.") for q in inside if q.reserved is not None)])
        case "scalar" if takes_enum(p):
            return f"{at} = ({c_type(p.scalar)}){name};"
        case "scalar" if p.scalar.kind == "bool":
            return f"{at} = mip_truth({name});"
    return f"{at} = {name};"


def _reserved(p: m.Parameter, record: str) -> str:
    """Assigns a reserved value, so that callers need not."""
    assigned = f"{record}{member(p.name)}{'' if p.length is None else '[i]'} = {p.reserved};"
    return assigned if p.length is None else f"for (size_t i = 0; i < {p.capacity}; i++) {{\n{assigned}\n}}"


def argument(p: m.Parameter, f: m.Field) -> str:
    """Declares the arguments for a parameter: one, or a count and the elements."""
    name = argument_name(p.name)
    if p.element is None:
        return f"const union {union_name(p, f)} *{name}"
    element = c_type(p.element)
    count = f"uint8_t {count_argument(p)}, " if p.fills else ""
    if p.kind == "text":
        return f"{count}const char *{name}"
    if p.kind == "array":
        first = "" if p.count is None else p.count
        return f"{count}const {element} {name}[{first}]{dimensions(p.item)}"
    if takes_enum(p):
        assert isinstance(p.element, m.Enum)
        return f"enum {type_name(p.element)} {name}"
    return f"const {element} *{name}" if is_struct(p.element) else f"{element} {name}"


def takes_enum(p: m.Parameter) -> bool:
    """Is its argument an enumeration, so that the compiler detects values of another one?

    Not if it has several bytes on the wire: a C compiler may store an enumeration with small values in a single byte.
    """
    return p.length is None and isinstance(p.element, m.Enum) and is_enum(p.element) and p.element.scalar.size == 1


#: A test of a command: an offset in its field, which begins with length and descriptor, and the value at that offset.
Test = tuple[int, str]
DATA = 2


def condition_tests(f: m.Field, c: m.Condition) -> list[Test]:
    """Returns the tests of a command's bytes for a condition; for a Boolean, everything but 0 is true."""
    p = next(q for q in f.parameters if q.name == c.parameter)
    before = [extent.size(q) for q in f.parameters[: f.parameters.index(p)]]
    assert all(least == most for least, most in before), f"{f.full_name}.{p.name}: no fixed place"
    at = DATA + sum(size for size, _ in before)
    if c.boolean and c.value:
        return [(at, "MIP_NOT_ZERO")]
    return [(at + i, str(byte)) for i, byte in enumerate(c.value.to_bytes(p.size, "big"))]


def reply_rows(f: m.Field, model: m.Model) -> list[str]:
    """Writes the replies to a command, see `mip_response` in client.h: rows with one layout of a response and one test
    of the command. If there are fewer layouts than tests, or the reverse, the last one is repeated."""
    silent = [x for x in f.functions if not x.reply]
    ways: list[tuple[list[Test], tuple[m.Field, ...]]] = [([(DATA, selector(x))], ()) for x in silent]
    if f.silent_when:
        ways.append(([test for c in f.silent_when for test in condition_tests(f, c)], ()))
    for reply in model.replies(f):
        tests = [test for c in reply.when for test in condition_tests(f, c)]
        ways += [([(DATA, selector(x)), *tests], reply.layouts) for x in reply.functions] or [(tests, reply.layouts)]
    rows = []
    for tests, layouts in ways:
        tests = tests or [(0, "MIP_NOT_ZERO")]
        count = max(len(tests), len(layouts))
        for i in range(count):
            layout = layouts[min(i, len(layouts) - 1)] if layouts else None
            at, value = tests[min(i, len(tests) - 1)]
            codec = f"&{field_name(layout)}_codec" if layout and len(model.layouts(layout)) > 1 else "NULL"
            descriptor, more = hexadecimal(layout.descriptor if layout else 0), str(i + 1 < count).lower()
            rows.append(f"{{{codec}, {descriptor}, {at}, {value}, {more}}}")
    return rows


def selector(x: m.Function) -> str:
    """Returns the constant of a function selector."""
    return f"MIP_FUNCTION_SELECTOR_{macro(x.name)}"


# --------------------------------------------------------------------------- bits


def bits_type(b: m.Bits) -> str:
    """Returns the type of a number inside a bitfield."""
    return f"uint{next(n for n in (8, 16, 32, 64) if b.width <= n)}_t"


def has_accessor(b: m.Bits, t: m.Bitfield) -> bool:
    """True for a number inside a bitfield, which has get and set functions; flags and bits in bytes are constants."""
    return t.scalar is not None and b.width > 1 and not b.alias
