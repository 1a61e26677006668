"""Python: a package that needs only the standard library."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from mipgen import model as m
from mipgen.emit import formatting, package
from mipgen.emit.target import File, Identifier, Target
from mipgen.facts import describe
from mipgen.lower import calls

from . import docs, info, members, names, needs, session, simulation, tables

PACKAGE = "mip_protocol"


def files(model: m.Model) -> Iterator[File]:
    quickstart = model.program("quickstart.py")
    if quickstart:
        yield File("quickstart.py", "verbatim.j2", {"text": quickstart})
    known = max(model.devices, key=lambda d: len(d.supports), default=None)
    shown = {
        "quickstart": quickstart.partition('"""\n\n')[2].rstrip(),
        "daily": model.program("daily.md").rstrip(),
        "client": model.program("client.py").rstrip(),
        "at_port": model.program("device.py").rstrip(),
        "at_port_aio": model.program("device_aio.py").rstrip(),
        "meaning": model.program("meaning.py").rstrip(),
        "device": known.id if known else "DEVICE",  # the device with the most fields
    }
    without = {"without": needs.left_out(model)}
    yield File("README.md", "README.md.j2", shown | without)
    yield File("pyproject.toml", "pyproject.toml.j2")
    yield File(f"{PACKAGE}/__init__.py", "__init__.py.j2", without)
    for name in ("_clocks", "_index", "_sets", "types", "protocol", "devices"):
        yield File(f"{PACKAGE}/{name}.py", f"{name}.py.j2")
    scalars = [(s, names.SCALARS[s.name]) for s in m.SCALARS.values()]
    yield File(f"{PACKAGE}/_scalars.py", "_scalars.py.j2", {"scalars": scalars})
    yield File(f"{PACKAGE}/_session.py", "_session.py.j2", {"session": session.of(model)})
    protocol = model.protocol
    yield _meaning("types", model.types)
    yield _meaning("protocol", [protocol.function_selector], [protocol.acknowledge])
    yield File(f"{PACKAGE}/simulation.json", "verbatim.j2", {"text": simulation.document(model)})
    for x in model.families:
        yield File(f"{PACKAGE}/{names.module(x.name)}.py", "set.py.j2", {"family": x}, x)
        yield _meaning(names.module(x.name), x.types, x.fields, x)


def _meaning(module: str, types: Sequence[m.Type], fields: Sequence[m.Field] = (), of: m.Family | None = None) -> File:
    """Returns the file with the facts about a module's types and fields."""
    known = {"module": module, "kinds": types, "fields": fields}
    return File(f"{PACKAGE}/_meaning/{module}.py", "meaning.py.j2", known, of)


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {
        # identifiers
        "module": names.module,
        "class": names.class_name,
        "constant": names.constant,
        "member": names.member,
        "element": names.element,
        "property": names.prop,
        "home": names.home,
        "qualified": names.qualified,
        "reference": names.reference,
        "hides_builtin": names.hides_builtin,
        # contents of objects
        "members": calls.members,
        "hint": members.hint,
        "held": members.held,
        "by_place": members.by_place,
        "initial": members.initial,
        "kept": members.kept,
        "vectors": members.vector_members,
        "layout": members.layout,
        "always": members.always,
        "columns": members.columns,
        "is_shared": members.is_shared,
        "sets": members.sets,
        "constructors": calls.constructors,
        "parameters": members.parameters,
        "arguments": members.arguments,
        "answered": members.answered,
        "expected": lambda f: members.expected(f, model),
        "answer": lambda way, f: members.answer(way.function, f, model),
        "answers": lambda f: members.answers(f, model),
        "silencers": lambda f: members.silencers(f, model),
        "matches": lambda f: members.matches(f, model),
        # docstrings and comments
        **docs.filters(model),
        "why": lambda e: describe.why(e, model),
        # tables
        "repr": repr,
        "code": "`{}`".format,
        "hex": "0x{:02X}".format,
        "digits": "{:02X}".format,
        "letters": m.letters,
        "by_descriptor": tables.by_descriptor,
        # for the description at run time
        "field_info": partial(info.of_field, model=model),
        "parameter_info": partial(info.of_parameter, model=model),
        "enum_info": info.of_enumeration,
        "bits_info": info.of_bitfield,
        "quoted": info.code,
        "every_field": info.fields,
        "called": info.called,
        "named": info.named,
    }


# --------------------------------------------------------------------------- identifiers


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for x in model.families:
        yield Identifier(PACKAGE, names.module(x.name), f"set {x.name}", x.position)
    yield from names.identifiers(model, attributes)
    for d in model.devices:
        yield Identifier(f"{PACKAGE}.devices", names.constant(d.name), f"device {d.id}", d.position)


def attributes(t: m.Type | m.Field) -> Iterator[tuple[str, str, m.Position | None]]:
    """Yields the names of a class's members in Python and in the specification."""
    if isinstance(t, m.Enum):
        for v in t.values:
            yield names.constant(v.name), v.name, v.position
    elif isinstance(t, m.Bitfield):
        for b in t.bits:
            yield names.constant(b.name), b.name, b.position
            if b.width > 1 and not b.alias:
                yield names.prop(b.name), b.name, b.position
                yield f"with_{b.name}", f"{b.name}, set to a number", b.position
    elif isinstance(t, (m.Field, m.Struct)):
        for p in calls.members(t):
            yield names.member(p.name), p.name, p.position
        for f in t.functions if isinstance(t, m.Field) else ():
            yield names.member(f.name), f"function {f.name}", None


TARGET = Target(
    title="Python >= 3.10, package mip_protocol",
    files=files,
    runtime=needs.runtime,
    filters=filters,
    identifiers=identifiers,
    rename=package.in_source,
    grammar=names.GRAMMAR,
    formatter=formatting.RUFF,
    conformance=("parse", "decode", "encode", "client", "live"),
)
