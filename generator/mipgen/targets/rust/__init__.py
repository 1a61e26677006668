"""The Rust target: a `no_std` crate with one module per family of descriptor sets.

The finished source is in runtime/rust. Where to change what, and its tests in `tests/rust`:

- a device at a port: src/device*; `cases/device.rs`, `features/embedded.rs`, `test_rust_examples.py`
- finding a device, starting its data, a lost port: `session`, session.rs.j2, device/line.rs; `test_rust_first_day.py`,
  with devices that block and that are awaited
- which field a device rejects: src/devices/rejected.rs, devices/lists.rs.j2; the rule, lower/lists; `test_rust_time.py`
- the time of packets and the validity of values: src/time.rs, `view/clocks`, `Validity` in `view/records`; the rule,
  lower/validity; `test_rust_time.py`, which compares with Python
- what `serde` writes in human-readable formats: src/readable.rs, `serde` in `view/records`; `features`
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target
from mipgen.lower import lists

from . import docs, literals, names, session
from .names import constant, home, member, module, type_name, variant
from .view import Crate, Record, Union, clocks, part_names

#: The oldest Rust that builds the crate.
OLDEST = "1.65"
#: Example programs, and the features that they need besides descriptor sets.
EXAMPLES = {
    "quickstart": (),
    "log_to_csv": ("std",),
    "stream": ("open",),
    "json": ("std", "serde"),
    "two_tasks": ("tokio",),
    "firmware": (),
}

#: Files of an example that is a separate package because of its dependencies, and their names in `examples/`.
EMBASSY = {"Cargo.toml": "embassy.toml", "build.rs": "embassy_build.rs", "src/main.rs": "embassy.rs"}


def files(model: m.Model) -> Iterable[File]:
    crate = model.derived(Crate)
    readme = {name: model.program(f"{name}.rs").rstrip() for name in ("quickstart", "client", "device")} | {
        "stream": model.program("stream.rs").partition("\n\n")[2].rstrip(),
        "embassy": model.program("embassy.rs"),
        "bench": model.program("bench_rust.md").rstrip(),
        "compatible": model.protocol.version.rpartition(".")[0],
        "packet_size": model.protocol.max_packet,
    }
    examples = {name: features for name, features in EXAMPLES.items() if model.program(f"{name}.rs")}
    start = session.compose(model)
    whole = {"crate": crate, "session": start}
    manifest = {"oldest": OLDEST, "session_features": start.families if start else (), "examples": examples}
    yield File("Cargo.toml", "Cargo.toml.j2", {**whole, **manifest, "keywords": keywords(model)})
    for path, template in (("README.md", "README.md.j2"), ("src/guide.md", "guide.md.j2")):
        yield File(path, template, {**whole, **manifest, **readme})
    for name in examples:
        yield File(f"examples/{name}.rs", "", {"text": model.program(f"{name}.rs")})
    for path, name in EMBASSY.items():
        if text := model.program(name):
            yield File(f"examples/embassy/{path}", "", {"text": text})
    yield File("src/map.md", "map.md.j2")
    yield File("src/sets.md", "sets.md.j2", whole)
    modules = [(x.name, f'feature = "{x.name}"') for x in crate.families]
    modules += [("session", f"all({start.needs})")] if start else []
    yield File("src/sets.rs", "sets.rs.j2", {"session": start, "modules": sorted(modules)})
    if start:
        yield File("src/sets/session.rs", "session.rs.j2", whole)
    for path in ("types", "protocol", "devices/known", "registry/fields"):
        yield File(f"src/{path}.rs", f"{path}.rs.j2", whole)
    descriptors = lists.defined(model)
    data_sets = [(s.number, s.name, descriptors.get(s.number, ())) for s in model.sets if s.kind != "command"]
    listed = {"lists": lists.listings(model), "data_sets": data_sets, "alternatives": lists.alternatives(model)}
    yield File("src/devices/lists.rs", "devices/lists.rs.j2", listed)
    yield File("src/time/clocks.rs", "time/clocks.rs.j2", {"clocks": clocks.clocks(model)})
    for family in crate.families:
        yield File(f"src/sets/{family.name}.rs", "family.rs.j2", {"family": family}, family.of)


def keywords(model: m.Model) -> list[str]:
    """Returns the keywords for the registry, which allows five."""
    own = [word.lower().replace(" ", "-") for word in model.protocol.keywords]
    return list(dict.fromkeys([model.protocol.package.replace("_", "-"), *own[:2], "no-std", "protocol"]))


# --------------------------------------------------------------------------- identifiers


def identifiers(model: m.Model) -> Iterable[Identifier]:
    crate = model.derived(Crate)
    for fixed in names.crate_modules():
        yield Identifier("the crate", fixed, f"the module {fixed}", None)
    for fixed in names.features():
        yield Identifier("the features", fixed, f"the feature {fixed}", None, word=False)
    for function in model.protocol.functions:
        yield Identifier("protocol", names.call_type(function), f"the function {function.name}", function.position)
    for s in model.sets:
        yield Identifier("the descriptor sets", names.module(s.name).upper(), s.name, s.position)
    for family in model.families:
        yield from _family(family)
    for t in (model.protocol.function_selector, *model.all_types):
        yield from _type(crate, t)
    for f in model.fields:
        yield from _field(model, f)
        yield from _record(crate.record(f), f.full_name)
    for union in crate.unions:
        yield from _union(union)
    for clock in model.protocol.clocks:
        yield Identifier("the clocks", variant(clock.name), clock.name, clock.position)
    for d in model.devices:
        yield Identifier("devices", constant(d.name), d.name, d.position)


def _family(family: m.Family) -> Iterator[Identifier]:
    yield Identifier("the features", module(family.name), family.name, family.position, word=False)
    yield Identifier("the crate", module(family.name), family.name, family.position)
    for s in family.sets:
        if name := names.set_constant(s, family):
            yield Identifier(module(family.name), name, f"the set {s.name}", s.position)


def _field(model: m.Model, f: m.Field) -> Iterator[Identifier]:
    yield Identifier(module(f.family), type_name(f.name), f.full_name, f.position)
    yield Identifier("registry", type_name(f"{f.family}_{f.name}"), f.full_name, f.position)
    if len(f.responses) > 1:
        several = f"the responses of {f.full_name}"
        yield Identifier(module(f.family), names.response_type(f), several, f.position)
        for r in model.responses(f):
            yield Identifier(several, names.response_variant(r, f), r.name, f.position)


def _union(union: Union) -> Iterator[Identifier]:
    position = union.record.of.position
    where = f"{union.record.home}::{union.name}"
    what = f"the union {union.parameter.name} of {union.record.of.name}"
    yield Identifier(union.record.home, union.name, what, position)
    yield Identifier(where, "Other", "an unknown tag", position)
    for case in union.of.cases:
        yield Identifier(where, variant(case.tag.name), case.tag.name, position)


def _type(crate: Crate, t: m.Type) -> Iterator[Identifier]:
    where = f"{home(t)}::{type_name(t.name)}"
    yield Identifier(home(t), type_name(t.name), t.name, t.position)
    for name, part in part_names(t):
        yield Identifier(where, name, part.name, part.position or t.position)
    if isinstance(t, m.Vector):
        for e in t.elements:
            yield Identifier(where, member(e), e, None)
    if isinstance(t, m.Struct):
        yield from _record(crate.record(t), t.name)


def _record(record: Record, what: str) -> Iterator[Identifier]:
    for x in record.members:
        yield Identifier(what, x.name, x.parameter.name, x.parameter.position)
    for name in record.methods:
        yield Identifier(f"the methods of {what}", name, name, record.of.position)


TARGET = Target(
    title="Rust, no_std",
    files=files,
    filters={
        "comment": docs.comment,
        "decimal": literals.decimal,
        "hex": "0x{:02X}".format,
        "option": literals.option,
        "prose": docs.prose,
        "quoted": literals.quoted,
    },
    identifiers=identifiers,
    rename=package.in_source,
    grammar=names.GRAMMAR,
    conformance=("parse", "decode", "encode", "client"),
    program="cargo",
)
