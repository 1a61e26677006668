"""What the bindings have for each field and type, by language."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from ... import model as m
from .. import python as python_target
from ..c import calls
from ..c import names as c
from ..c.identifiers import of_field, of_type
from ..python import names as python
from ..rust import names as rust
from ..rust.records import Records


@dataclass(frozen=True, slots=True)
class Symbols:
    """The type of a field, or a type, in a language; and what belongs to it: functions, constants."""

    thing: m.Type | m.Field
    name: str
    others: tuple[str, ...]


def things(model: m.Model) -> Iterator[m.Type | m.Field]:
    """Types and fields, those of the protocol first, then set by set."""
    protocol = (model.protocol.function_selector, *model.types, model.protocol.acknowledge)
    for group in (protocol, *((*s.types, *s.fields) for s in model.sets)):
        yield from sorted(group, key=lambda x: x.name)


def in_c(model: m.Model) -> Iterator[Symbols]:
    for x in things(model):
        if isinstance(x, m.Field):
            found = [i.name for i in of_field(x) if i.scope == "C"] + [*calls.identifiers(x, model)]
            name = c.field_name(x)
        elif isinstance(x, m.Vector):
            continue  # an array
        else:
            typed = not isinstance(x, m.Enum) or c.is_enum(x)  # else it has numbers and no type
            found = [i.name for i in of_type(x) if i.scope == "C" and (typed or i.name != c.type_name(x))]
            name = c.type_name(x) if typed else f"{c.type_name(x)}_name"
        yield Symbols(x, name, tuple(n for n in found if n != name))


def in_python(model: m.Model) -> Iterator[Symbols]:
    for x in things(model):
        of = python.class_name(x)
        if isinstance(x, m.Field):
            found = [python.member(f.name) for f in x.functions]
        else:
            found = [name for name, *_ in python_target.attributes(x)] if not isinstance(x, m.Struct) else []
        yield Symbols(x, f"{python_target.PACKAGE}.{python.qualified(x)}", tuple(f"{of}.{name}" for name in found))


def in_rust(model: m.Model) -> Iterator[Symbols]:
    records = Records(model)
    for x in things(model):
        of = rust.type_name(x.name)
        yield Symbols(x, f"mip_protocol::{rust.home(x)}::{of}", tuple(_rust(x, of, records)))


def _rust(x: m.Type | m.Field, of: str, records: Records) -> Iterator[str]:
    match x:
        case m.Enum():
            yield from (f"{of}::{rust.constant(v.name)}" for v in x.values)
        case m.Bitfield():
            for b in x.bits:
                yield from (f"{of}::{rust.constant(b.name)}", f"{of}::{rust.method(b.name)}")
                yield from (f"{of}::set_{b.name}", f"{of}::with_{b.name}")
        case m.Field() | m.Struct():
            yield from (f"{of}::{c.name}" for c in records.constructors(x))
            yield from (f"{of}::with_{p.parameter.name}" for p in records.settable(x))
            yield from (f"{of}::{r.name}" for r in records.readings(x))
            for union in records.unions_of(x):
                yield union.name
                yield from (f"{union.name}::{rust.variant(k.tag.name)}" for k in union.operation.cases)
    if isinstance(x, m.Field) and len(x.responses) > 1:
        yield rust.responses_name(x)


#: What a language is called in paths -> its symbols.
LANGUAGES: dict[str, Callable[[m.Model], Iterator[Symbols]]] = {"c": in_c, "python": in_python, "rust": in_rust}
