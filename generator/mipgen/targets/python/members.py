"""Members of objects, their types and defaults, and the parameters of constructors."""

from __future__ import annotations

import math

from mipgen import model as m
from mipgen.lower import calls
from mipgen.lower.calls import constructors, members
from mipgen.lower.runs import run

from .names import ANNOTATIONS, SCALARS, constant, home, member, reference


def held(record: m.Record) -> tuple[str, ...]:
    """Returns the names of the members."""
    return tuple(member(p.name) for p in members(record))


def is_shared(f: m.Field) -> bool:
    """True for a field that occurs in several sets."""
    return len(f.sets) > 1


def sets(f: m.Field) -> str:
    """Writes the numbers of the sets in which a field occurs."""
    if f.everywhere:
        return f"range(0x{f.everywhere.start:02X}, 0x{f.everywhere.stop:02X})"
    return f"({', '.join(f'0x{n:02X}' for n in f.sets)},)"


def annotation(p: m.Parameter, record: m.Record) -> str:
    """Returns the type of a parameter's value when it is present."""
    one = _one(p, record)
    if not is_array(p):
        return one
    few = few_elements(p)
    return f"tuple[{', '.join([one] * few)}]" if few else f"tuple[{one}, ...]"


def is_array(p: m.Parameter) -> bool:
    """True for several elements in a tuple; a text or a vector is one value."""
    return p.kind == "array" and not p.vector


def few_elements(p: m.Parameter) -> int:
    """Returns the length of an array whose tuple type lists each element; 0 for any other type."""
    plain = is_array(p) and not (p.leaf.named or p.leaf.struct)
    return p.capacity if plain and not p.open and p.capacity <= 4 else 0


def _one(p: m.Parameter, record: m.Record) -> str:
    match p.element:
        case m.Scalar() as scalar:
            return "str" if scalar.kind == "char" and p.length is not None else ANNOTATIONS[scalar.kind]
        case None:
            kinds = [annotation(c.parameter, record) for c in p.cases if c.parameter is not None]
            return " | ".join([*dict.fromkeys(kinds), "None"])
        case t:
            return reference(t, home(record))


def hint(p: m.Parameter, record: m.Record) -> str:
    """Returns the type of a member."""
    one = annotation(p, record)
    return f"{one} | None" if may_be_absent(p, record) and p.element is not None else one


def may_be_absent(p: m.Parameter, record: m.Record) -> bool:
    """True if the member can be None because it was not sent."""
    return p.name in record.present_with


def default(p: m.Parameter, record: m.Record) -> str | None:
    """Returns the value of a member that the caller omits; None if it must be passed."""
    if may_be_absent(p, record) or p.element is None:
        return "None"
    return None if p.reserved is None else _reserved(p)


def _reserved(p: m.Parameter) -> str:
    if p.length is None:
        return str(p.reserved)
    few = few_elements(p)
    return repr((p.reserved,) * few) if few else f"({p.reserved},) * {p.length}"


def keyword_only(p: m.Parameter, record: m.Record) -> bool:
    """True if a member with a default precedes members without one, and is therefore passed only by name."""
    held = members(record)
    return default(p, record) is not None and any(default(q, record) is None for q in held[held.index(p) + 1 :])


def by_place(record: m.Record) -> tuple[str, ...]:
    """Returns the members that a caller may pass by position."""
    return tuple(member(p.name) for p in members(record) if not keyword_only(p, record))


def initial(record: m.Record) -> list[str]:
    """Writes the parameters of the constructor."""
    by_place: list[str] = []
    by_name: list[str] = []
    for p in members(record):
        value = default(p, record)
        given = f"{member(p.name)}: {accepted(p, record)}" + ("" if value is None else f" = {value}")
        (by_name if keyword_only(p, record) else by_place).append(given)
    return [*by_place, "*", *by_name] if by_name else by_place


def accepted(p: m.Parameter, record: m.Record) -> str:
    """Returns the type of the argument for a member."""
    one = _needed(p, record)
    return f"{one} | None" if may_be_absent(p, record) and p.element is not None else one


