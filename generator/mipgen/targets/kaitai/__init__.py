"""Kaitai Struct: one file that describes streams, packets and all fields."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target
from mipgen.facts import describe

from . import expressions, names
from .names import member, type_name, value

#: Topics in the documentation of a parameter, besides its description.
TOPICS = ("unit", "frame", "range", "default", "valid", "reserved")


def files(model: m.Model) -> Iterator[File]:
    descriptors = kinds(model)
    several = {home(fields): fields for _, _, fields in descriptors if len(fields) > 1}
    known = {"kinds": descriptors, "several": several.items(), "kind": kind(model), "enums": enums(model)}
    yield File("mip.ksy", "mip.ksy.j2", known)
    yield File("README.md", "README.md.j2", {"readings": readings(model)})


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {
        "member": member,
        "value": value,
        "type": type_name,
        "scalar": names.SCALARS.__getitem__,
        "home": home,
        "cases": lambda p: names.cases(member(p.name)),
        "presence": expressions.present,
        "count": expressions.count,
        "peeks": expressions.peeks,
        "rests": expressions.rests,
        "layouts": expressions.layouts,
        "segments": expressions.segments,
        "alias": expressions.alias,
        "number": expressions.number,
        "text": text,
        "hex": "0x{:02x}".format,
        "hex2": "0x{:04x}".format,
        "prose": lambda words: say(describe.prose(words, model)),
        "about": lambda name, record: about(name, record, model),
        "records": lambda _: records(model),
    }


# --------------------------------------------------------------------------- what there is


def kinds(model: m.Model) -> list[tuple[int, str, tuple[m.Field, ...]]]:
    """Returns every descriptor that can be decoded: its number (set, descriptor), its name in that set, its layouts."""
    layouts: dict[tuple[int, int], list[m.Field]] = {}
    for f in (model.protocol.acknowledge, *model.fields):
        for o in f.occurrences:
            layouts.setdefault((o.set, f.descriptor), []).append(f)
    return [(s << 8 | d, names.kind_name(first(x), s), tuple(x)) for (s, d), x in sorted(layouts.items())]


def first(fields: Sequence[m.Field]) -> m.Field:
    """Returns the layout that names a descriptor: the first in the specification; `fields` are in another order."""
    return min(fields, key=lambda f: f.position or ())


def home(fields: Sequence[m.Field]) -> str:
    """Returns the type of a descriptor's data."""
    return type_name(first(fields)) + ("_layouts" if len(fields) > 1 else "")


def kind(model: m.Model) -> str:
    """Writes the number of a descriptor in `kinds`, where acknowledge and shared fields have one number for many
    sets."""
    ack = model.protocol.acknowledge.descriptor
    numbers = {f.descriptor for f in model.fields if f.everywhere}
    every = ((o.set, f.descriptor) for f in model.fields if not f.everywhere for o in f.occurrences)
    own = sorted({(s, d) for s, d in every if s in m.DATA_SETS and d in numbers})
    terms = [f"set < 0x80 and descriptor == {ack:#04x} ? {ack:#06x}"]
    if numbers:
        but = "".join(f" and not (set == {s:#04x} and descriptor == {d:#04x})" for s, d in own)
        inside = f"descriptor >= {min(numbers):#04x} and descriptor <= {max(numbers):#04x}"
        terms.append(f"set >= 0x80 and {inside}{but} ? {m.SHARED_SET << 8:#06x} | descriptor")
    return " : ".join([*terms, "set << 8 | descriptor"])


def records(model: m.Model) -> list[m.Field]:
    """Returns the fields, each of which has a type."""
    return [model.protocol.acknowledge, *model.fields]


def enums(model: m.Model) -> list[m.Enum]:
    return [model.protocol.function_selector, *(t for t in model.all_types if isinstance(t, m.Enum))]


def readings(model: m.Model) -> dict[str, list[str]]:
    """Returns the parameters whose values have different names by device, or by the value of another parameter."""
    places: dict[str, list[str]] = {"device": [], "parameter": []}
    holders: list[m.Record] = [*m.structs(model.all_types)]
    for record in (*holders, *records(model)):
        for p in record.parameters:
            named = [v for v in p.variants if v.type is not None or v.unknown]
            where = f"`{type_name(record)}.{member(p.name)}`"
            if p.by_device or any(v.by_device for v in named):
                places["device"].append(where)
            if any(not v.by_device for v in named):
                places["parameter"].append(where)
    return places


# --------------------------------------------------------------------------- texts

_PLAIN = re.compile(r"[A-Za-z][\w ,.;()/+-]*(?<! )")
_WORDS = {"true", "false", "null", "yes", "no", "on", "off"}  # these are not text in YAML 1.1


def text(words: str) -> str:
    """Writes a text on one line of YAML.

    >>> text("Speed, in m/s."), text("Of: all"), text('a "b"')
    ('Speed, in m/s.', '"Of: all"', '"a \\\\"b\\\\""')
    """
    plain = _PLAIN.fullmatch(words) and words.lower() not in _WORDS
    return words if plain else json.dumps(words, ensure_ascii=False)


def say(words: Iterable[str | describe.Ref]) -> str:
    return describe.say(words, _named)


def _named(ref: describe.Ref) -> str:
    """Returns the name in the file of a thing to which a text refers."""
    match ref.thing:
        case m.Field() | m.Enum() | m.Bitfield() | m.Struct():
            return f"`{type_name(ref.thing)}`"
        case m.EnumValue():
            return f"`{value(ref.thing.name)}`"
        case m.Bits():
            return f"`{'.'.join(map(member, ref.words.split('.')))}`"
        case m.Parameter():
            return f"`{member(ref.thing.name)}`"
        case _:
            return ref.words


def about(name: str, record: m.Record, model: m.Model) -> str:
    """Composes the documentation of a parameter, or of a union's alternative; empty if there is none."""
    everything = [q for p in record.parameters for q in (p, *p.alternatives)]
    p = next(q for q in everything if q.name == name)
    facts = describe.topics(describe.parameter(p, record, model), *TOPICS) if p in record.parameters else []
    parts = [say(describe.prose(p.description, model)) if p.description else "", *(say(f.sentence) for f in facts)]
    return " ".join(filter(None, parts))


# --------------------------------------------------------------------------- identifiers


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for name in sorted(sys.stdlib_module_names | names.RESERVED):  # a module beside a program hides one of Python
        what = "a module of Python" if name in sys.stdlib_module_names else "a word of a language"
        yield Identifier("the modules", name, f"{name}, {what}", None, word=False)
    yield Identifier("the modules", "mip", "the package", model.protocol.position, word=False)
    for scope, name, what, position in _names(model):
        yield Identifier(scope, names.joined(name), what, position)


Named = tuple[str, str, str, m.Position | None]


def _names(model: m.Model) -> Iterator[Named]:
    for t in (model.protocol.function_selector, *model.all_types):
        yield "mip", type_name(t), t.name, t.position
        yield from _members(t, t.position)
    seen: set[tuple[m.Field, ...]] = set()
    for number, name, fields in kinds(model):
        yield "the enumeration kind", name, f"{fields[0].full_name} ({number:#06x})", fields[0].position
        if len(fields) > 1 and fields not in seen:  # several sets may have the same layouts
            seen.add(fields)
            yield "mip", home(fields), f"layouts of {fields[0].full_name}", fields[0].position
    for f in records(model):
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
    filters=filters,
    identifiers=identifiers,
    rename=package.everywhere,
    grammar=names.GRAMMAR,
    conformance=("decode",),
    needs="Kaitai Struct with Node",
)
