"""Kaitai Struct: one file that describes streams, packets and all fields."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target

from . import expressions, names
from .names import member, type_name, value
from .view import Ksy, type_of_data, yaml_line


def files(model: m.Model) -> Iterator[File]:
    for name in ("mip.ksy", "README.md"):
        yield File(name, f"{name}.j2", {"ksy": model.derived(Ksy)})


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for name in sorted(names.MODULES | names.RESERVED):  # a module beside a program hides one of Python
        what = "a module of Python" if name in names.MODULES else "a word of a language"
        yield Identifier("the modules", name, f"{name}, {what}", None, word=False)
    yield Identifier("the modules", "mip", "the package", model.protocol.position, word=False)
    for scope, name, what, position in _names(model):
        yield Identifier(scope, names.camel_case(name), what, position)


Named = tuple[str, str, str, m.Position | None]


def _names(model: m.Model) -> Iterator[Named]:
    for t in (model.protocol.function_selector, *model.all_types):
        yield "mip", type_name(t), t.name, t.position
        yield from _members(t, t.position)
    seen: set[tuple[m.Field, ...]] = set()
    for number, name, fields in model.derived(Ksy).kinds:
        yield "the enumeration kind", name, f"{fields[0].full_name} ({number:#06x})", fields[0].position
        if len(fields) > 1 and fields not in seen:  # several sets may have the same layouts
            seen.add(fields)
            yield "mip", type_of_data(fields), f"layouts of {fields[0].full_name}", fields[0].position
    for f in model.derived(Ksy).fields:
        yield "mip", type_name(f), f.full_name, f.position
        yield from _members(f, f.position)


def _members(t: m.Type | m.Field, place: m.Position | None) -> Iterator[Named]:
    scope = f"{'the enumeration' if isinstance(t, m.Enum) else 'the type'} {type_name(t)}"
    match t:
        case m.Enum():
            for v in t.values:
                yield scope, value(v.name), v.name, v.position or place
        case m.Bitfield():
            for s in expressions.segments(t):
                yield scope, s.name, s.bits.name if s.bits else "unused bits", place
            for b in t.bits:
                if b.alias:
                    yield scope, member(b.name), b.name, b.position or place
            if t.scalar is not None:
                yield scope, expressions.NUMBER, "the number of all bits", place
        case m.Vector():
            for e in t.elements:
                yield scope, member(e), e, place
        case _:
            yield from _attributes(t, scope, place)


def _attributes(record: m.Record, scope: str, place: m.Position | None) -> Iterator[Named]:
    for p in record.parameters:
        yield scope, member(p.name), p.name, p.position or place
        within = f"the type {names.cases(member(p.name))} of {type_name(record)}"
        yield from ((within, member(q.name), q.name, q.position) for q in p.alternatives)
    for peek in expressions.peeks(record):
        yield scope, peek.name, f"{peek.tag.name}, read ahead", place
    for rest in expressions.rests(record):
        yield scope, rest.name, f"the number of {rest.array}", place


TARGET = Target(
    title="Kaitai Struct, mip.ksy",
    files=files,
    filters={"text": yaml_line, "hex": "0x{:02x}".format},
    identifiers=identifiers,
    rename=package.everywhere,
    grammar=names.GRAMMAR,
    conformance=("decode",),
    needs="Kaitai Struct with Node",
)