def _needed(p: m.Parameter, record: m.Record) -> str:
    """Returns the same for a member that is present: a vector accepts any numbers, an array any sequence."""
    kinds = vectors(p)
    numbers = "codec.Rows" if any(columns(v) for v in kinds) else "codec.Numbers"
    if is_array(p):
        return f"Sequence[{f'{_one(p, record)} | {numbers}' if kinds else _one(p, record)}]"
    return f"{annotation(p, record)} | {numbers}" if kinds else annotation(p, record)


def kept(p: m.Parameter, record: m.Record) -> str:
    """Writes the value that the object stores for an argument."""
    name, kinds = member(p.name), ", ".join(reference(v, home(record)) for v in vectors(p))
    if kinds:
        return f"codec.{'vectors' if is_array(p) else 'vector'}({name}, {kinds})"
    return f"codec.several({name})" if is_array(p) else name


def vectors(p: m.Parameter) -> list[m.Vector]:
    """Returns the vectors that a member or its elements may be."""
    if p.element is None:
        return list(dict.fromkeys(v for c in p.cases if c.parameter for v in vectors(c.parameter)))
    return [p.element] if isinstance(p.element, m.Vector) else []


def vector_members(record: m.Record) -> dict[str, list[str]]:
    """Returns the members that are vectors, each with its possible classes in Python's notation."""
    single = [p for p in members(record) if p.length is None and vectors(p)]
    return {member(p.name): [reference(v, home(record)) for v in vectors(p)] for p in single}


def columns(v: m.Vector) -> int:
    """Returns the number of columns of a matrix, whose elements are named by row and column, m11, m12 …; else 0.

    >>> columns(m.Vector("matrix2f", m.SCALARS["float"], ("m11", "m12", "m21", "m22"), ""))
    2
    """
    count = math.isqrt(len(v.elements))
    places = [f"m{row}{column}" for row in range(1, count + 1) for column in range(1, count + 1)]
    return count if count > 1 and places == list(v.elements) else 0


def layout(record: m.Record) -> list[tuple[str, str, str]]:
    """Returns the rows of a layout in the form that the package's module `wire` uses: name, letters for `struct`, and
    the function that makes the value."""
    return [_row(p, record) for p in record.parameters]


def always(record: m.Record) -> int | None:
    """Returns the number of parameters that are always present; None if all are."""
    return len(record.always) if record.optional else None


def _row(p: m.Parameter, record: m.Record) -> tuple[str, str, str]:
    name, where = member(p.name), home(record)
    numbers = None if p.kind == "text" else run(p)
    if numbers:
        letters = SCALARS[numbers.scalar.name] * (numbers.count or 1)
        return name, letters, _made(p, numbers.count is not None, record, where)
    if p.struct:
        return name, "", reference(p.struct, where)
    if p.union:
        cases = {c.tag.value: _row(c.parameter, record) for c in p.cases if c.parameter}
        rows = ", ".join(f'{n}: ("{name}", "{letters}", {what})' for n, (name, letters, what) in cases.items())
        return name, "", f'wire.Union("{member(p.union.tag)}", {{{rows}}})'
    item = p.item
    length = f'"{member(p.counter)}"' if p.counter else p.count
    if item.struct:
        return name, "", f"wire.Items({reference(item.struct, where)}, {length}, {p.capacity})"
    if item.vector:
        letters = SCALARS[item.scalar.name] * item.capacity
        return name, letters, f"wire.Items({reference(item.vector, where)}, {length}, {p.capacity})"
    if p.kind == "array":
        letters = SCALARS[item.scalar.name]
        return name, letters, f"wire.Items({_convert(item, where)}, {length}, {p.capacity})"
    return name, "", f"wire.Text({length}, {p.capacity})"


def _made(p: m.Parameter, several: bool, record: m.Record, where: str) -> str:
    """Writes the expression that makes the value from plain numbers."""
    if p.constant is not None:
        return str(p.constant)
    if p.counts is not None:
        (array,) = (q for q in record.parameters if q.name == p.counts)
        return f'wire.Counts("{member(p.counts)}", {array.capacity})'
    if p.vector:
        return reference(p.vector, where)
    one = _convert(p.leaf, where)
    if p.kind == "bits":
        return f"wire.Bits({one})"
    return one if not several else "tuple" if one == "None" else f"wire.Each({one})"


