"""The Rust target: a `no_std` crate with one module per family of descriptor sets."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target
from mipgen.facts import describe

from . import commands, docs, names, records, session, tables
from .names import LANGUAGE, constant, home, member, method, module, type_name, variant
from .records import Records

#: The oldest Rust that builds the crate.
OLDEST = "1.65"
#: Example programs, and the features that they need besides descriptor sets.
EXAMPLES = {
    "quickstart": (),
    "log_to_csv": ("std",),
    "stream": ("open",),
    "setup": ("open",),
    "json": ("std", "serde"),
    "tokio_codec": ("std",),
    "firmware": (),
}

#: Files of an example that is a separate package because of its dependencies, and their names in `examples/`.
EMBASSY = {"Cargo.toml": "embassy.toml", "build.rs": "embassy_build.rs", "src/main.rs": "embassy.rs"}


def files(model: m.Model) -> Iterable[File]:
    shown = {name: model.program(f"{name}.rs").rstrip() for name in ("quickstart", "client", "device")} | {
        "stream": model.program("stream.rs").partition("\n\n")[2].rstrip(),
        "oldest": OLDEST,
        "bench": model.program("bench_rust.md").rstrip(),
    }
    examples = {name: needed for name, needed in EXAMPLES.items() if model.program(f"{name}.rs")}
    start = session.of(model)
    given = {"examples": examples, "session": start, "embassy": model.program("embassy.rs")}
    yield File("Cargo.toml", "Cargo.toml.j2", {**given, "oldest": OLDEST, "keywords": keywords(model)})
    yield File("README.md", "README.md.j2", {**given, **shown})
    for name in examples:
        yield File(f"examples/{name}.rs", "verbatim.j2", {"text": model.program(f"{name}.rs")})
    for path, name in EMBASSY.items():
        if text := model.program(name):
            yield File(f"examples/embassy/{path}", "verbatim.j2", {"text": text})
    for page in ("map", "sets"):
        yield File(f"src/{page}.md", f"{page}.md.j2")
    yield File("src/sets.rs", "sets.rs.j2", {"session": start})
    if start:
        yield File("src/sets/session.rs", "session.rs.j2", {"session": start})
    for path in ("types", "protocol", "devices/known", "registry/fields"):
        yield File(f"src/{path}.rs", f"{path}.rs.j2")
    for family in model.families:
        yield File(f"src/sets/{module(family.name)}.rs", "family.rs.j2", {"family": family}, family)


def keywords(model: m.Model) -> list[str]:
    """Returns the keywords for the registry, which allows five."""
    own = [word.lower().replace(" ", "-") for word in model.protocol.keywords]
    return list(dict.fromkeys([model.protocol.package.replace("_", "-"), *own[:2], "no-std", "protocol"]))


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    of, about, rows = model.derived(Records), docs.Docs(model), tables.Tables(model)
    return {
        # names
        "constant": constant,
        "constants": names.constants,
        "home": home,
        "member": member,
        "method": method,
        "module": module,
        "named": names.named,
        "path": names.path,
        "type_name": type_name,
        "variant": variant,
        # types
        "bits_type": names.bits_type,
        "inner": names.inner,
        "rust": of.rust,
        "scalar": names.scalar,
        "set_constant": names.set_constant,
        # records
        "constructors": of.constructors,
        "conversions": lambda _: of.conversions(),
        "derives": of.derives,
        "derives_default": of.derives_default,
        "is_sequence": records.is_sequence,
        "needs": of.needs,
        "places": of.places,
        "members": of.members,
        "members_of": of.members_of,
        "readings": of.readings,
        "serde_module": records.serde_module,
        "settable": of.settable,
        "tuple_of": of.tuple_of,
        "responses_derive": lambda f: records.responses_derive(model.responses(f)),
        "union_derives": records.union_derives,
        "unions_of": of.unions_of,
        "when": records.when,
        # what refers to what
        "answered": model.commands,
        "responses": model.responses,
        # commands
        "answers": commands.answers,
        "call_type": names.call_type,
        "response": commands.response,
        "whole_response": commands.whole_response,
        "response_variant": names.response_variant,
        "silent": commands.silent,
        "holding": lambda conditions, f: commands.holding(conditions, f, of),
        "replies": model.replies,
        # documentation
        "comment": docs.comment,
        "case_doc": about.case,
        "bits_doc": about.bits,
        "conversion_doc": about.conversion,
        "device_doc": about.device,
        "why": lambda e: describe.why(e, model),
        "difference": about.difference,
        "field_doc": about.field,
        "parameter_doc": about.parameter,
        "prose": docs.prose,
        "reading_doc": about.reading,
        "family_doc": about.family,
        "set_doc": about.set,
        "title": docs.title,
        "type_doc": about.type,
        "union_doc": about.union,
        "value_doc": about.value,
        # tables
        "ack_codes": rows.ack_codes,
        "decimal": tables.decimal,
        "described": lambda f: tables.described(f.parameters),
        "groups": lambda _: rows.groups(),
        "hex": lambda n: f"0x{n:02X}",
        "layouts": rows.layouts,
        "linked": rows.linked,
        "numbers": docs.numbers,
        "option": tables.option,
        "quoted": tables.quoted,
        "sizes": rows.sizes,
        "sets": tables.sets,
    }


# --------------------------------------------------------------------------- identifiers


def identifiers(model: m.Model) -> Iterable[Identifier]:
    of = model.derived(Records)
    for fixed in names.modules():
        yield Identifier("the crate", fixed, f"the module {fixed}", None)
    for fixed in LANGUAGE["features"]:
        yield Identifier("the features", fixed, f"the feature {fixed}", None, word=False)
    for function in model.protocol.functions:
        yield Identifier("protocol", names.call_type(function), f"the function {function.name}", None)
    for family in model.families:
        yield from _family(family)
    for t in (model.protocol.function_selector, *model.all_types):
        yield from _type(of, t)
    for f in model.fields:
        yield from _field(model, f)
        yield from _record(of, f, f.full_name)
    for union in of.unions:
        yield from _union(union)
    for d in model.devices:
        yield Identifier("devices", constant(d.name), d.name, d.position)


def _family(family: m.Family) -> Iterator[Identifier]:
    yield Identifier("the features", names.feature(family), family.name, family.position, word=False)
    yield Identifier("the crate", module(family.name), family.name, family.position)
    for s in family.sets:
        if name := names.set_constant(s, family):
            yield Identifier(module(family.name), name, f"the set {s.name}", s.position)


def _field(model: m.Model, f: m.Field) -> Iterator[Identifier]:
    yield Identifier(module(f.family), type_name(f.name), f.full_name, f.position)
    yield Identifier("registry", type_name(f"{f.family}_{f.name}"), f.full_name, f.position)
    if len(f.responses) > 1:
        several = f"the responses of {f.full_name}"
        yield Identifier(module(f.family), names.responses_name(f), several, f.position)
        for r in model.responses(f):
            yield Identifier(several, names.response_variant(r, f), r.name, f.position)


def _union(union: records.Union) -> Iterator[Identifier]:
    position = union.record.position
    where = f"{home(union.record)}::{union.name}"
    what = f"the union {union.parameter.name} of {union.record.name}"
    yield Identifier(home(union.record), union.name, what, position)
    yield Identifier(where, "Other", "an unknown tag", position)
    for case in union.of.cases:
        yield Identifier(where, variant(case.tag.name), case.tag.name, position)


def _type(of: Records, t: m.Type) -> Iterator[Identifier]:
    where = f"{home(t)}::{type_name(t.name)}"
    yield Identifier(home(t), type_name(t.name), t.name, t.position)
    match t:
        case m.Enum():
            for v in t.values:
                yield Identifier(where, constant(v.name), v.name, v.position or t.position)
        case m.Bitfield():
            for b in t.bits:
                for name in (constant(b.name), method(b.name), f"set_{b.name}", f"with_{b.name}"):
                    yield Identifier(where, name, b.name, b.position or t.position)
        case m.Vector():
            for e in t.elements:
                yield Identifier(where, member(e), e, None)
        case m.Struct():
            yield from _record(of, t, t.name)


def _record(of: Records, record: m.Record, what: str) -> Iterator[Identifier]:
    methods = f"the methods of {what}"
    for x in of.members(record):
        yield Identifier(what, x.name, x.parameter.name, x.parameter.position)
    for c in of.constructors(record):
        yield Identifier(methods, c.name, c.name, record.position)
    for x in of.settable(record):
        yield Identifier(methods, f"with_{x.parameter.name}", x.parameter.name, record.position)
    for r in of.readings(record):
        yield Identifier(methods, r.name, r.name, record.position)


TARGET = Target(
    title="Rust, no_std",
    files=files,
    filters=filters,
    identifiers=identifiers,
    rename=package.in_source,
    grammar=names.GRAMMAR,
    conformance=("parse", "decode", "encode", "client", "live"),
    program="cargo",
)
