"""Names in C."""

from __future__ import annotations

from mipgen import model as m
from mipgen.emit.naming import Escape, Grammar, upper
from mipgen.emit.render import language

from . import runtime

LANGUAGE = language("c")
_KEYWORDS = frozenset(LANGUAGE["keywords"])
_SCALARS: dict[str, str] = LANGUAGE["scalars"]

#: Identifiers of C99 that differ only after their first 63 characters may be the same.
GRAMMAR = Grammar(r"[A-Za-z_]\w*", _KEYWORDS, longest=63)

#: C++ does not allow a member that has the name of a type which its structure uses.
member = Escape(_KEYWORDS | frozenset(LANGUAGE["members"]) | frozenset(_SCALARS.values()), digit_prefix="n")
module = Escape(runtime.modules(), digit_prefix="")
macro = upper
_argument = Escape(frozenset(LANGUAGE["arguments"]), digit_prefix="n")


def argument_name(name: str) -> str:
    """Returns the name of a member's argument."""
    return _argument(member(name))


def count_argument(p: m.Parameter) -> str:
    """Returns the name of the argument that counts the elements of an array."""
    return argument_name(p.counter) if p.counter else f"{argument_name(p.name).rstrip('_')}_count"


def short(thing: m.Field | m.Enum | m.Bitfield | m.Struct | m.EnumValue | m.Bits) -> str:
    """Returns the name of a thing, or the shorter one that the specification defines for C."""
    return thing.short or thing.name


def type_name(t: m.Type) -> str:
    """Returns the name of a type, prefixed with the name of its family, which is not repeated."""
    if isinstance(t, m.Vector):
        return f"mip_{t.name}"
    return f"mip_{t.owner}_{short(t).removeprefix(f'{t.owner}_')}" if t.owner else f"mip_{short(t)}"


def field_name(f: m.Field) -> str:
    return f"mip_{f.family}_{short(f)}"


def set_constant(s: m.Set) -> str:
    return f"{macro(f'mip_{s.name}')}_SET"


def symbol(thing: m.Type | m.Field) -> str:
    """Returns the C name of a field's type, or of a type."""
    return field_name(thing) if isinstance(thing, m.Field) else type_name(thing)


def union_name(p: m.Parameter, owner: m.Record) -> str:
    """Returns the type of a union."""
    if p.union and p.union.name:
        return symbol(owner).removesuffix(short(owner)) + p.union.name
    return f"{symbol(owner)}_{p.name}"


def union_owner(p: m.Parameter, record: m.Record, model: m.Model) -> m.Record:
    """Returns the record that defines the type of a union: of a response, its command, if that has the same union."""
    commands = model.commands(record) if isinstance(record, m.Field) and record.role == m.RESPONSE else ()
    same = (f for f in commands if any(q.name == p.name and same_type(p, q) for q in f.parameters))
    return next(same, record)


def same_type(p: m.Parameter, q: m.Parameter) -> bool:
    """True if two members have the same type, whatever is said of them."""
    return all((p.element == q.element, p.length == q.length, _alternatives(p) == _alternatives(q)))


def _alternatives(p: m.Parameter) -> list[object]:
    return [(c.tag.value, c.parameter and (c.parameter.name, c.parameter.element, c.parameter.length)) for c in p.cases]


def constant(t: m.Enum | m.Bitfield, part: m.EnumValue | m.Bits) -> str:
    return macro(f"{type_name(t)}_{short(part)}")


def accessor(t: m.Bitfield, verb: str, b: m.Bits) -> str:
    """Returns the function that gets or sets a number inside a bitfield."""
    return f"{type_name(t)}_{verb}_{short(b)}"


def bare(thing: m.Type | m.Field) -> str:
    """Returns a name without the library's prefix, for static names in a source file."""
    return symbol(thing).removeprefix("mip_")


def names_table(t: m.Enum | m.Bitfield) -> str:
    """Returns the name of the table with the names of a type's values or bits."""
    return f"mip_names_{bare(t)}"


def is_enum(e: m.Scalar | m.Type | None) -> bool:
    """Is it an enumeration in C too? There, all values are of type int, which has 16 bits on some machines."""
    return isinstance(e, m.Enum) and all(v.value <= 0x7FFF for v in e.values)


def c_type(e: m.Scalar | m.Type, structure: str = "struct ") -> str:
    """Returns the C type of one item: for a vector, that of its elements; for an enumeration, an integer of its
    width. `structure` precedes the name of a structure."""
    match e:
        case m.Scalar():
            return _SCALARS[e.name]
        case m.Vector() | m.Enum():
            return _SCALARS[e.scalar.name]
        case m.Bitfield(scalar=m.Scalar()):
            return type_name(e)
        case _:
            return f"{structure}{type_name(e)}"


def is_struct(e: m.Scalar | m.Type | None) -> bool:
    """Is one item a C structure, which is passed by address?"""
    return isinstance(e, m.Struct) or in_bytes(e)


def in_bytes(e: m.Scalar | m.Type | None) -> bool:
    """True for a bitfield that is an array of bytes instead of a number."""
    return isinstance(e, m.Bitfield) and e.scalar is None