def _convert(p: m.Parameter, where: str) -> str:
    """Returns the function that converts a number to a value."""
    if p.named is not None:
        return reference(p.named, where)
    return "codec.truth" if p.kind == "scalar" and p.scalar.kind == "bool" else "None"


# --------------------------------------------------------------------------- constructors


def parameters(way: m.Call, record: m.Field) -> list[str]:
    """Writes the parameters of the constructor for a function: the required ones, then the optional ones."""
    asked = [f"{member(p.name)}: {_needed(p, record)}" for p in way.values]
    return asked + [f"{member(p.name)}: {accepted(p, record)} = None" for p in way.addable]


def arguments(way: m.Call) -> list[str]:
    """Writes the arguments that this constructor passes on after the function."""
    passed = []
    for p in way.required:
        if not p.derived:
            passed.append(f"{member(p.name)}={member(p.name) if p.reserved is None else _reserved(p)}")
    for i, p in enumerate(way.optional):
        later = [q for q in way.optional[i:] if q in way.addable]
        if p in way.addable:
            passed.append(f"{member(p.name)}={member(p.name)}")
        elif p.reserved is not None and later:  # sent only with the parameters after it
            passed.append(f"{member(p.name)}={_reserved(p)} if {member(later[0].name)} is not None else None")
    return passed


# --------------------------------------------------------------------------- presence and acknowledges


def holding(c: m.Condition, negated: bool = False) -> str:
    """Writes a condition on a member of a command, or its negation; for a Boolean, everything but 0 is true."""
    value = f"self.{member(c.parameter)}"
    if c.boolean:
        return value if bool(c.value) != negated else f"not {value}"
    return f"{value} {'!=' if negated else '=='} {c.value}"


def answered(f: m.Field) -> str:
    """Writes the condition under which the device sends an acknowledge; empty if it always does."""
    tests = [f"self.function != FunctionSelector.{constant(x.name)}" for x in f.functions if not x.reply]
    if f.silent_when:
        tests.append(f"({' or '.join(holding(c, negated=True) for c in f.silent_when)})")
    return " and ".join(tests)


def expected(f: m.Field, model: m.Model) -> list[tuple[str, list[str]]]:
    """Returns the condition under which each response of a command is sent, and its layouts; empty if there are no
    conditions."""
    responses = []
    for reply in model.replies(f):
        functions = [f"self.function == FunctionSelector.{constant(x.name)}" for x in reply.functions]
        tests = [" or ".join(functions)] if functions else []
        tests += [holding(c) for c in reply.when]
        condition = " and ".join(f"({t})" if " or " in t and len(tests) > 1 else t for t in tests)
        responses.append((condition or "True", [reference(layout, home(f)) for layout in reply.layouts]))
    return responses if any(condition != "True" for condition, _ in responses) else []


def answer(function: m.Function | None, f: m.Field, model: m.Model) -> str:
    """Returns the result type of a command with this function: a response, one of several, or None."""
    layouts = calls.answers(f, function, model)
    return " | ".join(dict.fromkeys(reference(layout, home(f)) for layout in layouts)) or "None"


def answers(f: m.Field, model: m.Model) -> str:
    """Returns the same for a command with any function; empty if the type depends on the function."""
    types = {answer(way.function, f, model) for way in constructors(f)}
    return types.pop() if len(types) == 1 else ""


def silencers(f: m.Field, model: m.Model) -> list[tuple[int, int, str, int]]:
    """Returns the settings that suppress the acknowledge of a command: set, descriptor, member and value."""
    settings = []
    for c in f.silenced_by:
        setting = model.field(c.command or "")
        assert setting is not None
        settings.append((setting.set, setting.descriptor, member(c.parameter), c.value))
    return settings


def matches(f: m.Field, model: m.Model) -> str:
    """Writes the condition that `data` belongs to a field; empty if any data may."""
    sizes = model.sizes(f)
    tests = [f"{sizes.start} <= len(data)"] if sizes.start else []
    if sizes.stop <= m.MAX_FIELD_DATA:
        tests = [f"{sizes.start} <= len(data) < {sizes.stop}" if sizes.start else f"len(data) < {sizes.stop}"]
    tests += [f"{octets!r}.startswith(data[{at}:{at + len(octets)}])" for at, octets in f.signature]
    return " and ".join(tests)
